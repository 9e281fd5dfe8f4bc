// Points along a curve, evenly by its length.
import type { Vec3 } from '../../protocol/messages.ts';

export interface PointsAlong {
    points: Vec3[];
    /** From the beginning of the curve to each. */
    distances: number[];
}

/** From one end to the other. Empty for less than two points, or where all are one. */
export function pointsAlong(curve: readonly Vec3[], count: number): PointsAlong {
    const ends = [0];
    for (let i = 1; i < curve.length; ++i) ends.push(ends[i - 1]! + distance(curve[i - 1]!, curve[i]!));
    const length = ends.at(-1)!;
    if (curve.length < 2 || !(length > 0)) return { points: [], distances: [] };
    let piece = 1;
    const distances = Array.from({ length: count }, (_, i) => (i + 1 === count ? length : (length * i) / (count - 1)));
    const points = distances.map((at): Vec3 => {
        while (piece + 1 < curve.length && ends[piece]! < at) ++piece;
        const [a, b] = [curve[piece - 1]!, curve[piece]!];
        const part = Math.min(1, (at - ends[piece - 1]!) / (ends[piece]! - ends[piece - 1]! || 1));
        return [0, 1, 2].map((k) => a[k]! + part * (b[k]! - a[k]!)) as Vec3;
    });
    return { points, distances };
}

function distance(a: Vec3, b: Vec3): number {
    return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}
