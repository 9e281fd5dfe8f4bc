import { describe, expect, it } from 'vitest';
import { revealedAt } from '../../testing/revealedAt.ts';
import type { PickHit } from './pickHit.ts';
import { decodeMask, encodeMask, longestCode, type MaskContent, maskSize, SurfaceMask } from './surfaceMask.ts';

function hit(s: number, t: number, surface = 'a'): PickHit {
    return { surface, point: [s, t, 0], s, t, scalar: 0, distance: 1 };
}

/** The print of a brush on a surface seen straight on: s to the right, t downwards, `step` a pixel. */
function printAt(s: number, t: number, radiusPx: number, step: number, surface = 'a') {
    const size = 2 * radiusPx + 1;
    const hits = Array.from({ length: size * size }, (_, i) =>
        hit(s + ((i % size) - radiusPx) * step, t + (Math.floor(i / size) - radiusPx) * step, surface),
    );
    return { size, hits, radiusPx };
}

describe('SurfaceMask', () => {
    it('is revealed in a disc round the brush and nowhere else, without holes', () => {
        const mask = new SurfaceMask([0, 1]);
        // A pixel is more than four texels: what lies between pixels counts too.
        mask.stamp('a', printAt(0.5, 0.4, 10, 0.009), true);
        const texel = 1 / maskSize;
        for (let s = 0.3; s < 0.7; s += texel) {
            for (let t = 0.2; t < 0.6; t += texel) {
                const px = Math.hypot(s - 0.5, t - 0.4) / 0.009;
                if (px < 8.8) expect(revealedAt(mask, s, t), `${px} px`).toBe(true);
                if (px > 11.5) expect(revealedAt(mask, s, t), `${px} px`).toBe(false);
            }
        }
    });

    it('is hidden again by erasing, and all at once by filling', () => {
        const mask = new SurfaceMask([0, 1]);
        mask.fill(true);
        mask.stamp('a', printAt(0.5, 0.5, 5, 0.002), false);
        expect(revealedAt(mask, 0.5, 0.5)).toBe(false);
        expect(revealedAt(mask, 0.6, 0.5)).toBe(true);
        mask.fill(false);
        expect(revealedAt(mask, 0.6, 0.5)).toBe(false);
    });

    it('leaves alone what is of another surface, and what lies between two folds', () => {
        const mask = new SurfaceMask([0, 1]);
        mask.stamp('a', printAt(0.5, 0.5, 3, 0.002, 'b'), true);
        expect(revealedAt(mask, 0.5, 0.5)).toBe(false);
        const folds = { size: 3, radiusPx: 2, hits: [0.1, 0.9, 0.1, 0.9, 0.1, 0.9, 0.1, 0.9, 0.1].map((s) => hit(s, 0.5)) };
        mask.stamp('a', folds, true);
        expect([0.1, 0.3, 0.5, 0.9].map((s) => revealedAt(mask, s, 0.5))).toEqual([true, false, false, true]);
    });

    it('keeps what is revealed at its t while the surface goes on, in both directions', () => {
        const mask = new SurfaceMask([2, 4]);
        mask.stamp('a', printAt(0.5, 3, 8, 0.01), true);
        mask.cover([-7, 11]);
        expect(mask.tStart).toBeLessThanOrEqual(-7);
        expect(mask.tStart + mask.tLength).toBeGreaterThanOrEqual(11);
        expect([2.5, 3, 3.5, -6.9, 10.9].map((t) => revealedAt(mask, 0.5, t))).toEqual([false, true, false, false, false]);
    });

    it('goes on from its code as it was, and covers more like it', () => {
        const mask = new SurfaceMask([2, 4]);
        mask.stamp('a', printAt(0.5, 3, 8, 0.01), true);
        const again = new SurfaceMask([0, 1], decodeMask(mask.code!));
        for (const each of [mask, again]) each.cover([2, 9]);
        expect([again.tStart, again.tLength]).toEqual([mask.tStart, mask.tLength]);
        for (const s of [0.3, 0.45, 0.5, 0.55, 0.7]) {
            for (const t of [2.5, 2.95, 3, 3.05, 3.5]) expect(revealedAt(again, s, t)).toBe(revealedAt(mask, s, t));
        }
        // Not the code of what it was before.
        const code = mask.code;
        mask.stamp('a', printAt(0.2, 6, 8, 0.01), true);
        expect(mask.code).not.toBe(code);
    });
});

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
