import { describe, expect, it } from 'vitest';
import { decodeMask, encodeMask, longestCode, maskSize, type MaskContent } from './maskCode.ts';

type Shape = (s: number, t: number) => boolean;

/** Revealed where the shape says so; s and t are 0 .. 1 of the mask. */
function painted(shape: Shape, tStart = -1.25, tLength = 7): MaskContent {
    const texels = new Uint8Array(maskSize * maskSize);
    texels.forEach((_, i) => {
        const [row, column] = [Math.floor(i / maskSize), i % maskSize];
        if (shape((column + 0.5) / maskSize, (row + 0.5) / maskSize)) texels[i] = 255;
    });
    return { texels, tStart, tLength };
}

function disc(s: number, t: number, radius: number): Shape {
    return (x, y) => Math.hypot(x - s, y - t) < radius;
}

const shapes: Record<string, Shape> = {
    nothing: () => false,
    everything: () => true,
    'a disc': disc(0.3, 0.6, 0.1),
    'a stroke and a hole': (s, t) => Math.abs(t - 0.3 - 0.2 * s) < 0.08 && !disc(0.5, 0.4, 0.03)(s, t),
    'the last row': (_s, t) => t > 1 - 4 / maskSize,
};

describe('the code of a mask', () => {
    it.each(Object.entries(shapes))('brings back %s, where it is in t, to a 128th', (_, shape) => {
        const mask = painted(shape);
        const code = encodeMask(mask)!;
        expect(code).toMatch(/^[\w-]+$/);
        expect(code.length).toBeLessThanOrEqual(longestCode);
        const back = decodeMask(code)!;
        expect([back.tStart, back.tLength]).toEqual([-1.25, 7]);
        const reach = maskSize / 128;
        const isSame = (i: number): boolean => back.texels[i] === mask.texels[i];
        // What differs is at a border of what was painted.
        const wrong = back.texels.findIndex((_value, i) => {
            if (isSame(i)) return false;
            const [row, column] = [Math.floor(i / maskSize), i % maskSize];
            for (let y = Math.max(0, row - reach); y <= Math.min(maskSize - 1, row + reach); ++y) {
                for (let x = Math.max(0, column - reach); x <= Math.min(maskSize - 1, column + reach); ++x) {
                    if (mask.texels[y * maskSize + x] !== mask.texels[i]) return false;
                }
            }
            return true;
        });
        expect(wrong).toBe(-1);
        // Said and read again it is the same.
        expect(decodeMask(encodeMask(back)!)!.texels.every((value, i) => value === back.texels[i])).toBe(true);
    });

    it('is coarser for what is intricate, and none for what is too much so', () => {
        const dots =
            (count: number): Shape =>
            (s, t) =>
                disc(0.5, 0.5, 0.3)((s * count) % 1, (t * count) % 1);
        const sizeOf = (shape: Shape): number | null => {
            const code = encodeMask(painted(shape));
            return code === null ? null : 2 ** atob(code.slice(0, 4).replaceAll('-', '+').replaceAll('_', '/')).charCodeAt(0);
        };
        expect([1, 3, 4].map((count) => sizeOf(dots(count)))).toEqual([256, 128, 64]);
        expect(sizeOf(dots(20))).toBeNull();
    });

    it('is nothing where someone has damaged it, and never more than a mask', () => {
        const good = encodeMask(painted(shapes['a disc']!))!;
        const head = (size: number, tStart: number, tLength: number, ...runs: number[]): string => {
            const view = new DataView(new ArrayBuffer(17));
            view.setUint8(0, size);
            view.setFloat64(1, tStart);
            view.setFloat64(9, tLength);
            return btoa(String.fromCharCode(...new Uint8Array(view.buffer), ...runs)).replace(/=+$/, '');
        };
        expect(decodeMask(head(6, 0, 1, 5, 3))).not.toBeNull();
        const bad = [
            ...['', '!', 'AAAA', good.slice(0, 20), good + good.repeat(10), 'ä'.repeat(40)],
            ...[head(5, 0, 1), head(9, 0, 1), head(255, 0, 1), head(6, Number.NaN, 1), head(6, 0, 0), head(6, 0, -1)],
            ...[
                head(6, 0, Number.POSITIVE_INFINITY),
                head(6, 0, 1, 255, 255, 255, 127),
                head(6, 0, 1, 255, 127, 1),
                head(6, 0, 1, 129),
            ],
        ];
        for (const text of bad) expect(decodeMask(text), text).toBeNull();
    });
});
