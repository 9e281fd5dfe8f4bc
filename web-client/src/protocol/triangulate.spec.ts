import { describe, expect, test } from 'vitest';
import { noVertex } from './wireMesh.ts';
import { triangleCount, triangulate } from './triangulate.ts';

// A unit square with its mids on the middle of straight sides, then bent out of the plane.
const flat = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0, 0, 1, 0.5, 0, 0.5, 1, 0, 0, 0.5, 0);

function cellOf(mask: number): Int32Array {
    return Int32Array.from([0, 1, 2, 3, ...[0, 1, 2, 3].map((side) => (mask & (1 << side) ? 4 + side : noVertex))]);
}

function outline(cell: Int32Array): number[] {
    return [0, 1, 2, 3].flatMap((i) => [cell[i]!, cell[4 + i]!]).filter((id) => id !== noVertex);
}

function area([a, b, c]: number[]): number {
    const at = (v: number, axis: number): number => flat[3 * v + axis]!;
    return 0.5 * ((at(b!, 0) - at(a!, 0)) * (at(c!, 1) - at(a!, 1)) - (at(c!, 0) - at(a!, 0)) * (at(b!, 1) - at(a!, 1)));
}

function cut(cells: Int32Array, positions: Float32Array): Uint32Array {
    const indices = new Uint32Array(3 * triangleCount(cells));
    triangulate(cells, positions, indices);
    return indices;
}

function trianglesOf(indices: Uint32Array): number[][] {
    return Array.from({ length: indices.length / 3 }, (_, i) => [...indices.subarray(3 * i, 3 * i + 3)]);
}

describe.each(Array.from({ length: 16 }, (_, mask) => mask))('a cell with mids %i', (mask) => {
    const cell = cellOf(mask);
    const ring = outline(cell);
    const triangles = trianglesOf(cut(cell, flat));

    test('has two triangles and one more for each mid, all facing one way, none flat, filling the cell', () => {
        expect(triangles).toHaveLength(ring.length - 2);
        const areas = triangles.map(area);
        expect(Math.min(...areas)).toBeGreaterThan(0.1);
        expect(areas.reduce((sum, a) => sum + a, 0)).toBeCloseTo(1, 12);
    });

    test('uses each sub-edge of its outline once and every other edge once each way', () => {
        const edges = triangles.flatMap(([a, b, c]) => [`${a}-${b}`, `${b}-${c}`, `${c}-${a}`]);
        expect(new Set(edges).size).toBe(edges.length);
        const border = ring.map((v, i) => `${v}-${ring[(i + 1) % ring.length]}`);
        for (const edge of border) expect(edges).toContain(edge);
        for (const edge of edges.filter((e) => !border.includes(e))) expect(edges).toContain(edge.split('-').reverse().join('-'));
    });
});

test('a quad is cut along its shorter diagonal', () => {
    const slanted = Float32Array.of(0, 0, 0, 1, 0, 0, 2, 1, 0, 1, 1, 0);
    expect(trianglesOf(cut(cellOf(0), slanted))).toEqual([
        [0, 1, 3],
        [1, 2, 3],
    ]);
});

test('cells follow one another in one array', () => {
    const cells = Int32Array.of(...cellOf(0), ...cellOf(15), ...cellOf(2));
    expect(cut(cells, flat)).toHaveLength(3 * (2 + 6 + 3));
});
