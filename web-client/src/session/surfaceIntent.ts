// What the user wants of a surface, and the setting of the server that comes nearest to it.
import type {
    DatasetDescription,
    SurfaceKind,
    SurfaceRecord,
    SurfaceSetting,
    Vec3,
} from '../protocol/messages.ts';
import { defaultSweep } from './defaults.ts';

export interface SurfaceIntent {
    kind: SurfaceKind;
    /** Time at which a stream surface's field is frozen, or the (first) release of the others. */
    from: number;
    /** Integration time; all but stream surfaces get less where the data end. */
    length: number;
    separation: number;
    /** How long a streak surface is released for; null: until it is shown. */
    released: number | null;
    /** Where the patch of a time surface ends: the rake swept along this, or another rake. */
    sweep: Vec3 | null;
    rake2: string | null;
}

export function intentOf(record: SurfaceRecord): SurfaceIntent {
    const { kind, from, to, separation, releaseUntil, sweep = null, rake2 = null } = record;
    const released = releaseUntil === undefined ? null : releaseUntil - from;
    return { kind, from, length: to - from, separation, released, sweep, rake2 };
}

/** A time surface needs a second curve: where none was chosen, the rake is swept across the domain. */
export function withSecondCurve(
    intent: SurfaceIntent,
    bounds: DatasetDescription['bounds'],
    rake: readonly Vec3[],
): SurfaceIntent {
    if (intent.kind !== 'time' || intent.sweep !== null || intent.rake2 !== null) return intent;
    return { ...intent, sweep: defaultSweep(bounds, rake) };
}

/** Null when no time would be left after the release. */
export function settingOf(
    intent: SurfaceIntent,
    record: SurfaceRecord,
    times: readonly number[],
    steady: boolean,
): SurfaceSetting | null {
    const lastTime = times[times.length - 1] ?? intent.from;
    let to = intent.from + intent.length;
    if (intent.kind !== 'stream' && !steady) to = Math.min(to, lastTime);
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
        merge: record.merge,
        angle: record.angle,
        maxQuads: record.maxQuads,
        ...releaseOf(intent, to),
        ...secondCurveOf(intent),
    };
}

function releaseOf({ kind, from, released }: SurfaceIntent, to: number): Partial<SurfaceSetting> {
    if (kind !== 'streak' || released === null || from + released >= to) return {};
    return { releaseUntil: from + released };
}

function secondCurveOf({ kind, sweep, rake2 }: SurfaceIntent): Partial<SurfaceSetting> {
    if (kind !== 'time') return {};
    if (sweep !== null) return { sweep };
    return rake2 === null ? {} : { rake2 };
}

/** What makes a lost surface anew, on the rakes that have taken the place of its own. */
export function settingAnew(
    record: SurfaceRecord,
    rakes: ReadonlyMap<string, string>,
): SurfaceSetting | null {
    const { surface: _surface, rev: _rev, epoch: _epoch, fields: _fields, ...asked } = record;
    const rake = rakes.get(record.rake);
    if (rake === undefined) return null;
    if (record.rake2 === undefined) return { ...asked, rake };
    const rake2 = rakes.get(record.rake2);
    return rake2 === undefined ? null : { ...asked, rake, rake2 };
}

/** Whether a record is what a setting asked for, so that it brings no news of other people. */
export function fulfils(record: SurfaceRecord, setting: SurfaceSetting): boolean {
    return (
        record.kind === setting.kind &&
        record.from === setting.from &&
        record.to === setting.to &&
        record.releaseUntil === setting.releaseUntil &&
        record.rake2 === setting.rake2 &&
        String(record.sweep) === String(setting.sweep) &&
        (setting.separation === undefined || record.separation === setting.separation)
    );
}
