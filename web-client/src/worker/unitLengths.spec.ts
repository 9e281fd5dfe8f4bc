import { describe, expect, it } from 'vitest';
import { unitLengths } from './unitLengths.ts';

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
