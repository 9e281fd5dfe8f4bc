// What dragging does to the points of a rake.
import type { Vec3 } from '../../protocol/messages.ts';

/** All points moved by the same amount, so that the rake keeps its shape. */
export function translate(points: readonly Vec3[], by: Vec3): Vec3[] {
    return points.map(([x, y, z]) => [x + by[0], y + by[1], z + by[2]]);
}

export function difference(a: Vec3, b: Vec3): Vec3 {
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

/** The middle between the first and the last point: where the handle that moves all of them sits. */
export function middleOf(points: readonly Vec3[]): Vec3 {
    const first = points[0] ?? [0, 0, 0];
    const last = points[points.length - 1] ?? first;
    return [(first[0] + last[0]) / 2, (first[1] + last[1]) / 2, (first[2] + last[2]) / 2];
}
