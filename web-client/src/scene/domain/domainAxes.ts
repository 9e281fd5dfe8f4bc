// Which edges of the domain box carry the numbers, chosen again for every view: for each axis one of
// the four parallel edges that lie on the outline of the box as seen, so that no number covers the
// inside. Pure geometry; domainOutline.ts draws.
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint, ScreenSize } from '../base/view.ts';

/** Half the height of a number or a name, and the least half of its width. */
const marginPx = 12;

export type Bounds = readonly [number, number, number, number, number, number];

export interface AxisEdge {
    axis: 0 | 1 | 2;
    /** The edge's low and high end. */
    from: Vec3;
    to: Vec3;
    /** Unit vector on the screen that points away from the box. */
    outward: ScreenPoint;
}

/**
 * @param project canvas position, null behind the camera
 * @param eye     position of the camera, far away without perspective
 */
export function labelledEdges(bounds: Bounds, eye: Vec3, project: (point: Vec3) => ScreenPoint | null): AxisEdge[] {
    const centre = project(centreOf(bounds));
    if (centre === null) return [];
    const edges: AxisEdge[] = [];
    for (const axis of [0, 1, 2] as const) {
        const candidates = silhouetteEdges(bounds, axis, eye);
        let best: AxisEdge | null = null;
        let bestScore = Number.NEGATIVE_INFINITY;
        for (const [from, to] of candidates) {
            const [a, b] = [project(from), project(to)];
            if (a === null || b === null) continue;
            const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
            const outward = awayFrom(a, b, centre, middle);
            // Lower is better, and for upright edges further left: where axes are looked for.
            const score = middle.y - 0.6 * middle.x;
            if (score <= bestScore) continue;
            bestScore = score;
            best = { axis, from, to, outward };
        }
        if (best !== null) edges.push(best);
    }
    return edges;
}

export function centreOf(bounds: Bounds): Vec3 {
    return [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2];
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

/** Edges along `axis` between a face turned to the eye and one turned away. */
function silhouetteEdges(bounds: Bounds, axis: 0 | 1 | 2, eye: Vec3): [Vec3, Vec3][] {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3] as [0 | 1 | 2, 0 | 1 | 2];
    const found: [Vec3, Vec3][] = [];
    for (const uSide of [0, 1] as const) {
        for (const vSide of [0, 1] as const) {
            if (faces(bounds, u, uSide, eye) === faces(bounds, v, vSide, eye)) continue;
            const from: Vec3 = [0, 0, 0];
            from[axis] = bounds[axis * 2] ?? 0;
            from[u] = bounds[u * 2 + uSide] ?? 0;
            from[v] = bounds[v * 2 + vSide] ?? 0;
            const to: Vec3 = [...from];
            to[axis] = bounds[axis * 2 + 1] ?? 0;
            found.push([from, to]);
        }
    }
    return found;
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
