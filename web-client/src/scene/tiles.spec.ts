import { describe, expect, it } from 'vitest';
import { tilesOf } from './tiles.ts';

describe('tiles', () => {
    it('are one where the picture can be drawn at once, without a margin', () => {
        const whole = { x: 0, y: 0, width: 300, height: 200 };
        expect(tilesOf({ width: 300, height: 200 }, 300, 20)).toEqual([{ drawn: whole, kept: whole }]);
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
            for (const { drawn, kept } of tilesOf({ width, height }, side, margin)) {
                expect(Math.max(drawn.width, drawn.height)).toBeLessThanOrEqual(side);
                expect([drawn.x % 2, drawn.y % 2].map(Math.abs)).toEqual([0, 0]);
                const margins = [
                    ...(width > side ? [kept.x - drawn.x, drawn.x + drawn.width - kept.x - kept.width] : []),
                    ...(height > side ? [kept.y - drawn.y, drawn.y + drawn.height - kept.y - kept.height] : []),
                ];
                expect(Math.min(...margins)).toBeGreaterThanOrEqual(Math.min(margin, Math.floor(side / 4)));
                for (let y = kept.y; y < kept.y + kept.height; ++y) {
                    for (let x = kept.x; x < kept.x + kept.width; ++x) ++counts[y * width + x]!;
                }
            }
            expect(counts.every((count) => count === 1)).toBe(true);
        },
    );
});
