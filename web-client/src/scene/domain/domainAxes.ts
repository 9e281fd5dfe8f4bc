// Which edges of the domain box carry the numbers, chosen again for every view: for each axis one of the four parallel edges of which
// something is seen, on the outline of the box where there is one, so that no number covers the inside. Pure geometry; domainOutline.ts
// draws.
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint, ScreenSize } from '../base/view.ts';

/** Half the height of a number or a name, and the least half of its width. */
const marginPx = 12;

export type Bounds = readonly [number, number, number, number, number, number];

export interface AxisEdge {
    axis: 0 | 1 | 2;
    /** The low and the high end of what is seen of it. */
    from: Vec3;
    to: Vec3;
    /** Unit vector on the screen that points away from the box. */
    outward: ScreenPoint;
}

/** An edge of which less is seen has no room for numbers. */
const leastSeenPx = 60;

/**
 * Of each edge the part that is seen. For each axis all of which any is, the best first: on the outline of the box, if enough of it is
 * seen, and where axes are looked for.
 * @param project canvas position, null behind the camera
 * @param eye     position of the camera, far away without perspective
 */
export function labelledEdges(
    bounds: Bounds,
    eye: Vec3,
    project: (point: Vec3) => ScreenPoint | null,
    size: ScreenSize,
): AxisEdge[][] {
    const centre = project(centreOf(bounds)) ?? { x: size.width / 2, y: size.height / 2 };
    return ([0, 1, 2] as const).map((axis) => {
        const edges = parallelEdges(bounds, axis, eye).flatMap(({ ends, outline }) => {
            const seen = seenPart(ends, project, size);
            if (seen === null) return [];
            const { from, to, a, b } = seen;
            const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
            const outward = awayFrom(a, b, centre, middle);
            const room = Math.hypot(b.x - a.x, b.y - a.y) >= leastSeenPx;
            // Lower is better, and for upright edges further left.
            const score = middle.y - 0.6 * middle.x + (outline && room ? 2e5 : room ? 1e5 : 0);
            return [{ edge: { axis, from, to, outward }, score }];
        });
        return edges.sort((one, other) => other.score - one.score).map(({ edge }) => edge);
    });
}

/** Returns the part of a straight line that is seen, its ends in space and in the picture; null: none of it is. */
export function seenPart(
    [from, to]: readonly [Vec3, Vec3],
    project: (point: Vec3) => ScreenPoint | null,
    { width, height }: ScreenSize,
): { from: Vec3; to: Vec3; a: ScreenPoint; b: ScreenPoint } | null {
    const at = (t: number): Vec3 => from.map((each, k) => (t === 1 ? to[k]! : each + t * (to[k]! - each))) as unknown as Vec3;
    const behind = (t: number): boolean => project(at(t)) === null;
    if (behind(0) && behind(1)) return null;
    // Before the camera.
    const start = behind(0) ? bisected(0, 1, behind) : 0;
    const end = behind(1) ? bisected(1, 0, behind) : 1;
    const [a, b] = [project(at(start)), project(at(end))];
    if (a === null || b === null) return null;
    const [across, down] = [b.x - a.x, b.y - a.y];
    // Liang and Barsky's clipping, as shares of the way in the picture.
    let [low, high] = [0, 1];
    for (const [way, room] of [
        [-across, a.x],
        [across, width - a.x],
        [-down, a.y],
        [down, height - a.y],
    ] as const) {
        if (way === 0 && room < 0) return null;
        if (way < 0) low = Math.max(low, room / way);
        if (way > 0) high = Math.min(high, room / way);
    }
    if (low >= high) return null;
    const length = Math.hypot(across, down);
    // With perspective a share of the way in the picture is another in space.
    const reached = (t: number): number => {
        const p = project(at(t)) ?? a;
        return Math.hypot(p.x - a.x, p.y - a.y) / length;
    };
    const first = low === 0 ? start : bisected(start, end, (t) => reached(t) < low);
    const last = high === 1 ? end : bisected(end, start, (t) => reached(t) > high);
    return {
        ...{ from: at(first), to: at(last) },
        ...{ a: { x: a.x + low * across, y: a.y + low * down }, b: { x: a.x + high * across, y: a.y + high * down } },
    };
}

/** Returns where it is no longer `outside`, on the way from one that is to one that is not. */
function bisected(outside: number, inside: number, isOutside: (t: number) => boolean): number {
    for (let i = 0; i < 48; ++i) {
        const middle = (outside + inside) / 2;
        if (isOutside(middle)) outside = middle;
        else inside = middle;
    }
    return inside;
}

export function centreOf(bounds: Bounds): Vec3 {
    return [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2];
}

/** REQUIRES: there is one. */
export function boundsRound(all: readonly Bounds[]): Bounds {
    const end = (k: number): number => (k % 2 === 0 ? Math.min : Math.max)(...all.map((each) => each[k]!));
    return [end(0), end(1), end(2), end(3), end(4), end(5)];
}

/** The ends of the twelve edges of the box, about its centre, so that float32 holds them wherever the box
 *  is. */
export function boxEdges(bounds: Bounds): Float32Array {
    const ends: number[] = [];
    const halves = [0, 1, 2].map((axis) => (bounds[2 * axis + 1]! - bounds[2 * axis]!) / 2);
    for (let corner = 0; corner < 8; ++corner) {
        for (let axis = 0; axis < 3; ++axis) {
            if ((corner >> axis) % 2 === 1) continue;
            for (const end of [corner, corner | (1 << axis)]) {
                ends.push(...halves.map((half, each) => ((end >> each) % 2 === 1 ? half : -half)));
            }
        }
    }
    return new Float32Array(ends);
}

/** Returns, of the edges of boxEdges, those between two faces that are turned to the eye: what is in the box
 *  is behind them. */
export function edgesBeforeBox(bounds: Bounds, eye: Vec3): boolean[] {
    const before: boolean[] = [];
    for (let corner = 0; corner < 8; ++corner) {
        for (const axis of [0, 1, 2] as const) {
            if ((corner >> axis) % 2 === 1) continue;
            const others = ([0, 1, 2] as const).filter((each) => each !== axis);
            before.push(others.every((each) => faces(bounds, each, ((corner >> each) & 1) as 0 | 1, eye)));
        }
    }
    return before;
}

/**
 * Words of a place in the picture do not stand outside it: an axis near the border would lose its name.
 * @param halfWidth  of the words, in pixels
 */
export function clampedToPicture(
    words: ScreenPoint,
    { x, y }: ScreenPoint,
    { width, height }: ScreenSize,
    halfWidth = 0,
): ScreenPoint {
    if (x < 0 || x > width || y < 0 || y > height) return words;
    const within = (value: number, size: number, margin: number): number => Math.min(size - margin, Math.max(margin, value));
    return { x: within(words.x, width, Math.max(marginPx, halfWidth)), y: within(words.y, height, marginPx) };
}

/** The four edges along `axis`; those between a face turned to the eye and one turned away are on the outline of the box. */
function parallelEdges(bounds: Bounds, axis: 0 | 1 | 2, eye: Vec3): { ends: [Vec3, Vec3]; outline: boolean }[] {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3] as [0 | 1 | 2, 0 | 1 | 2];
    return ([0, 1] as const).flatMap((uSide) =>
        ([0, 1] as const).map((vSide) => {
            const from: Vec3 = [0, 0, 0];
            from[axis] = bounds[axis * 2] ?? 0;
            from[u] = bounds[u * 2 + uSide] ?? 0;
            from[v] = bounds[v * 2 + vSide] ?? 0;
            const to: Vec3 = [...from];
            to[axis] = bounds[axis * 2 + 1] ?? 0;
            return { ends: [from, to], outline: faces(bounds, u, uSide, eye) !== faces(bounds, v, vSide, eye) };
        }),
    );
}

function faces(bounds: Bounds, axis: 0 | 1 | 2, side: 0 | 1, eye: Vec3): boolean {
    const plane = bounds[axis * 2 + side] ?? 0;
    return side === 1 ? eye[axis] > plane : eye[axis] < plane;
}

function awayFrom(a: ScreenPoint, b: ScreenPoint, centre: ScreenPoint, middle: ScreenPoint): ScreenPoint {
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    let normal = { x: middle.x - centre.x, y: middle.y - centre.y };
    if (length > 1) normal = { x: -(b.y - a.y) / length, y: (b.x - a.x) / length };
    const outside = normal.x * (middle.x - centre.x) + normal.y * (middle.y - centre.y) >= 0;
    const size = (outside ? 1 : -1) * Math.max(Math.hypot(normal.x, normal.y), 1e-9);
    return { x: normal.x / size, y: normal.y / size };
}
