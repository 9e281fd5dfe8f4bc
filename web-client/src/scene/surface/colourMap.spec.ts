import { describe, expect, it } from 'vitest';
import {
    banded,
    type ColourMapName,
    colourMapNames,
    colourTable,
    colourTicks,
    drawnRange,
    fractionOf,
    tableSize,
    valueAt,
    steadyRange,
} from './colourMap.ts';

const linear = (c: number): number => (c <= 0.04045 * 255 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);

function luminance(table: Uint8Array, i: number): number {
    const [r, g, b] = table.subarray(4 * i);
    return 0.2126 * linear(r!) + 0.7152 * linear(g!) + 0.0722 * linear(b!);
}

describe('colourTable', () => {
    const ends: Partial<Record<ColourMapName, [number[], number[]]>> = {
        viridis: [
            [0x44, 0x01, 0x54],
            [0xfd, 0xe7, 0x25],
        ],
        inferno: [
            [0, 0, 4],
            [252, 255, 164],
        ],
        plasma: [
            [13, 8, 135],
            [240, 249, 33],
        ],
        coolToWarm: [
            [59, 76, 192],
            [180, 4, 38],
        ],
    };

    it.each(Object.entries(ends))('%s has the ends of its source', (name, [first, last]) => {
        const table = colourTable(name as ColourMapName);
        expect([...table.slice(0, 4)]).toEqual([...first, 255]);
        expect([...table.slice(-4)]).toEqual([...last, 255]);
    });

    it.each(['viridis', 'cividis', 'inferno', 'plasma', 'grey'] as const)(
        '%s grows brighter all the way, so that it can be read without colour',
        (name) => {
            const table = colourTable(name);
            for (let i = 8; i < 256; i += 8) {
                expect(luminance(table, i), `entry ${i}`).toBeGreaterThan(luminance(table, i - 8));
            }
        },
    );

    it('cool to warm is brightest in its middle, which has no hue', () => {
        const table = colourTable('coolToWarm');
        // Moreland's own table has (221, 221, 221) there.
        for (const c of table.subarray(4 * 128, 4 * 128 + 3)) expect(Math.abs(c - 221)).toBeLessThanOrEqual(2);
        for (let i = 1; i < 127; ++i) {
            // But for the rounding to 8 bits.
            expect(luminance(table, i)).toBeLessThan(luminance(table, 127) + 0.005);
            expect(luminance(table, 255 - i)).toBeLessThan(luminance(table, 128) + 0.005);
        }
    });

    it.each(colourMapNames)('%s inverted is itself from the end', (name) => {
        const [table, inverted] = [colourTable(name), colourTable(name, true)];
        for (let i = 0; i < 256; ++i) {
            expect([...inverted.subarray(4 * i, 4 * i + 4)]).toEqual([...table.subarray(4 * (255 - i), 4 * (256 - i))]);
        }
    });
});

it('a root keeps the sign, and is undone by the value at a place', () => {
    const range = [-4, 16] as const;
    expect([-4, -1, 0, 4, 16, 99].map((v) => fractionOf(v, range, 'root'))).toEqual([0, 1 / 6, 1 / 3, 2 / 3, 1, 1]);
    for (const scale of ['even', 'root'] as const) {
        expect(valueAt(fractionOf(-1, range, scale), range, scale)).toBeCloseTo(-1, 12);
    }
    expect(valueAt(fractionOf(5, [1, 100], 'log'), [1, 100], 'log')).toBeCloseTo(5, 12);
});

it('the numbers of a root are apart where they stand', () => {
    const at = colourTicks(0, 1.8, 'root', 5).ticks.map(({ value }) => fractionOf(value, [0, 1.8], 'root'));
    expect(at[0]).toBe(0);
    expect(at.length).toBeGreaterThan(3);
    for (let i = 1; i < at.length; ++i) expect(at[i]! - at[i - 1]!).toBeGreaterThan(0.15);
});

it('bands have one colour each, from the first of the map to the last, and are equally wide', () => {
    const [whole, table] = [colourTable('viridis'), colourTable('viridis', false, 4)];
    const seen = Array.from({ length: tableSize }, (_, i) => table.slice(4 * i, 4 * i + 3).join());
    expect(new Set(seen).size).toBe(4);
    expect([seen[0], seen[255]]).toEqual([whole.slice(0, 3).join(), whole.slice(4 * 255, 4 * 255 + 3).join()]);
    expect(seen.map((each, i) => (each === seen[i - 1] ? 0 : i)).filter((i) => i > 0)).toEqual([64, 128, 192]);
    expect([0, 0.24, 0.26, 1].map((at) => banded(at, 4))).toEqual([0, 0, 1 / 3, 1]);
    expect(banded(0.3, 0)).toBe(0.3);
});

describe('drawnRange', () => {
    it('is what is asked for, and never empty', () => {
        expect(drawnRange([1, 3], 'even', null)).toEqual([1, 3]);
        expect(drawnRange([2, 2], 'even', null)).toEqual([2, 4]);
        expect(drawnRange([0, 0], 'even', null)).toEqual([0, 1]);
        expect(drawnRange([Infinity, -Infinity], 'even', null)).toEqual([0, 1]);
    });

    it('is symmetric round a centre and holds all that it held', () => {
        expect(drawnRange([-1, 3], 'even', 0)).toEqual([-3, 3]);
        expect(drawnRange([5, 6], 'even', 2)).toEqual([-2, 6]);
    });

    it('is positive where it is for logarithms', () => {
        expect(drawnRange([0.1, 10], 'log', null)).toEqual([0.1, 10]);
        expect(drawnRange([0, 10], 'log', null)).toEqual([0.01, 10]);
        expect(drawnRange([-5, -1], 'log', null)).toEqual([0.001, 1]);
    });
});

describe('fractionOf', () => {
    it('is linear inside the range and sticks to its ends', () => {
        expect([-1, 1, 2, 3, 9].map((v) => fractionOf(v, [1, 3]))).toEqual([0, 0, 0.5, 1, 1]);
    });

    it('is linear in the logarithm where that is asked for', () => {
        const fractions = [0, 0.01, 0.1, 1, 100, 1e4, -3].map((v) => fractionOf(v, [0.01, 100], 'log'));
        [0, 0, 0.25, 0.5, 1, 1, 0].forEach((expected, i) => expect(fractions[i]).toBeCloseTo(expected, 12));
    });

    it('does not divide by an empty range', () => {
        expect(fractionOf(5, [2, 2])).toBe(0);
    });
});

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

const values = (low: number, high: number, log: boolean): number[] =>
    colourTicks(low, high, log ? 'log' : 'even', 5).ticks.map(({ value }) => Number(value.toPrecision(6)) + 0);

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
