// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { toThousandth } from './histogramPanel.ts';

it('the end of a range keeps what tells a thousandth of the values apart, wherever they lie', () => {
    expect(toThousandth(101325.1234, [101315, 101335])).toBe(101325.12);
    expect(toThousandth(1.23456e-9, [0, 2e-9])).toBeCloseTo(1.235e-9, 13);
    expect(toThousandth(123456789, [0, 2e9])).toBe(123000000);
    expect(toThousandth(5, [5, 5])).toBe(5);
});
