import { describe, expect, it } from 'vitest';
import { barIn, layoutOf, sizeFault, tilesOf, withoutBackground } from './capture.ts';

/** What is seen of a colour with this opacity before a ground, as browsers compose it. */
const before = (ground: number, value: number, alpha: number): number => Math.round(value * alpha + ground * (1 - alpha));

describe('withoutBackground', () => {
    it('finds colour and opacity again, within the rounding of the two pictures', () => {
        for (const alpha of [0, 0.1, 0.5, 0.9, 1]) {
            const colour = [10, 128, 250];
            const on = (ground: number) => Uint8ClampedArray.from([...colour.map((value) => before(ground, value, alpha)), 255]);
            const found = on(0);
            withoutBackground(found, on(255));
            expect(Math.abs(found[3]! - 255 * alpha)).toBeLessThanOrEqual(1);
            if (alpha === 0) expect([...found]).toEqual([0, 0, 0, 0]);
            else colour.forEach((value, k) => expect(Math.abs(found[k]! - value)).toBeLessThanOrEqual(1.5 / alpha));
        }
    });
});

describe('sizeFault', () => {
    it('says what is wrong with a size', () => {
        expect(sizeFault({ width: 1920, height: 1080 })).toBeNull();
        expect(sizeFault({ width: 16_384, height: 7000 })).toBeNull();
        expect(sizeFault({ width: 16_385, height: 10 })).toMatch(/at least 16/);
        expect(sizeFault({ width: 16_385, height: 100 })).toMatch(/at most 16384 pixels/);
        expect(sizeFault({ width: 16_384, height: 8000 })).toMatch(/at most 128 million pixels/);
        expect(sizeFault({ width: Number.NaN, height: 100 })).toMatch(/whole numbers/);
        expect(sizeFault({ width: 100.5, height: 100 })).toMatch(/whole numbers/);
    });
});

/** The scalar bar of one field. */
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

describe('tiles', () => {
    it('are one where the picture can be drawn at once, without a margin', () => {
        const whole = { x: 0, y: 0, width: 300, height: 200 };
        expect(tilesOf({ width: 300, height: 200 }, 300, 20)).toEqual([{ drawn: whole, inner: whole }]);
    });

    it.each([
        { width: 301, height: 200, side: 300, margin: 20 },
        { width: 97, height: 451, side: 64, margin: 13 },
        { width: 640, height: 5, side: 33, margin: 0 },
        // As of a page so low that handles are larger than tiles.
        { width: 97, height: 451, side: 64, margin: 400 },
        { width: 50, height: 31, side: 8, margin: 24 },
        { width: 50, height: 31, side: 13, margin: 24 },
    ])(
        'keep each pixel of $width x $height once, with the margin round it, from even places on',
        ({ width, height, side, margin }) => {
            const counts = new Uint8Array(width * height);
            for (const { drawn, inner } of tilesOf({ width, height }, side, margin)) {
                expect(Math.max(drawn.width, drawn.height)).toBeLessThanOrEqual(side);
                expect([drawn.x % 2, drawn.y % 2].map(Math.abs)).toEqual([0, 0]);
                const margins = [
                    ...(width > side ? [inner.x - drawn.x, drawn.x + drawn.width - inner.x - inner.width] : []),
                    ...(height > side ? [inner.y - drawn.y, drawn.y + drawn.height - inner.y - inner.height] : []),
                ];
                expect(Math.min(...margins)).toBeGreaterThanOrEqual(Math.min(margin, Math.floor(side / 4)));
                for (let y = inner.y; y < inner.y + inner.height; ++y) {
                    for (let x = inner.x; x < inner.x + inner.width; ++x) ++counts[y * width + x]!;
                }
            }
            expect(counts.every((count) => count === 1)).toBe(true);
        },
    );
});
