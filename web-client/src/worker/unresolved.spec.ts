import { describe, expect, it } from 'vitest';
import { unresolved } from './unresolved.ts';

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
