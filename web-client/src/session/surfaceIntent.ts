// What the user wants of a surface, and the setting of the server that comes nearest to it.
import type { SurfaceKind, SurfaceRecord, SurfaceSetting } from '../protocol/messages.ts';

export interface SurfaceIntent {
    kind: SurfaceKind;
    /** Time at which a stream surface's field is frozen, or a path surface is released. */
    from: number;
    /** Integration time; a path surface gets less where the data end. */
    length: number;
    separation: number;
}

export function intentOf(record: SurfaceRecord): SurfaceIntent {
    const { kind, from, to, separation } = record;
    return { kind, from, length: to - from, separation };
}

/** Null when a path surface would have no time left after its release. */
export function settingOf(
    intent: SurfaceIntent,
    record: SurfaceRecord,
    times: readonly number[],
    steady: boolean,
): SurfaceSetting | null {
    const lastTime = times[times.length - 1] ?? intent.from;
    let to = intent.from + intent.length;
    if (intent.kind === 'path' && !steady) to = Math.min(to, lastTime);
    if (!(to > intent.from)) return null;
    return {
        surface: record.surface,
        rake: record.rake,
        dataset: record.dataset,
        kind: intent.kind,
        from: intent.from,
        to,
        separation: intent.separation,
        direction: record.direction,
        accuracy: record.accuracy,
        maxQuads: record.maxQuads,
    };
}

/** Whether a record is what a setting asked for, so that it brings no news of other people. */
export function fulfils(record: SurfaceRecord, setting: SurfaceSetting): boolean {
    return (
        record.kind === setting.kind &&
        record.from === setting.from &&
        record.to === setting.to &&
        (setting.separation === undefined || record.separation === setting.separation)
    );
}
