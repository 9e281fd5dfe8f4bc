import { expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { distance, lengthOf } from '../../scene/rake/rakeShape.ts';
import type { Triangles } from './bodyEdges.ts';
import { standOff, type WayPoint } from './bodyWay.ts';
import { sharpEdgeNear } from './sharpEdge.ts';

function found(body: Triangles, near: Vec3, eye: Vec3, within: number, stepped = false): WayPoint[] {
    const edge = sharpEdgeNear(body, near, eye, within, stepped);
    if (typeof edge === 'string') throw new Error(edge);
    return edge;
}

/** Faces with corners of their own, as fans. */
function faces(...all: (readonly Vec3[])[]): Triangles {
    const positions = all.flat(2);
    let first = 0;
    const indices = all.flatMap((face) => {
        const at = first;
        first += face.length;
        return face.slice(2).flatMap((_, k) => [at, at + k + 1, at + k + 2]);
    });
    return { positions, indices };
}

/** What a profile in x and z becomes from y = 0 to 1, with its ends. */
function prism(profile: readonly [number, number][]): Triangles {
    const at = (y: number): Vec3[] => profile.map(([x, z]) => [x, y, z]);
    const sides = profile.map(([x, z], i): Vec3[] => {
        const [u, w] = profile[(i + 1) % profile.length]!;
        return [
            [x, 0, z],
            [u, 0, w],
            [u, 1, w],
            [x, 1, z],
        ];
    });
    return faces(...sides, at(0), at(1).reverse());
}

const square = prism([
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
]);

function roundProfile(sides: number): [number, number][] {
    return Array.from({ length: sides }, (_, i) => [Math.cos((2 * Math.PI * i) / sides), Math.sin((2 * Math.PI * i) / sides)]);
}

function ball(rings: number): Triangles {
    const at = (i: number, k: number): Vec3 => {
        const [theta, phi] = [(Math.PI * i) / rings, (Math.PI * (k % (2 * rings))) / rings];
        // The poles are at one place each.
        const round = (x: number): number => Math.round(x * 2 ** 20) / 2 ** 20;
        return [round(Math.sin(theta) * Math.cos(phi)), round(Math.sin(theta) * Math.sin(phi)), round(Math.cos(theta))];
    };
    const all: Vec3[][] = [];
    for (let i = 0; i < rings; ++i) {
        for (let k = 0; k < 2 * rings; ++k) all.push([at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)]);
    }
    return faces(...all);
}

it('of a box it is one edge, from corner to corner, off it as far as is said', () => {
    const edge = found(square, [0.95, 0.3, 1], [2, 0.5, 9], 0.1);
    expect(edge.map(({ point }) => point.join()).sort()).toEqual(['1,0,1', '1,1,1']);
    for (const { off } of edge) {
        for (const [k, each] of [Math.SQRT1_2, 0, Math.SQRT1_2].entries()) expect(off[k]).toBeCloseTo(each, 12);
    }
    expect(sharpEdgeNear(square, [0.5, 0.5, 1], [2, 0.5, 9], 0.1, false)).toContain('no sharp edge');
});

it('seen from within it stands into the corner, as far from both sides', () => {
    const [place] = standOff(found(square, [0.95, 0.3, 1], [0.5, 0.5, 0.5], 0.1), 0.1);
    expect(place![0]).toBeCloseTo(0.9, 12);
    expect(place![2]).toBeCloseTo(0.9, 12);
});

it.each([8, 48])('of a rim with %d sides it is closed, past edges that only meet it', (sides) => {
    const edge = found(prism(roundProfile(sides)), [0.97, 0, 0.02], [0, -9, 1], 0.1);
    expect(edge).toHaveLength(sides + 1);
    expect(edge.at(-1)).toEqual(edge[0]);
    for (const [x, y, z] of standOff(edge, 0.1)) {
        expect(y).toBeLessThan(-0.05);
        expect(Math.hypot(x, z)).toBeGreaterThan(1.05);
    }
});

it('a ball has none, nor what has no triangles or no numbers', () => {
    const round = ball(24);
    expect(sharpEdgeNear(round, [1, 0, 0], [9, 0, 0], 10, false)).toContain('no sharp edge');
    expect(sharpEdgeNear({ ...round, indices: [] }, [1, 0, 0], [9, 0, 0], 10, false)).toContain('no sharp edge');
    const nowhere = { ...square, positions: Array.from(square.positions, () => NaN) };
    expect(sharpEdgeNear(nowhere, [1, 0, 0], [9, 0, 0], 10, false)).toContain('no sharp edge');
    expect(sharpEdgeNear(square, [NaN, 0, 0], [9, 0, 0], 10, false)).toContain('no sharp edge');
});

/** The sides of boxes of a grid, of side 1, that a body is in. */
function boxes(isIn: (at: Vec3) => boolean, cells: number): Triangles {
    const all: Vec3[][] = [];
    for (let cell = 0; cell < cells ** 3; ++cell) {
        const at: Vec3 = [cell % cells, Math.floor(cell / cells) % cells, Math.floor(cell / cells ** 2)];
        for (let side = 0; side < 6; ++side) {
            const [axis, on] = [side % 3, side < 3 ? 0 : 1];
            const beyond = at.map((x, k) => (k === axis ? x + 2 * on - 1 : x)) as unknown as Vec3;
            if (!isIn(at) || isIn(beyond)) continue;
            const corner = (u: number, w: number): Vec3 =>
                at.map((x, k) => x + (k === axis ? on : k === (axis + 1) % 3 ? u : w)) as unknown as Vec3;
            all.push([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]);
        }
    }
    return faces(...all);
}

it('of the boxes of a grid, steps are no edges, but those of a block are', () => {
    const round = boxes((at) => distance(at, [9.5, 9.5, 9.5]) < 9, 20);
    const places: Vec3[] = [
        [9.5, 9.5, 19],
        [9.5, 5.5, 18],
        [15, 15, 15],
        [16, 10, 16],
    ];
    for (const near of places) {
        expect(sharpEdgeNear(round, near, [40, 9, 99], 2, true)).toContain('only steps');
    }
    const block = boxes(([x, y, z]) => Math.min(x, y, z) >= 2 && Math.max(x, y) < 8 && z < 3, 10);
    expect(
        found(block, [8, 5, 2.9], [99, 5, 99], 0.5, true)
            .map(({ point }) => point[1])
            .sort(),
    ).toEqual([2, 3, 4, 5, 6, 7, 8]);
});

it('a trailing edge of a wing, however thin, is followed along its sweep', () => {
    const pieces = 20;
    const line = (x: number, z: number, swept: number): Vec3[] =>
        Array.from({ length: pieces + 1 }, (_, i) => [x + swept * (i / pieces) ** 2, i / pieces, z]);
    const [nose, top, tail, under] = [line(0, 0, 1), line(0.5, 0.02, 0.5), line(1, 0, 0.3), line(0.5, -0.02, 0.5)];
    const strips = [
        [nose, top],
        [top, tail],
        [tail, under],
        [under, nose],
    ] as const;
    const wing = faces(...strips.flatMap(([a, b]) => a.slice(1).map((_, i) => [a[i]!, b[i]!, b[i + 1]!, a[i + 1]!])));
    const edge = found(wing, [1.05, 0.5, 0.001], [1, 0.5, 9], 0.1);
    const [from, to] = [edge[0]!, edge.at(-1)!];
    expect(edge).toHaveLength(pieces + 1);
    expect([from.point[1], to.point[1]].sort()).toEqual([0, 1]);
    for (const { off } of edge) {
        expect(off[0]).toBeGreaterThan(0.8);
        expect(lengthOf(off)).toBeCloseTo(1, 2);
    }
});

it('where a wall ends there is one, on the side that is seen', () => {
    const sheet = faces([
        [0, 0, 0],
        [1, 0, 0],
        [1, 1, 0],
        [0, 1, 0],
    ]);
    const edge = found(sheet, [0.99, 0.5, 0], [0.5, 0.5, -3], 0.1);
    expect(edge.map(({ off }) => off[2])).toEqual([-1, -1]);
    expect(distance(edge[0]!.point, edge[1]!.point)).toBe(1);
});
