import { describe, expect, it } from 'vitest';
import { fieldNumber, finestStep, niceStep, niceTicks, placeNumber, resolutionOf, shortNumber, valueNumber } from './numbers.ts';

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

describe('niceTicks', () => {
    it.each([
        [0, 1, 5, ['0.0', '0.2', '0.4', '0.6', '0.8', '1.0'], ''],
        [-3, 12.92, 8, ['−2', '0', '2', '4', '6', '8', '10', '12'], ''],
        [0, 5.87, 3, ['0', '2', '4'], ''],
        [0, 0.004, 4, ['0.000', '0.001', '0.002', '0.003', '0.004'], ''],
        // UTM coordinates.
        [512345, 513345, 5, ['512400', '512600', '512800', '513000', '513200'], ''],
        [5423456, 5424456, 5, ['600', '800', '1000', '1200', '1400'], '+5.423e6'],
        [-5424456, -5423456, 5, ['600', '800', '1000', '1200', '1400'], '−5.425e6'],
        // Seconds since 1970.
        [1700000000, 1700000600, 6, ['0', '100', '200', '300', '400', '500', '600'], '+1.7e9'],
        // A sample of microseconds after the start-up.
        [0.1, 0.1005, 5, ['0.1000', '0.1001', '0.1002', '0.1003', '0.1004', '0.1005'], ''],
        [
            0.1,
            0.1005,
            10,
            [
                '0.10000',
                '0.10005',
                '0.10010',
                '0.10015',
                '0.10020',
                '0.10025',
                '0.10030',
                '0.10035',
                '0.10040',
                '0.10045',
                '0.10050',
            ],
            '',
        ],
        [0.1, 0.1000005, 5, ['0', '100', '200', '300', '400', '500'], '×1e−9 +0.1'],
        [1700000000, 1700000000.00051, 5, ['0', '200', '400'], '×1e−6 +1.7e9'],
        // A domain of 40 micrometres, and one of ten thousand kilometres.
        [0, 4e-5, 4, ['0', '10', '20', '30', '40'], '×1e−6'],
        [0, 1e7, 5, ['0', '2', '4', '6', '8', '10'], '×1e6'],
    ])('of %d to %d, about %d', (low, high, wanted, labels, shared) => {
        const found = niceTicks(low, high, wanted);
        expect(found.ticks.map(({ label }) => label)).toEqual(labels);
        expect(found.shared).toBe(shared);
    });

    it('stays inside the range and near the wanted number, and says each number with what all share, for any range', () => {
        for (const scale of [1e-9, 1e-7, 0.03, 1, 17, 4e5, 3e9]) {
            for (const far of [0, 1, -30, 1e3, 1e6]) {
                const [low, high] = [(far - 0.37) * scale, (far + 1.91) * scale];
                const { ticks, shared } = niceTicks(low, high, 6);
                const words = `${low} to ${high}: ${shared}`;
                expect(ticks.length, words).toBeGreaterThanOrEqual(2);
                expect(ticks.length, words).toBeLessThanOrEqual(7);
                const plain = shared.replaceAll('−', '-');
                const factor = Number(/×(\S+)/.exec(plain)?.[1] ?? 1);
                const offset = Number(/(?:^| )([+-]\S+)/.exec(plain)?.[1] ?? 0);
                for (const { value, label } of ticks) {
                    expect(value, words).toBeGreaterThanOrEqual(low - 1e-9 * scale);
                    expect(value, words).toBeLessThanOrEqual(high + 1e-9 * scale);
                    const said = Number(label.replace('−', '-')) * factor + offset;
                    expect(Math.abs(said - value), `${words}: ${label} for ${value}`).toBeLessThan(1e-3 * (high - low));
                    expect(label.length, `${words}: ${label}`).toBeLessThanOrEqual(8);
                }
                expect(new Set(ticks.map(({ label }) => label)).size, words).toBe(ticks.length);
            }
        }
    });

    it('has none for an empty or endless range', () => {
        expect(niceTicks(1, 1, 5).ticks).toEqual([]);
        expect(niceTicks(0, Number.POSITIVE_INFINITY, 5).ticks).toEqual([]);
    });
});

describe('niceStep', () => {
    it('rounds up to 1, 2 or 5 times a power of ten, as one would type it', () => {
        expect([0.9, 1, 1.1, 2.1, 5.1, 100].map(niceStep)).toEqual([1, 1, 2, 5, 10, 100]);
        expect([0.00012, 3.1e-7].map(niceStep)).toEqual([0.0002, 5e-7]);
    });
});
