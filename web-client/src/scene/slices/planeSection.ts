// Where a plane cuts the box of the domain. Twin of the polygon: core/surface/slice/plane_window.hpp.
import type { Vec3 } from '../../protocol/messages.ts';
import { cross, dot, minus, plus, times, unit } from '../rake/rakeShape.ts';

export type Box = readonly number[];

/** The places along a direction between which planes across it meet a box. */
export function spanAcross(box: Box, direction: Vec3): [number, number] {
    const ends = ([0, 1, 2] as const).map((k) => [box[2 * k]! * direction[k], box[2 * k + 1]! * direction[k]]);
    const [low, high] = [Math.min, Math.max].map((end) => ends.reduce((sum, pair) => sum + end(pair[0]!, pair[1]!), 0));
    return [low!, high!];
}

/** The corners of the polygon in which a plane cuts a box, in order round it; none where it misses the box. */
export function planeSection(box: Box, origin: Vec3, normal: Vec3): Vec3[] {
    const corners = Array.from({ length: 8 }, (_, i): Vec3 => [box[i & 1]!, box[2 + ((i >> 1) & 1)]!, box[4 + ((i >> 2) & 1)]!]);
    const heights = corners.map((corner) => dot(minus(corner, origin), normal));
    const points: Vec3[] = [];
    for (let a = 0; a < 8; ++a) {
        for (const bit of [1, 2, 4]) {
            const b = a | bit;
            if (b === a) continue;
            const [from, to] = [heights[a]!, heights[b]!];
            // A corner on the plane counts once for each of its edges that end there: the polygon stays the same.
            if (from === to || from * to > 0) continue;
            points.push(plus(corners[a]!, times(minus(corners[b]!, corners[a]!), from / (from - to))));
        }
    }
    if (points.length < 3) return [];
    const middle = meanOf(points);
    const u = unit(minus(points[0]!, middle));
    const v = cross(unit(normal), u);
    const angle = (point: Vec3): number => Math.atan2(dot(minus(point, middle), v), dot(minus(point, middle), u));
    return points.sort((p, q) => angle(p) - angle(q));
}

/** The middle of a polygon, by area; of a convex one it is inside. */
export function centroid(polygon: readonly Vec3[]): Vec3 {
    const [first] = polygon;
    if (first === undefined) return [0, 0, 0];
    let sum: Vec3 = [0, 0, 0];
    let area = 0;
    for (let i = 1; i + 1 < polygon.length; ++i) {
        const [a, b] = [minus(polygon[i]!, first), minus(polygon[i + 1]!, first)];
        const part = Math.hypot(...cross(a, b));
        sum = plus(sum, times(plus(a, b), part / 3));
        area += part;
    }
    return area > 0 ? plus(first, times(sum, 1 / area)) : meanOf(polygon);
}

function meanOf(points: readonly Vec3[]): Vec3 {
    return times(points.reduce(plus, [0, 0, 0]), 1 / points.length);
}
