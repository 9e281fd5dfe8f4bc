import { describe, expect, it } from 'vitest';
import { fieldNumber, finestStep, placeNumber, resolutionOf, shortNumber, valueNumber } from './numbers.ts';

describe('shortNumber', () => {
    it('drops what no one reads, and no digit before the point', () => {
        const values = [0, 0.165263, -1.5, 14, 123456.7, 1e9, 1.23456e-5, -2e-7, Number.NaN];
        expect(values.map(shortNumber)).toEqual(['0', '0.1653', '−1.5', '14', '123457', '1e9', '1.235e−5', '−2e−7', '–']);
    });
});

describe('placeNumber', () => {
    it.each([
        ['a coordinate of UTM', 5425046.127, 5423456, 5426456, '5425046'],
        ['seconds since 1970', 1700000300, 1700000000, 1700000600, '1700000300'],
        ['a time of microseconds', 0.1003, 0.1, 0.1005, '0.1003'],
        ['a place in 40 micrometres', 0.0000212345, 0, 4e-5, '2.123e−5'],
        ['what is zero but for rounding', -1e-17, -1, 1, '0'],
        ['a place beside zero', 0.0004, -1, 1, '0'],
        ['bundled data', 8.5, 8.5, 28.5, '8.5'],
        ['a pressure', 101325.2137, 101325, 101325.5, '101325.2137'],
        ['a negative one', -5425046, -5426456, -5423456, '−5425046'],
    ])('writes %s by its range', (_, value, low, high, words) => {
        expect(placeNumber(value, resolutionOf(low, high))).toBe(words);
    });

    it('tells neighbouring steps apart, however many there are, and writes all digits where there is no range', () => {
        const times = Array.from({ length: 20001 }, (_, i) => 10 + i * 0.0005);
        const resolution = resolutionOf(10, 20, finestStep(times));
        expect(new Set(times.map((time) => placeNumber(time, resolution))).size).toBe(times.length);
        expect(placeNumber(1700000300.25, resolutionOf(5, 5, finestStep([5])))).toBe('1700000300.25');
        expect(placeNumber(Number.NaN, 1)).toBe('–');
    });
});

describe('fieldNumber', () => {
    it('keeps what was typed to its last digit, and rounds what was computed below what can be seen', () => {
        const resolution = resolutionOf(5423456, 5426456);
        expect(fieldNumber(5425046.127, resolution)).toBe('5425046.127');
        expect(fieldNumber(5425046.1270123456, resolution)).toBe('5425046.13');
        expect(fieldNumber(0.0000212, 4e-8)).toBe('2.12e-5');
        expect(fieldNumber(0.1 + 0.2, 0.001)).toBe('0.3');
        expect(fieldNumber(-1.4, 0.016)).toBe('-1.4');
        expect(fieldNumber(Number.NaN, 1)).toBe('');
    });

    it('is read back by a field within what is shown, at any scale', () => {
        for (const scale of [1e-9, 1e-5, 1, 1e4, 1e9]) {
            for (const far of [0, 1e3, -1e5]) {
                const [low, high] = [far * scale, (far + 1) * scale];
                for (const part of [0, 1 / 3, Math.PI / 4, 1]) {
                    const value = low + part * (high - low);
                    const back = Number(fieldNumber(value, resolutionOf(low, high)));
                    expect(Math.abs(back - value)).toBeLessThanOrEqual(2e-5 * scale);
                }
            }
        }
    });
});

describe('valueNumber', () => {
    it('has four digits, and as many more as the range of its field asks for', () => {
        expect(valueNumber(101325.2137, [101325, 101325.5])).toBe('101325.2137');
        expect(valueNumber(0.0123456, [0, 1e6])).toBe('0.01235');
        expect(valueNumber(0.0123456, [null, null])).toBe('0.01235');
        expect(valueNumber(1.23456)).toBe('1.235');
    });
});
