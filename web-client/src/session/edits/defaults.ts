// The first rake and surface of an empty session: something to look at and to drag, in any domain.
import type { DatasetDescription, Vec3 } from '../../protocol/messages.ts';
import { niceStep } from '../../scene/base/ticks.ts';

export const defaultSeeds = 32;

type Axis = 0 | 1 | 2;
type Bounds = DatasetDescription['bounds'];

/**
 * A line across the domain, 10 % from the low end of its longest axis, along the shorter of the
 * other two, a little off the middle of the third: exactly on a line of symmetry a surface would
 * hit the stagnation point of a body in the middle and show nothing but that.
 */
export function defaultRake(bounds: Bounds): [Vec3, Vec3] {
    const longest = ([0, 1, 2] as Axis[]).reduce((a, b) => (extent(bounds, b) > extent(bounds, a) ? b : a));
    const others = ([2, 1, 0] as Axis[]).filter((axis) => axis !== longest) as [Axis, Axis];
    const [along, across] = extent(bounds, others[1]) < extent(bounds, others[0]) ? [others[1], others[0]] : others;
    const start: Vec3 = [0, 0, 0];
    start[longest] = at(bounds, longest, 0.1);
    start[across] = at(bounds, across, 0.53);
    start[along] = at(bounds, along, 0.05);
    const end: Vec3 = [...start];
    end[along] = at(bounds, along, 0.95);
    return [start, end];
}

/**
 * What a time surface's rake is swept along where no one has chosen: the axis that is most
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

/** An integration time in which the flow crosses most of the domain. */
export function defaultLength(bounds: Bounds, fastest: number): number {
    const longest = Math.max(...([0, 1, 2] as Axis[]).map((axis) => extent(bounds, axis)));
    if (!(fastest > 0)) return 1;
    const rough = (1.5 * longest) / fastest;
    const step = niceStep(rough / 20);
    return Math.max(step, Math.round(rough / step) * step);
}

/**
 * For a further rake: as the first one, moved across the flow, or along it, to where it is clear of those there are; where
 * nothing is clear, to where there is most room.
 */
export function freeRake(bounds: Bounds, others: readonly (readonly Vec3[])[]): [Vec3, Vec3] {
    const [start, end] = defaultRake(bounds);
    const sweep = defaultSweep(bounds, [start, end]);
    const across = sweep.findIndex((each) => each !== 0) as Axis;
    const longest = ([0, 1, 2] as Axis[]).reduce((a, b) => (extent(bounds, b) > extent(bounds, a) ? b : a));
    const size = Math.hypot(extent(bounds, 0), extent(bounds, 1), extent(bounds, 2));
    let best: [Vec3, Vec3] = [start, end];
    let most = -1;
    for (const along of [0.1, 0.3, 0.5]) {
        for (const beside of [0.53, 0.35, 0.7, 0.2, 0.85, 0.44, 0.62]) {
            const candidate = [start, end].map((point) => {
                const moved: Vec3 = [...point];
                moved[longest] = at(bounds, longest, along);
                if (across !== longest) moved[across] = at(bounds, across, beside);
                return moved;
            }) as [Vec3, Vec3];
            const room = Math.min(...others.map((points) => apart(candidate, points)));
            if (room > 0.05 * size) return candidate;
            if (room > most) [best, most] = [candidate, room];
        }
    }
    return best;
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

function extent(bounds: Bounds, axis: Axis): number {
    return (bounds[axis * 2 + 1] ?? 0) - (bounds[axis * 2] ?? 0);
}

function at(bounds: Bounds, axis: Axis, fraction: number): number {
    return (bounds[axis * 2] ?? 0) + fraction * extent(bounds, axis);
}
