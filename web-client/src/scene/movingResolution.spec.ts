import { describe, expect, it } from 'vitest';
import { leastRatio, limitMs, MovingResolution } from './movingResolution.ts';

/** Draws on graphics that take so long for the picture, and so long for a whole pixel of CSS; ratios as they
 *  come. */
function drawOn(resolution: MovingResolution, pictures: number, fixedMs: number, msPerPixel: number): number[] {
    return Array.from({ length: pictures }, () => {
        const { ratio } = resolution;
        resolution.drawn(fixedMs + msPerPixel * ratio ** 2);
        return ratio;
    });
}

describe('the resolution while things move', () => {
    it('stays full where pictures are quick', () => {
        const ratios = drawOn(new MovingResolution(2, 2), 100, 4, 3);
        expect(new Set(ratios)).toEqual(new Set([2]));
    });

    it('becomes the highest at which a picture keeps the limit, within a second of slow ones', () => {
        const ratios = drawOn(new MovingResolution(1, 1), 40, 10, 100);
        // 10 + 100 / 4 = 35 ms; at half of the pixels it would be 60 ms.
        expect(ratios.slice(6)).toEqual(Array(34).fill(0.5));
        expect(10 + 100 * ratios.at(-1)! ** 2).toBeLessThan(limitMs);
    });

    it('never falls below the least, however slow pictures are', () => {
        for (const full of [1, 1.5, 2]) {
            const ratios = drawOn(new MovingResolution(full, full), 200, 900, 900);
            expect(Math.min(...ratios)).toBeGreaterThanOrEqual(leastRatio);
            expect(ratios.at(-1)).toBeLessThan(1.5 * leastRatio);
        }
        expect(new MovingResolution(0.3, 0.3).ratio).toBe(0.3);
    });

    it('comes back where pictures have become quick, and does not go to and fro at any speed', () => {
        const resolution = new MovingResolution(1, 1);
        drawOn(resolution, 40, 300, 0);
        expect(drawOn(resolution, 60, 2, 10).at(-1)).toBe(1);
        for (let msPerPixel = 1; msPerPixel < 1000; msPerPixel *= 1.13) {
            const ratios = drawOn(new MovingResolution(1, 0.5), 400, 8, msPerPixel).slice(60);
            expect(new Set(ratios).size, `${msPerPixel} ms`).toBe(1);
        }
    });

    it('does not mind a late picture now and then', () => {
        const resolution = new MovingResolution(1, 1);
        for (let i = 0; i < 300; ++i) resolution.drawn(i % 3 === 0 ? 400 : 30);
        expect(resolution.ratio).toBe(1);
    });

    it('begins where it is told to', () => {
        expect(new MovingResolution(1, 0.5).ratio).toBe(0.5);
        expect(new MovingResolution(2, 2).ratio).toBe(2);
    });
});
