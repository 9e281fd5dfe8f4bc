import { describe, expect, it } from 'vitest';
import { typedNumber } from './typedNumber.ts';

describe('a number that is typed', () => {
    it.each([
        ['0,9', 0.9],
        ['0.9', 0.9],
        ['-1,25', -1.25],
        ['\u22121.25', -1.25],
        ['- 3', -3],
        ['+2', 2],
        [',5', 0.5],
        ['5.', 5],
        [' 12 ', 12],
        ['1 234 567,5', 1234567.5],
        ['1\u00a0234', 1234],
        ['12\u202f345.5', 12345.5],
        ['1e-3', 0.001],
        ['1,5E3', 1500],
        ['2.5 e+2', 250],
        ['0', 0],
    ])('may be written %s', (text, value) => {
        expect(typedNumber(text)).toBe(value);
    });

    it.each(['1,234.5', '1.234,5', '1,234,567', '1.234.567'])('is refused in words where %s may mean two', (text) => {
        expect(typedNumber(text)).toBe(`${text} is not clear: write the number with one comma or point, before its decimals.`);
    });

    it.each(['abc', '1 2', '12 34', '1e', '--1', '0x10', 'Infinity', '1e999', '.', ',', '-', '1;5', '3 m'])(
        'is refused in words where %s is none',
        (text) => {
            expect(typedNumber(text)).toBe(`${text} is not a number.`);
        },
    );

    it('is none yet in an empty field', () => {
        expect([typedNumber(''), typedNumber('  ')]).toEqual([null, null]);
    });
});
