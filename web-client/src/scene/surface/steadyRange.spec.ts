import { describe, expect, it } from 'vitest';
import { steadyRange } from './steadyRange.ts';

describe('the range of a surface', () => {
    it('holds all its values, and little more', () => {
        for (const [low, high] of [
            [0.0019, 1.786],
            [-3.2e-7, 8.1e-7],
            [1_000_000.25, 1_000_000.5],
        ] as const) {
            const [from, to] = steadyRange(low, high);
            expect(from).toBeLessThanOrEqual(low);
            expect(to).toBeGreaterThanOrEqual(high);
            expect(to - from).toBeLessThan(1.5 * (high - low));
        }
        expect(steadyRange(0.31, 1.42)).toEqual([0.2, 1.6]);
    });

    it('stays while the values change a little', () => {
        expect(steadyRange(0.312, 1.43)).toEqual(steadyRange(0.31, 1.42));
    });

    it('is what it is of a single value', () => {
        expect(steadyRange(2, 2)).toEqual([2, 2]);
        expect(steadyRange(Number.NaN, Number.NaN)).toEqual([Number.NaN, Number.NaN]);
    });
});
