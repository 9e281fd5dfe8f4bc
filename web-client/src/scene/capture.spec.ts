import { describe, expect, it } from 'vitest';
import { sizeFault, withoutBackground } from './capture.ts';

/** Holds what is seen of a colour with this opacity before a ground, as browsers compose it. */
const before = (ground: number, value: number, alpha: number): number => Math.round(value * alpha + ground * (1 - alpha));

describe('withoutBackground', () => {
    it('finds colour and opacity again, within the rounding of the two pictures', () => {
        for (const alpha of [0, 0.1, 0.5, 0.9, 1]) {
            const colour = [10, 128, 250];
            const on = (ground: number) => Uint8ClampedArray.from([...colour.map((value) => before(ground, value, alpha)), 255]);
            const found = on(0);
            withoutBackground(found, on(255));
            expect(Math.abs(found[3]! - 255 * alpha)).toBeLessThanOrEqual(1);
            if (alpha === 0) expect([...found]).toEqual([0, 0, 0, 0]);
            else colour.forEach((value, k) => expect(Math.abs(found[k]! - value)).toBeLessThanOrEqual(1.5 / alpha));
        }
    });
});

describe('sizeFault', () => {
    it('says what is wrong with a size', () => {
        expect(sizeFault({ width: 1920, height: 1080 })).toBeNull();
        expect(sizeFault({ width: 16_384, height: 7000 })).toBeNull();
        expect(sizeFault({ width: 16_385, height: 10 })).toMatch(/at least 16/);
        expect(sizeFault({ width: 16_385, height: 100 })).toMatch(/at most 16384 pixels/);
        expect(sizeFault({ width: 16_384, height: 8000 })).toMatch(/at most 128 million pixels/);
        expect(sizeFault({ width: Number.NaN, height: 100 })).toMatch(/whole numbers/);
        expect(sizeFault({ width: 100.5, height: 100 })).toMatch(/whole numbers/);
    });
});
