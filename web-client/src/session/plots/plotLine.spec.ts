import { expect, it } from 'vitest';
import { pointsAlong } from './plotLine.ts';

it('points lie evenly along a bent curve, from one end to the other', () => {
    const { points, distances } = pointsAlong(
        [
            [0, 0, 0],
            [3, 0, 0],
            [3, 4, 0],
        ],
        8,
    );
    expect(distances).toEqual([0, 1, 2, 3, 4, 5, 6, 7]);
    expect(points.slice(2, 5)).toEqual([
        [2, 0, 0],
        [3, 0, 0],
        [3, 1, 0],
    ]);
    expect(points.at(-1)).toEqual([3, 4, 0]);
});

it('a point, or nothing, is no line', () => {
    for (const curve of [[], [[1, 2, 3] as const], [[1, 2, 3] as const, [1, 2, 3] as const]]) {
        expect(pointsAlong(curve as [number, number, number][], 5)).toEqual({ points: [], distances: [] });
    }
});
