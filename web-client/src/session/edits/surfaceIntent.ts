// What the user wants of a surface, and the setting of the server that comes nearest to it.
import type {
    Accuracy,
    DatasetDescription,
    Direction,
    Between,
    Interpolation,
    Refine,
    SurfaceKind,
    SurfaceRecord,
    SurfaceSetting,
    Vec3,
} from '../../protocol/messages.ts';
import { surfaceAskedNames, surfaceSetOnlyFor } from '../../protocol/generated/surface.ts';
import { defaultSweep } from './defaults.ts';
import { endOf, followed } from './surfaceTimes.ts';

export interface SurfaceIntent {
    kind: SurfaceKind;
    /** Time at which a stream surface's field is frozen, or the (first) release of the others. */
    from: number;
    /** Integration time; all but stream surfaces get less where the data end. Both ways, of each. */
    length: number;
    separation: number;
    maxQuads: number;
    merge: number;
    angle: number;
    direction: Direction;
    accuracy: Accuracy;
    interpolation: Interpolation;
    /** How stored velocity goes from one stored time to the next. */
    between: Between;
    /** Off: a grid that stays as the rake begins it. */
    refine: Refine;
    /** What is carried along for colouring, beside the speed. */
    fields: readonly string[];
    /** How long a streak surface is released for; null: until it is shown. */
    released: number | null;
    /** How old a particle gets; null: as old as it may. */
    life: number | null;
    /** Where the patch of a time surface ends: the rake swept along this, or another rake. */
    sweep: Vec3 | null;
    rake2: string | null;
    /** What a level surface is a level set of, and where. */
    field: string | null;
    level: number | null;
}

export function intentOf(record: SurfaceRecord): SurfaceIntent {
    const { kind, from, to, separation, direction, accuracy, interpolation, between, refine, fields } = record;
    const { maxQuads, merge, angle } = record;
    const { releaseUntil, life = null, sweep = null, rake2 = null, field = null, level = null } = record;
    const released = releaseUntil === undefined ? null : Math.abs(releaseUntil - from);
    const length = Math.abs(to - from);
    const mesh = { separation, refine, maxQuads, merge, angle };
    const curves = { sweep, rake2, field, level };
    return { kind, from, length, ...mesh, direction, accuracy, interpolation, between, fields, released, life, ...curves };
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
    const { kind, from, direction, accuracy, interpolation, between, fields } = intent;
    const { separation, refine, maxQuads, merge, angle } = intent;
    if (kind === 'level') return levelSetting(intent, record, times);
    if (!(followed(intent, times, steady) > 0)) return null;
    const to = endOf(intent, times, steady);
    const shown = { from, to, releaseUntil: releaseEnd(intent, to - from), life: intent.life ?? undefined };
    const field = { accuracy, interpolation, between, fields: [...fields] };
    const mesh = { separation, refine, maxQuads, merge, angle };
    const wanted = { kind, ...mesh, direction, ...field, ...shown, ...secondCurve(intent) };
    return { ...recordSetting({ ...record, ...wanted }), surface: record.surface };
}

/** It has nothing to follow: it is shown at all times that there are. */
function levelSetting(intent: SurfaceIntent, record: SurfaceRecord, times: readonly number[]): SurfaceSetting | null {
    const { kind, field, level, maxQuads } = intent;
    if (field === null || level === null) return null;
    const [from, to] = [times[0] ?? 0, times.at(-1) ?? 0];
    const wanted = { kind, field, level, maxQuads, from, to, direction: 'forward' as const, fields: [...intent.fields] };
    return { ...recordSetting({ ...record, ...wanted }), surface: record.surface };
}

/** Returns what of a record its setter asks for, and surfaces of its kind take. */
function recordSetting(record: SurfaceRecord): SurfaceSetting {
    const takenBy: Partial<Record<string, readonly SurfaceKind[]>> = surfaceSetOnlyFor;
    const names = surfaceAskedNames.filter(
        (name) => record[name] !== undefined && takenBy[name]?.includes(record.kind) !== false,
    );
    return Object.fromEntries(names.map((name) => [name, record[name]])) as unknown as SurfaceSetting;
}

/** @param duration negative where time runs backward */
function releaseEnd({ from, released }: SurfaceIntent, duration: number): number | undefined {
    return released === null || released >= Math.abs(duration) ? undefined : from + Math.sign(duration) * released;
}

/** One at most: where the rake is swept, no other ends the patch. */
function secondCurve({ sweep, rake2 }: SurfaceIntent): Pick<SurfaceRecord, 'sweep' | 'rake2'> {
    return { sweep: sweep ?? undefined, rake2: sweep === null ? (rake2 ?? undefined) : undefined };
}

/** Returns what makes a lost surface anew, on the rakes that have taken the place of its own. */
export function settingForRecovery(record: SurfaceRecord, rakes: ReadonlyMap<string, string>): SurfaceSetting | null {
    // A link may have anything else in it, which is not the server's to hear.
    const { rake2: second, rake: first, ...setting } = recordSetting(record);
    if (record.kind === 'level') return setting;
    const rake = rakes.get(first ?? '');
    if (rake === undefined) return null;
    if (second === undefined) return { ...setting, rake };
    const rake2 = rakes.get(second);
    return rake2 === undefined ? null : { ...setting, rake, rake2 };
}

/** Returns whether a record is what a setting asked for, so that it brings no news of other people. */
export function fulfils(record: SurfaceRecord, setting: SurfaceSetting): boolean {
    return surfaceAskedNames.every((name) => JSON.stringify(record[name]) === JSON.stringify(setting[name]));
}
