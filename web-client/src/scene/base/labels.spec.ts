import { describe, expect, it } from 'vitest';
import { coverOf, isCovered, placeOf } from './labels.ts';

const picture = { right: 900, bottom: 600, width: 900, height: 600 };
const bar = { right: 888, bottom: 588, width: 260, height: 60 };
const half = { width: 10, height: 7 };

describe('the bar over the picture', () => {
    it('stays as far from the lower right in a picture of another size', () => {
        const cover = coverOf(picture, bar)!;
        expect(placeOf(cover, picture)).toEqual({ x: 628, y: 528 });
        expect(placeOf(cover, { width: 500, height: 300 })).toEqual({ x: 228, y: 228 });
    });

    it('comes into the corner of a figure from beside the picture, and covers nothing where it is not', () => {
        expect(coverOf(picture, { ...bar, right: 700, bottom: 680 })).toMatchObject({ right: 200, bottom: 12 });
        expect(coverOf(picture, { ...bar, width: 0, height: 0 })).toBeNull();
    });

    it('covers words that reach into it by a pixel, and none that touch its edge', () => {
        const cover = coverOf(picture, bar)!;
        const covered = (x: number, y: number): boolean => isCovered({ x, y }, half, cover, picture);
        expect(covered(700, 550)).toBe(true);
        expect([covered(617, 550), covered(619, 550)]).toEqual([false, true]);
        expect([covered(700, 521), covered(700, 522)]).toEqual([false, true]);
        expect([covered(899, 550), covered(700, 596)]).toEqual([false, false]);
    });
});
