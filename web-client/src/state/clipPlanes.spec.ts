import { describe, expect, it } from 'vitest';
import { type ClipPlanes, decodeClip, noClip, planeNumbers } from './clipPlanes.ts';

const bounds = [-2, 6, 0, 1, 10, 20];
const plane = { on: true, at: 0.25, flipped: false };

function isCut(clip: ClipPlanes, point: readonly number[]): boolean {
    return planeNumbers(clip, bounds).some(([x, y, z, w]) => x * point[0]! + y * point[1]! + z * point[2]! > w);
}

describe('clip planes', () => {
    it('cut away what lies beyond them, or before them when flipped', () => {
        const clip: ClipPlanes = { planes: [plane, noClip.planes[1], { ...plane, flipped: true }], body: false };
        expect(isCut(clip, [-0.1, 0.5, 15])).toBe(false);
        expect(isCut(clip, [0.1, 0.5, 15])).toBe(true);
        expect(isCut(clip, [-1, 0.5, 12.4])).toBe(true);
        expect(isCut(clip, [-1, 99, 12.6])).toBe(false);
    });

    it('cut nothing while they are off', () => {
        expect(isCut(noClip, [1e9, -1e9, 1e9])).toBe(false);
    });

    it('come back from JSON, and from garbage as none', () => {
        const clip: ClipPlanes = { planes: [plane, noClip.planes[1], plane], body: true };
        expect(decodeClip(JSON.parse(JSON.stringify(clip)))).toEqual(clip);
        for (const garbage of [null, 3, {}, { planes: 'x' }, { planes: [{ on: 1, at: 2 }, null] }]) {
            expect(decodeClip(garbage)).toEqual(noClip);
        }
    });
});
