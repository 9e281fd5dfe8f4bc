import { describe, expect, it } from 'vitest';
import { colorTable, fractionOf } from './colorMap.ts';

function luminance(r: number, g: number, b: number): number {
    const linear = (c: number): number =>
        c <= 0.04045 * 255 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4;
    return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

describe('colorTable', () => {
    const table = colorTable();

    it('runs from dark violet to bright yellow', () => {
        expect([...table.slice(0, 4)]).toEqual([0x44, 0x01, 0x54, 255]);
        expect([...table.slice(-4)]).toEqual([0xfd, 0xe7, 0x25, 255]);
    });

    it('grows brighter all the way, so that it can be read without colour', () => {
        let before = -1;
        for (let i = 0; i < 256; i += 8) {
            const now = luminance(table[4 * i]!, table[4 * i + 1]!, table[4 * i + 2]!);
            expect(now, `entry ${i}`).toBeGreaterThan(before);
            before = now;
        }
    });
});

describe('fractionOf', () => {
    it('is linear inside the range and sticks to its ends', () => {
        expect([-1, 1, 2, 3, 9].map((v) => fractionOf(v, [1, 3]))).toEqual([0, 0, 0.5, 1, 1]);
    });

    it('does not divide by an empty range', () => {
        expect(fractionOf(5, [2, 2])).toBe(0);
    });
});
