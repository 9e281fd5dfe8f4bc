// What is taken where no user has chosen: where further rakes and copies go, what a rake is swept along, and the field and value that a
// level surface begins with. The first rake and surface are the server's suggestion.
import type { DatasetDescription, Vec3 } from '../../protocol/messages.ts';

type Axis = 0 | 1 | 2;
type Bounds = DatasetDescription['bounds'];

/**
 * Returns what a time surface's rake is swept along where no user has chosen: the axis that is most
 * perpendicular to the rake, across the flow rather than along it (along the longest side), to
 * where there is more room, a quarter of the longest side but not out of the domain.
 */
export function defaultSweep(bounds: Bounds, rake: readonly Vec3[]): Vec3 {
    const [first = [0, 0, 0], last = [0, 0, 0]] = [rake[0], rake[rake.length - 1]];
    const axes = ([0, 1, 2] as Axis[]).sort(
        (a, b) => Math.abs(last[a] - first[a]) - Math.abs(last[b] - first[b]) || extent(bounds, a) - extent(bounds, b),
    );
    const axis = axes[0] ?? 0;
    const below = Math.min(...rake.map((point) => point[axis])) - (bounds[axis * 2] ?? 0);
    const above = (bounds[axis * 2 + 1] ?? 0) - Math.max(...rake.map((point) => point[axis]));
    const longest = Math.max(...axes.map((each) => extent(bounds, each)));
    const length = Math.min(0.25 * longest, 0.95 * Math.max(below, above));
    const sweep: Vec3 = [0, 0, 0];
    sweep[axis] = Number((above >= below ? length : -length).toPrecision(3));
    return sweep;
}

/**
 * For a further rake: half as long as the first one that the server suggests, so that it is no wall before
 * all the rest, and beside it across the flow, as near as it is clear of those there are; where nothing is
 * clear, to where there is most room.
 */
export function freeRake(bounds: Bounds, first: readonly Vec3[], others: readonly (readonly Vec3[])[]): [Vec3, Vec3] {
    const start: Vec3 = first[0] ?? [0, 0, 0];
    const end: Vec3 = first.at(-1) ?? start;
    if (others.length === 0) return [start, end];
    const half = [start, end].map((point, i) => {
        const other = i === 0 ? end : start;
        return point.map((value, k) => 0.75 * value + 0.25 * other[k]!) as Vec3;
    });
    const along = longestOf([0, 1, 2], (axis) => Math.abs(end[axis] - start[axis]));
    const sweep = defaultSweep(bounds, [start, end]);
    const across = sweep.findIndex((each) => each !== 0) as Axis;
    const third = ([0, 1, 2] as Axis[]).find((axis) => axis !== along && axis !== across) ?? across;
    const size = Math.hypot(extent(bounds, 0), extent(bounds, 1), extent(bounds, 2));
    let best = half as [Vec3, Vec3];
    let most = -1;
    for (const further of [0, 0.15, 0.3]) {
        for (const beside of offsets(Math.sign(sweep[across]))) {
            const candidate = half.map((point) => {
                const moved: Vec3 = [...point];
                moved[third] += further * extent(bounds, third);
                if (across !== third) moved[across] += beside * extent(bounds, across);
                return moved;
            }) as [Vec3, Vec3];
            if (!candidate.every((point) => isWithin(bounds, point))) continue;
            const room = Math.min(...others.map((points) => apart(candidate, points)));
            if (room > 0.05 * size) return candidate;
            if (room > most) [best, most] = [candidate, room];
        }
    }
    return best;
}

/** Parts of an extent, nearest first, and of two that are as near first to the side that has more room. */
function offsets(side: number): number[] {
    return [0.12, 0.18, 0.24, 0.3, 0.36, 0.42, 0.48].flatMap((each) => [side * each, -side * each]);
}

function isWithin(bounds: Bounds, point: Vec3): boolean {
    return point.every((value, k) => value > bounds[2 * k]! && value < bounds[2 * k + 1]!);
}

/** Where a copy of a rake goes: a little to the side that has more room. */
export function besideRake(bounds: Bounds, rake: readonly Vec3[]): Vec3 {
    const [x, y, z] = defaultSweep(bounds, rake);
    return [x * 0.25, y * 0.25, z * 0.25];
}

/** The smallest distance between the points of two rakes, and of their middles. */
function apart(a: readonly Vec3[], b: readonly Vec3[]): number {
    const [own, other] = [withMiddle(a), withMiddle(b)];
    let least = Number.POSITIVE_INFINITY;
    for (const p of own) {
        for (const q of other) least = Math.min(least, Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
    return least;
}

function withMiddle(points: readonly Vec3[]): Vec3[] {
    const [first = [0, 0, 0], last = first] = [points[0], points.at(-1)];
    const middle = first.map((each, k) => (each + (last[k] ?? each)) / 2) as Vec3;
    return [first, middle, last];
}

function longestOf(axes: readonly Axis[], length: (axis: Axis) => number): Axis {
    return axes.reduce((a, b) => (length(b) > length(a) ? b : a));
}

function extent(bounds: Bounds, axis: Axis): number {
    return (bounds[axis * 2 + 1] ?? 0) - (bounds[axis * 2] ?? 0);
}

type Level = { field: string; level: number };

/** What surfaces have, and not the data. */
const ofSurfaces = [
    ...['deformation', 'approximated', 'error', 'interval_error', 'twin_distance', 'twin_lag'],
    ...['normal_x', 'normal_y', 'normal_z'],
];

export function levelFields({ surfaceFields, fields }: DatasetDescription): string[] {
    const stored = (name: string): boolean => fields.some((field) => field.name === name);
    return surfaceFields.filter((name) => stored(name) || !ofSurfaces.includes(name));
}

/** Over all that has been read; null: not known of what is derived. Of the velocity its magnitude's. */
export function describedRange({ fields }: DatasetDescription, name: string): readonly [number, number] | null {
    const [low = null, high = null] = fields.find((field) => field.name === name)?.range ?? [];
    return low !== null && high !== null && low < high ? [low, high] : null;
}

/** Returns the middle of the field's range. Where that is not known, of vortices and vorticity what a turn within a tenth of the domain at the
 *  highest speed has, so that cores are seen; else zero: such fields have both signs, or say what they range over. */
export function levelOf(dataset: DatasetDescription, field: string): Level {
    const range = describedRange(dataset, field);
    if (range !== null) return { field, level: Number(((range[0] + range[1]) / 2).toPrecision(4)) };
    const [, speed = 0] = describedRange(dataset, dataset.velocity) ?? [];
    const size = Math.hypot(...([0, 1, 2] as Axis[]).map((axis) => extent(dataset.bounds, axis)));
    const rate = size > 0 ? speed / (0.1 * size) : 0;
    const level = field === 'q_criterion' ? rate ** 2 : field === 'vorticity' ? rate : 0;
    return { field, level: Number(level.toPrecision(2)) };
}

/** Returns a level of the first stored scalar that says more than where the body is; else of the speed. */
export function firstLevel(dataset: DatasetDescription): Level {
    const scalar = dataset.fields.find(
        ({ name, components }) =>
            components === 1 && name !== 'mask' && dataset.surfaceFields.includes(name) && describedRange(dataset, name) !== null,
    );
    return levelOf(dataset, scalar?.name ?? dataset.velocity);
}

/** Returns a level of the first field that is not used; where all are, another one of the first, so that both are seen. */
export function freeLevel(dataset: DatasetDescription, used: ReadonlySet<string | undefined>): Level {
    const first = firstLevel(dataset);
    const free = [first.field, ...levelFields(dataset)].find(
        (name) => !used.has(name) && name !== 'mask' && describedRange(dataset, name) !== null,
    );
    if (free !== undefined) return levelOf(dataset, free);
    const high = describedRange(dataset, first.field)?.[1] ?? first.level;
    return used.has(first.field) ? { ...first, level: Number(((first.level + high) / 2).toPrecision(4)) } : first;
}
