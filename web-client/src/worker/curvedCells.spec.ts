import { describe, expect, it } from 'vitest';
import type { MeshChange } from '../mesh/meshChange.ts';
import { noVertex } from '../protocol/wireMesh.ts';
import { triangleCount, triangulate } from '../protocol/triangulate.ts';
import { curvedChange, withSentNormals } from './curvedCells.ts';
import { addNormals } from './vertexQuantities.ts';

const radius = 2;

/** A sphere's patch over a grid of n by n cells; one cell more, twice as large, hangs at the left side. */
function sphere(n: number): { change: MeshChange; cells: Int32Array } {
    const positions: number[] = [];
    const seeds: number[] = [];
    const add = (u: number, v: number): void => {
        positions.push(radius * Math.cos(u) * Math.cos(v), radius * Math.sin(u) * Math.cos(v), radius * Math.sin(v));
        seeds.push(u, v);
    };
    const h = 0.8 / n;
    for (let j = 0; j <= n; ++j) for (let i = 0; i <= n; ++i) add(i * h, j * h);
    const cells: number[] = [];
    const at = (i: number, j: number): number => j * (n + 1) + i;
    const none = [noVertex, noVertex, noVertex, noVertex];
    for (let j = 0; j < n; ++j) {
        for (let i = 0; i < n; ++i) cells.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), ...none);
    }
    add(-2 * h, 0);
    add(-2 * h, 2 * h);
    const last = positions.length / 3 - 1;
    cells.push(last - 1, at(0, 0), at(0, 2), last, noVertex, at(0, 1), noVertex, noVertex);
    const array = Int32Array.from(cells);
    const indices = new Uint32Array(3 * triangleCount(array));
    triangulate(array, Float32Array.from(positions), indices);
    const change: MeshChange = {
        vertices: positions.length / 3,
        triangles: indices.length / 3,
        positions: Float32Array.from(positions),
        normals: Float32Array.from(positions, (x) => x / radius),
        seeds: Float32Array.from(seeds),
        ...{ fromVertex: 0, fromNormal: 0, fromSeed: 0, fromIndex: 0, tFrom: 0 },
        scalars: [
            { name: 'speed', fromVertex: 0, values: Float32Array.from(positions, (_, i) => i).slice(0, positions.length / 3) },
        ],
        indices,
        parts: null,
        cut: { levels: new Uint8Array(positions.length / 3).fill(7), trimmedCells: 0 },
        units: null,
        unresolved: null,
    };
    return { change, cells: array };
}

function farthest(change: MeshChange): number {
    let most = 0;
    for (let v = 0; v < change.vertices; ++v) {
        most = Math.max(most, Math.abs(Math.hypot(...change.positions.subarray(3 * v, 3 * v + 3)) - radius));
    }
    return most;
}

function rms(change: MeshChange, from: number): number {
    let sum = 0;
    for (let v = from; v < change.vertices; ++v) {
        sum += (Math.hypot(...change.positions.subarray(3 * v, 3 * v + 3)) - radius) ** 2;
    }
    return Math.sqrt(sum / (change.vertices - from));
}

describe('curved cells', () => {
    it('lie nearer by the fourth power where the normals are the exact ones', () => {
        const errors = [4, 8].map((n) => {
            const { change, cells } = sphere(n);
            return farthest(curvedChange(change, cells, 1e6));
        });
        expect(Math.log2(errors[0]! / errors[1]!)).toBeGreaterThan(3.5);
        const diagonal = radius * 0.4 * Math.SQRT2; // of the large cell
        expect(errors[0]).toBeLessThan(diagonal ** 2 / (8 * radius) / 20);
    });

    it('lie nearer with the normals of the neighbours too', () => {
        const errors = [4, 8, 16].map((n) => {
            const { change, cells } = sphere(n);
            change.normals.fill(0);
            addNormals(change.positions, change.indices, 0, change.normals);
            return rms(curvedChange(change, cells, 1e6), change.vertices);
        });
        // Exact normals: of fourth order. Means of the triangles round a vertex: of third, less at the
        // border.
        for (const k of [0, 1]) expect(Math.log2(errors[k]! / errors[k + 1]!)).toBeGreaterThan(2.5);
    });

    it('take the normals that come with the surface, turned as its triangles are', () => {
        const { change } = sphere(4);
        const exact = change.normals;
        const names = ['normal_x', 'normal_y', 'normal_z'];
        const scalars = names.map((name, i) => ({
            name,
            fromVertex: 0,
            values: exact.filter((_, at) => at % 3 === i).map((x) => -x),
        }));
        scalars[0]!.values[7] = NaN;
        const own = exact.map((x) => 0.9 * x);
        const { normals } = withSentNormals({ ...change, normals: own, scalars });
        expect(normals.subarray(0, 21)).toEqual(exact.subarray(0, 21));
        expect(normals.subarray(21, 24)).toEqual(own.subarray(21, 24));
        expect(withSentNormals(change)).toBe(change);
    });

    it('keep their vertices and have no cracks', () => {
        const { change, cells } = sphere(4);
        const fine = curvedChange(change, cells, 1e3);
        expect(fine.positions.subarray(0, 3 * change.vertices)).toEqual(change.positions);
        const directed = new Set<string>();
        for (let i = 0; i < fine.indices.length; i += 3) {
            for (let k = 0; k < 3; ++k) {
                const side = `${fine.indices[i + k]} ${fine.indices[i + ((k + 1) % 3)]}`;
                expect(directed.has(side)).toBe(false);
                directed.add(side);
            }
        }
        const open = [...directed].filter((side) => !directed.has(side.split(' ').reverse().join(' ')));
        const pieces = Math.sqrt((fine.triangles - 3) / (change.triangles - 3));
        expect(open.length % (4 * 4 - 2 + 3)).toBe(0);
        expect(pieces).toBeGreaterThan(1);
        expect(fine.cut?.levels.every((level) => level === 7)).toBe(true);
        expect(fine.normals.every(Number.isFinite)).toBe(true);
    });

    it('are as many as the picture needs, and none where they are flat', () => {
        const { change, cells } = sphere(4);
        const counts = [1, 200, 2000].map((pixels) => curvedChange(change, cells, pixels).triangles);
        expect(counts[0]).toBe(change.triangles);
        expect(counts[1]).toBeGreaterThan(counts[0]!);
        expect(counts[2]).toBeGreaterThan(counts[1]!);
        change.normals.fill(0);
        expect(curvedChange(change, cells, 1e6)).toBe(change);
    });
});
