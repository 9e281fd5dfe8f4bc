import { describe, expect, it } from 'vitest';
import { addNormals, unitLengths, unresolved } from './vertexQuantities.ts';

function vertexNormals(positions: Float32Array, indices: Uint32Array): Float32Array {
    const normals = new Float32Array(positions.length);
    addNormals(positions, indices, 0, normals);
    return normals;
}

describe('addNormals', () => {
    it('of a plane are its normal', () => {
        const positions = Float32Array.of(0, 0, 2, 3, 0, 2, 3, 1, 2, 0, 1, 2);
        const normals = vertexNormals(positions, Uint32Array.of(0, 1, 2, 0, 2, 3));
        expect([...normals]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
    });

    it('of a fine sphere point outwards', () => {
        const [rows, columns] = [24, 48];
        const positions: number[] = [];
        const indices: number[] = [];
        for (let i = 1; i < rows; ++i) {
            for (let k = 0; k < columns; ++k) {
                const [a, b] = [(Math.PI * i) / rows, (2 * Math.PI * k) / columns];
                positions.push(Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a));
                if (i + 1 === rows) continue;
                const at = (i - 1) * columns;
                const next = (k + 1) % columns;
                indices.push(at + k, at + columns + k, at + next);
                indices.push(at + next, at + columns + k, at + columns + next);
            }
        }
        const normals = vertexNormals(Float32Array.from(positions), Uint32Array.from(indices));
        for (let v = 0; v < normals.length; v += 3) {
            const dot = [0, 1, 2].reduce((sum, k) => sum + normals[v + k]! * positions[v + k]!, 0);
            expect(dot).toBeGreaterThan(0.98);
        }
    });

    it('of the last vertices are the same as when all are made', () => {
        const positions = Float32Array.from({ length: 60 }, (_, i) => Math.sin(i * i));
        const indices = Uint32Array.from({ length: 90 }, (_, i) => (i * 7 + (i >> 2)) % 20);
        const all = vertexNormals(positions, indices);
        for (const from of [1, 7, 19]) {
            const last = new Float32Array(3 * (20 - from));
            addNormals(positions, indices, from, last);
            expect([...last]).toEqual([...all.subarray(3 * from)]);
        }
    });

    it('of a vertex without area stay zero', () => {
        const normals = vertexNormals(new Float32Array(9), Uint32Array.of(0, 1, 2));
        expect([...normals]).toEqual(new Array(9).fill(0));
    });
});

/** Rows of t and columns of s on a plane that is turned in space; each vertex at a place of the plane. */
function sheet(n: number, place: (s: number, t: number) => readonly [number, number], closed = false) {
    const [e, f] = [
        [0.6, 0.8, 0],
        [-0.48, 0.36, 0.8],
    ] as const;
    const columns = closed ? n : n + 1;
    const vertices = (n + 1) * columns;
    const positions = new Float32Array(3 * vertices);
    const seeds = new Float32Array(2 * vertices);
    const indices: number[] = [];
    for (let row = 0; row <= n; ++row) {
        for (let column = 0; column < columns; ++column) {
            const v = row * columns + column;
            const [x, y] = place(column / n, row / n);
            positions.set(
                [0, 1, 2].map((axis) => x * e[axis]! + y * f[axis]!),
                3 * v,
            );
            seeds.set([column / n, row / n], 2 * v);
            const next = row * columns + ((column + 1) % columns);
            if (row < n && (closed || column < n)) indices.push(v, next, next + columns, v, next + columns, v + columns);
        }
    }
    return { positions, seeds, indices: Uint32Array.from(indices), vertices };
}

describe('the lengths of units on a surface', () => {
    it('are the distances between lines of the whole parameter, however it is sheared', () => {
        // Lines of s are straight and 3 apart; those of t run at a slant, so they are nearer than 5.
        const units = unitLengths(
            sheet(8, (s, t) => [3 * s, 5 * t + 2 * s]),
            false,
        );
        const across = 15 / Math.hypot(3, 2);
        for (let v = 0; v < units.length / 2; ++v) {
            expect(units[2 * v]).toBeCloseTo(3, 4);
            expect(units[2 * v + 1]).toBeCloseTo(across, 4);
        }
    });

    it('of a closed rake do not jump where its parameter does', () => {
        const ring = (s: number, t: number): [number, number] => [
            (1 + t) * Math.cos(2 * Math.PI * s),
            (1 + t) * Math.sin(2 * Math.PI * s),
        ];
        const units = unitLengths(sheet(64, ring, true), true);
        for (let column = 0; column < 64; ++column) {
            const inner = units[2 * (32 * 64 + column)]!;
            expect(inner).toBeCloseTo(2 * Math.PI * 1.5, 1);
        }
    });

    it('are 0 where the parameter does not change, or there is no area', () => {
        const units = unitLengths({ ...sheet(2, (s, t) => [s, t]), seeds: new Float32Array(18) }, false);
        expect([...units]).toEqual(new Array(18).fill(0));
        const flat = unitLengths(
            sheet(2, () => [1, 1]),
            false,
        );
        expect([...flat]).toEqual(new Array(18).fill(0));
    });
});

const up = (vertices: number): Float32Array => Float32Array.from({ length: 3 * vertices }, (_, i) => (i % 3 === 2 ? 1 : 0));

function flat(corners: readonly (readonly [number, number])[], indices: number[]): Float32Array {
    const positions = Float32Array.from(corners.flatMap(([x, y]) => [x, y, 0]));
    return unresolved({
        ...{ positions, normals: up(corners.length), indices: Uint32Array.from(indices), vertices: corners.length },
    });
}

describe('what a fixed grid cannot resolve', () => {
    it('is nothing of a flat square at any size, nor of an equal-sided triangle', () => {
        for (const size of [1, 1e6, 1e-9]) {
            const square = [[0, 0] as const, [size, 0] as const, [size, size] as const, [0, size] as const];
            for (const loss of flat(square, [0, 1, 2, 0, 2, 3])) expect(loss).toBeCloseTo(0, 6);
        }
        const equal = [[0, 0] as const, [1, 0] as const, [0.5, Math.sqrt(3) / 2] as const];
        for (const loss of flat(equal, [0, 1, 2])) expect(loss).toBeCloseTo(0, 6);
    });

    it('grows with how long and thin triangles are, and is the mean of those that meet', () => {
        // Legs 1 and 10: 4 * 5 / (sqrt 3 * 10 * sqrt 101), over that of half a square.
        const thin = 1 - 20 / (Math.sqrt(3) * 10 * Math.sqrt(101)) / Math.sqrt(2 / 3);
        const corners = [[0, 0] as const, [10, 0] as const, [0, 1] as const, [0, 11] as const];
        const loss = flat(corners, [0, 1, 2, 0, 2, 3]);
        expect(loss[2]).toBeCloseTo(thin, 5);
        // The other one has no area.
        expect(loss[0]).toBeCloseTo(thin, 5);
        expect(loss[6]).toBe(1);
    });

    it('grows with how far the surface turns from one vertex to the next', () => {
        for (const angle of [0, 0.2, 0.6]) {
            // A roof with its ridge along y: sides go down by the angle.
            const [x, z] = [Math.cos(angle), -Math.sin(angle)];
            const positions = Float32Array.from([0, 0, 0, 0, 1, 0, x, 0, z, -x, 0, z]);
            const loss = unresolved({ positions, normals: up(4), indices: Uint32Array.of(0, 2, 1, 0, 1, 3), vertices: 4 });
            expect(loss[1]).toBeCloseTo(Math.sin(angle), 5);
        }
    });
});
