import { describe, expect, it } from 'vitest';
import { seededRandom } from '../protocol/testing/randomSurface.ts';
import { findParts, rootsOf } from './parts.ts';

/** Four corners and no mids. */
function quad(a: number, b: number, c: number, d: number): number[] {
    return [a, b, c, d, -1, -1, -1, -1];
}

/** A strip of `count` cells on vertices from `first` on. */
function strip(first: number, count: number): number[] {
    return Array.from({ length: count }, (_, i) => {
        const at = first + 2 * i;
        return quad(at, at + 2, at + 3, at + 1);
    }).flat();
}

describe('rootsOf', () => {
    it('joins what shares a vertex, by corners and by mids, and nothing else', () => {
        const cells = Int32Array.from([...strip(0, 2), ...strip(6, 1), 10, 11, 12, 13, 14, -1, -1, -1]);
        expect([...rootsOf(cells, 15)]).toEqual([0, 0, 0, 0, 0, 0, 6, 6, 6, 6, 10, 10, 10, 10, 10]);
    });

    it('agrees with flooding on random cells', () => {
        const random = seededRandom(5);
        const vertices = 300;
        const cells = Int32Array.from(
            Array.from({ length: 70 }, () =>
                quad(...([0, 0, 0, 0].map(() => random() % vertices) as [number, number, number, number])),
            ).flat(),
        );
        const roots = rootsOf(cells, vertices);
        const flooded = Array.from({ length: vertices }, (_, i) => i);
        for (let changed = true; changed;) {
            changed = false;
            for (let base = 0; base < cells.length; base += 8) {
                const corners = [...cells.subarray(base, base + 4)];
                const low = Math.min(...corners.map((corner) => flooded[corner]!));
                for (const corner of corners) {
                    changed ||= flooded[corner] !== low;
                    flooded[corner] = low;
                }
            }
        }
        expect([...roots]).toEqual(flooded);
    });
});

describe('findParts', () => {
    const cells = Int32Array.from([...strip(0, 3), ...strip(8, 5)]);
    const seeds = Float32Array.from(Array.from({ length: 20 }, (_, i) => [i < 8 ? 0.2 : 0.8, (i >> 1) / 10]).flat());

    it('lists them with their cells and the place of their first vertex', () => {
        const { parts, hidden } = findParts(cells, 20, { seeds, tFrom: 0 }, { hidden: [] });
        expect(parts.map(({ cells: count, hidden: isHidden }) => [count, isHidden])).toEqual([
            [3, false],
            [5, false],
        ]);
        expect(parts[1]!.seed[0]).toBeCloseTo(0.8);
        expect(Math.max(...hidden)).toBe(0);
    });

    it('hides the part that a place is on, at all of its vertices', () => {
        const { parts, hidden } = findParts(cells, 20, { seeds, tFrom: 3.8e9 }, { hidden: [[0.79, 3.8e9 + 0.61]] });
        expect(parts.map((part) => part.hidden)).toEqual([false, true]);
        expect([...hidden]).toEqual(Array.from({ length: 20 }, (_, i) => (i < 8 ? 0 : 255)));
    });
});
