import { describe, expect, it } from 'vitest';
import { niceStep, niceTicks, shortNumber } from './ticks.ts';

describe('niceTicks', () => {
    it.each([
        [0, 1, 5, ['0.0', '0.2', '0.4', '0.6', '0.8', '1.0']],
        [-3, 12.92, 8, ['−2', '0', '2', '4', '6', '8', '10', '12']],
        [0, 5.87, 3, ['0', '2', '4']],
        [0, 0.004, 4, ['0.000', '0.001', '0.002', '0.003', '0.004']],
    ])('of %d to %d, about %d', (low, high, wanted, labels) => {
        expect(niceTicks(low, high, wanted).map(({ label }) => label)).toEqual(labels);
    });

    it('stays inside the range and near the wanted number, for any range', () => {
        for (const scale of [1e-7, 0.03, 1, 17, 4e5, 3e9]) {
            const [low, high] = [-0.37 * scale, 1.91 * scale];
            const ticks = niceTicks(low, high, 6);
            expect(ticks.length, `scale ${scale}`).toBeGreaterThanOrEqual(2);
            expect(ticks.length, `scale ${scale}`).toBeLessThanOrEqual(7);
            for (const { value } of ticks) {
                expect(value).toBeGreaterThanOrEqual(low - 1e-9 * scale);
                expect(value).toBeLessThanOrEqual(high + 1e-9 * scale);
            }
        }
    });

    it('has none for an empty or endless range', () => {
        expect(niceTicks(1, 1, 5)).toEqual([]);
        expect(niceTicks(0, Number.POSITIVE_INFINITY, 5)).toEqual([]);
    });
});

describe('niceStep', () => {
    it('rounds up to 1, 2 or 5 times a power of ten', () => {
        expect([0.9, 1, 1.1, 2.1, 5.1, 100].map(niceStep)).toEqual([1, 1, 2, 5, 10, 100]);
    });
});

describe('shortNumber', () => {
    it('drops what no one reads', () => {
        expect([0, 0.165263, -1.5, 14, 1e9, Number.NaN].map(shortNumber)).toEqual(['0', '0.1653', '−1.5', '14', '1.000e+9', '–']);
    });
});
