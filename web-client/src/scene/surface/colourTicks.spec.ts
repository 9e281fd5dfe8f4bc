import { describe, expect, it } from 'vitest';
import { colourTicks } from './colourTicks.ts';

const values = (low: number, high: number, log: boolean): number[] =>
    colourTicks(low, high, log, 5).ticks.map(({ value }) => Number(value.toPrecision(6)) + 0);

describe('colourTicks', () => {
    it('are even where the range is', () => {
        expect(values(0, 1, false)).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
    });

    it('are 1, 2 and 5, or 1 and 3, or 1 times powers of ten, as there is room', () => {
        expect(values(1, 10, true)).toEqual([1, 2, 5, 10]);
        expect(values(0.02, 2, true)).toEqual([0.03, 0.1, 0.3, 1]);
        expect(values(0.001, 10, true)).toEqual([0.001, 0.01, 0.1, 1, 10]);
        expect(values(1e-9, 1e9, true).length).toBeLessThanOrEqual(6);
    });

    it('are round numbers within a range that is less than a power of ten', () => {
        expect(values(2, 4, true)).toEqual([2, 2.5, 3, 3.5, 4]);
    });

    it('are none where there is no logarithm', () => {
        expect(values(-1, 1, true)).toEqual([]);
    });
});
