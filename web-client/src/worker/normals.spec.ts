import { describe, expect, it } from 'vitest';
import { addNormals } from './normals.ts';

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
