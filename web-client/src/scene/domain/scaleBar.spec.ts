import { expect, it } from 'vitest';
import { scaleOf } from './scaleBar.ts';

it('is a round length that can be seen, at any scale', () => {
    for (let exponent = -9; exponent <= 9; exponent += 0.17) {
        const { length, px } = scaleOf(10 ** exponent)!;
        expect(px).toBeGreaterThanOrEqual(47.9);
        expect(px).toBeLessThanOrEqual(121);
        expect(length / 10 ** exponent).toBeCloseTo(px, 6);
        const digit = length / 10 ** Math.floor(Math.log10(length) + 1e-9);
        expect([1, 2, 5].some((each) => Math.abs(each - digit) < 1e-6)).toBe(true);
    }
    expect(scaleOf(0)).toBeNull();
    expect(scaleOf(Number.NaN)).toBeNull();
});
