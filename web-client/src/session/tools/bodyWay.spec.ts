import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { distance } from '../../scene/rake/rakeShape.ts';
import type { Triangles } from './bodyEdges.ts';
import { liesOn, outlineOf, simplified, standOff, wayAlong, type WayPoint } from './bodyWay.ts';

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
        for (const within of [1e-9, 0]) expect(simplified(arc, within, 10).length).toBeLessThanOrEqual(10);
    });

    it('begins where something of the body lies', () => {
        expect([0.5, 0.4999, 0.4].map((x) => liesOn(box, [x, 0.4, 1], [2, 0.5, 9]))).toEqual([true, true, true]);
        expect(liesOn(box, [0.5, 0.4, 1.1], [2, 0.5, 9])).toBe(false);
        expect(liesOn({ ...box, indices: [] }, [0.5, 0.4, 1], [2, 0.5, 9])).toBe(false);
    });
});

describe('the outline of a patch', () => {
    const { positions } = box;
    const found = (body: Triangles, inward = false): WayPoint[] => {
        const way = outlineOf(body, () => [0, 0, 1], inward);
        if (typeof way === 'string') throw new Error(way);
        return way;
    };

    it.each([
        ['alike', [0, 1, 2, 0, 2, 3]],
        ['either way', [0, 1, 2, 0, 3, 2]],
        ['either way, with corners of their own', [0, 1, 6, 0, 3, 2]],
    ])('is closed, off the patch and into it, where triangles are turned %s', (_, indices) => {
        const way = found({ positions, indices }, true);
        expect(way).toHaveLength(5);
        for (const [x, y, z] of standOff(way, 0.1)) {
            expect(z).toBeCloseTo(1.1, 12);
            expect(Math.max(Math.abs(x - 0.5), Math.abs(y - 0.5))).toBeCloseTo(0.4, 12);
        }
        expect(way.every(({ point }, i) => i === 0 || distance(point, way[i - 1]!.point) === 1)).toBe(true);
    });

    it('stands off a fold as far as off its sides, however sharp that is', () => {
        const fold = { positions: [0, 0, 0, 1, 0, 0, 0.5, -1, -2, 0.5, 1, -2], indices: [0, 1, 2, 0, 1, 3] };
        const way = outlineOf(fold, ([, y, z]) => [0, y, z === 0 ? 1 : 0], false) as WayPoint[];
        expect(way).toHaveLength(5);
        for (const { point, off } of way) if (point[2] === 0) expect(off[2]).toBeGreaterThan(0.8);
    });

    it('is the longer loop where two meet at a place', () => {
        const bow = { positions: [0, 0, 0, 1, 1, 0, 1, -1, 0, -2, 2, 0, -2, -2, 0], indices: [0, 1, 2, 0, 3, 4] };
        const xs = found(bow).map(({ point }) => point[0]);
        expect([xs.length, Math.min(...xs), Math.max(...xs)]).toEqual([4, -2, 0]);
    });

    it('of what is closed there is none, nor where a border does not close', () => {
        const closed = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];
        const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, -1, -1];
        const said = (indices: number[]): unknown => outlineOf({ positions: corners, indices }, () => [0, 0, 1], false);
        expect(said(closed)).toBe('The patch has no outline: it is closed.');
        expect(said([...closed, 0, 1, 4])).toBe('No closed outline was found.');
    });
});
