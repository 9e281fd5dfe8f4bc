import { describe, expect, it } from 'vitest';
import { revealedAt } from '../../testing/revealedAt.ts';
import { decodeMask, maskSize } from './maskCode.ts';
import { SurfaceMask } from './surfaceMask.ts';
import type { PickHit } from './pickHit.ts';

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
