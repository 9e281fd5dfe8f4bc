import { describe, expect, it } from 'vitest';
import { furthestPx, pairOffsets, pairs } from './contactShade.ts';

describe('pairs of pixels', () => {
    it.each([
        [4, pairs.page],
        [8, pairs.page],
        [4, pairs.figure],
        [8, pairs.figure],
    ])('of %d pictures, %d each, look in all directions and at all distances, none twice', (samples, each) => {
        const all = Array.from({ length: samples }, (_, sample) => pairOffsets({ sample, samples, pairs: each })).flat();
        const count = samples * each;
        const angles = all.map(([x, y]) => Math.atan2(y, x)).sort((a, b) => a - b);
        angles.forEach((angle, i) => expect(angle).toBeCloseTo((Math.PI * i) / count, 9));
        const reaches = all.map(([x, y]) => Math.hypot(x, y)).sort((a, b) => a - b);
        reaches.slice(1).forEach((reach, i) => expect(reach - reaches[i]!).toBeCloseTo((furthestPx - 2) / count, 9));
        expect(reaches.at(-1)!).toBeLessThan(furthestPx);
    });
});
