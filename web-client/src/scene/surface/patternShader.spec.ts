import { describe, expect, it } from 'vitest';
import { coarsestPower } from './patternShader.ts';

describe('the largest power of two that has a line', () => {
    it.each([
        [0, 1, 0.5],
        [3, 5, 4],
        [0, 5, 4],
        [-7.1, -7, 0.0625],
        [1e6, 1e6 + 1e-3, 2 ** -10],
        [-5, 5, 8],
    ])('between %d and %d is %d', (low, high, power) => {
        expect(coarsestPower(low, high)).toBe(power);
        const inside = low < 0 && high > 0 ? 0 : power * (Math.floor(low / power) + 1);
        expect(inside > low || low === 0).toBe(true);
        expect(inside).toBeLessThan(high);
    });

    it('is some number where there is nothing', () => {
        expect(coarsestPower(Infinity, -Infinity)).toBe(1);
        expect(coarsestPower(2, 2)).toBe(1);
    });
});
