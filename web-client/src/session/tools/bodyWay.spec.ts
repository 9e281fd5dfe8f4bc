import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { distance } from '../../scene/rake/rakeShape.ts';
import { outlineOf, simplified, standOff, type Triangles, wayAlong } from './bodyWay.ts';

/** Corners of quads, each with vertices of its own. */
function quads(...all: Vec3[][]): Triangles {
    const indices = all.flatMap((_, i) => [0, 1, 2, 0, 2, 3].map((k) => 4 * i + k));
    return { positions: all.flat(2), indices };
}

/** From 0 to 1 in each direction, without a bottom; one side is turned the other way. */
const box = quads(
    [
        [0, 0, 1],
        [1, 0, 1],
        [1, 1, 1],
        [0, 1, 1],
    ],
    [
        [1, 0, 0],
        [1, 0, 1],
        [1, 1, 1],
        [1, 1, 0],
    ],
    [
        [0, 0, 0],
        [0, 0, 1],
        [0, 1, 1],
        [0, 1, 0],
    ],
    [
        [0, 0, 0],
        [1, 0, 0],
        [1, 0, 1],
        [0, 0, 1],
    ],
    [
        [0, 1, 0],
        [1, 1, 0],
        [1, 1, 1],
        [0, 1, 1],
    ],
);

describe('a way along a body', () => {
    it('goes over an edge, and stands off it as far as off its sides', () => {
        const way = wayAlong(box, [0.25, 0.4, 1], [1, 0.4, 0.5], [5, 0.4, 5], [0, 0, 1])!;
        const places = standOff(way, 0.1);
        expect(places[0]).toEqual([0.25, 0.4, 1.1]);
        places.at(-1)!.forEach((each, k) => expect(each).toBeCloseTo([1.1, 0.4, 0.5][k]!, 12));
        for (const [x, y, z] of places) {
            expect(y).toBeCloseTo(0.4, 12);
            expect(Math.max(x - 1, z - 1)).toBeGreaterThan(0.1 / Math.SQRT2 - 1e-9);
        }
        const inside = standOff(wayAlong(box, [0.25, 0.4, 1], [1, 0.4, 0.5], [5, 0.4, 5], [0, 0, -1])!, 0.1);
        for (const [x, , z] of inside) expect(Math.max(x, z)).toBeCloseTo(0.9, 12);
    });

    it('is the shorter one round it, and none where a border lies between or there is no body', () => {
        const over = wayAlong(box, [0, 0.4, 0.9], [1, 0.4, 0.9], [0.5, 0.4, 5], [-1, 0, 0])!;
        expect(Math.max(...over.map(({ point }) => point[2]))).toBe(1);
        const apart = quads(
            [
                [0, 0, 0],
                [1, 0, 0],
                [1, 1, 0],
                [0, 1, 0],
            ],
            [
                [2, 0, 0],
                [3, 0, 0],
                [3, 1, 0],
                [2, 1, 0],
            ],
        );
        expect(wayAlong(apart, [0.5, 0.5, 0], [2.5, 0.5, 0], [1, 0.5, 5], [0, 0, 1])).toBeNull();
        expect(wayAlong(box, [0.25, 0.4, 1], [9, 0.4, 0.5], [5, 0.4, 5], [0, 0, 1])).toBeNull();
    });

    it('keeps the points that it needs', () => {
        const arc = Array.from({ length: 1000 }, (_, i): Vec3 => [Math.cos(i / 500), Math.sin(i / 500), 0]);
        const kept = simplified(arc, 1e-3, 100);
        expect(kept.length).toBeLessThan(40);
        expect(kept.at(-1)).toEqual(arc.at(-1));
        expect(simplified(arc, 1e-9, 10).length).toBeLessThanOrEqual(10);
    });
});

describe('the outline of a patch', () => {
    it('is closed, off the patch and into it', () => {
        const { positions } = box;
        const way = outlineOf({ positions, indices: Array.from(box.indices).slice(0, 6) }, () => [0, 0, 1], true)!;
        expect(way).toHaveLength(5);
        for (const [x, y, z] of standOff(way, 0.1)) {
            expect(z).toBeCloseTo(1.1, 12);
            expect(Math.max(Math.abs(x - 0.5), Math.abs(y - 0.5))).toBeCloseTo(0.4, 12);
        }
        expect(way.every(({ point }, i) => i === 0 || distance(point, way[i - 1]!.point) === 1)).toBe(true);
    });

    it('of what is closed there is none', () => {
        const corners: Vec3[] = [
            [0, 0, 0],
            [1, 0, 0],
            [0, 1, 0],
            [0, 0, 1],
        ];
        const closed = { positions: corners.flat(), indices: [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3] };
        expect(outlineOf(closed, () => [0, 0, 1], false)).toBeNull();
    });
});
