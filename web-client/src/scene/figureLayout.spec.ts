import { describe, expect, it } from 'vitest';
import { barIn, layoutOf } from './figureLayout.ts';

/** Is the scalar bar of one field. */
const bar = { width: 288, height: 66, right: 12, bottom: 12 };
const number = 12;

describe('layoutOf', () => {
    it('is as tall as the picture on the page, and at most 720, where the figure is large', () => {
        expect(layoutOf({ width: 1800, height: 1200 }, 600)).toEqual({ width: 900, height: 600, pixelRatio: 2 });
        expect(layoutOf({ width: 2880, height: 1440 }, 1400)).toEqual({ width: 1440, height: 720, pixelRatio: 2 });
    });

    it.each([0, 1, 40, 600, 1400])(
        'has letters that can be read and are no giants in small figures, of a page %d high',
        (page) => {
            for (const [width, height] of [
                [300, 200],
                [640, 400],
                [64, 64],
                [400, 300],
                [900, 600],
            ] as const) {
                const { pixelRatio, ...layout } = layoutOf({ width, height }, page);
                expect(number * pixelRatio).toBeGreaterThanOrEqual(9);
                expect(number * pixelRatio).toBeLessThanOrEqual(Math.max(9, height / 30));
                expect(layout.width * pixelRatio).toBeCloseTo(width);
                expect(layout.height * pixelRatio).toBeCloseTo(height);
            }
        },
    );

    it('is wide enough for the bar where the figure is narrow', () => {
        expect(layoutOf({ width: 720, height: 1440 }, 720).width).toBe(360);
    });
});

describe('barIn', () => {
    it('is in figures of 300 x 200 and more, whole', () => {
        for (const [width, height] of [
            [300, 200],
            [640, 400],
            [480, 960],
        ] as const) {
            for (const place of [bar, { ...bar, right: 250 }]) {
                const layout = layoutOf({ width, height }, 0);
                const { right, bottom } = barIn(layout, place)!;
                expect(right).toBeGreaterThan(0);
                expect(layout.width - right - bar.width).toBeGreaterThan(0);
                expect(layout.height - bottom - bar.height).toBeGreaterThan(0);
            }
        }
    });

    it('is not where it would be wider or much of the height', () => {
        expect(barIn(layoutOf({ width: 200, height: 200 }, 0), bar)).toBeNull();
        expect(barIn(layoutOf({ width: 600, height: 100 }, 0), bar)).toBeNull();
        expect(barIn(layoutOf({ width: 300, height: 200 }, 0), { ...bar, height: 264 })).toBeNull();
    });
});
