import { describe, expect, it } from 'vitest';
import {
    allShown,
    type ClipPlanes,
    decodeClip,
    decodeVisibility,
    encodeVisibility,
    noClip,
    planeNumbers,
    renamedVisibility,
    showsRake,
    showsSurface,
    toggled,
} from './pageView.ts';

const some = { hiddenRakes: new Set(['r2']), hiddenSurfaces: new Set(['s1']), alone: false, lockedRakes: new Set(['r1']) };

describe('what is shown', () => {
    it('is all but what is hidden, and a hidden rake hides its surfaces', () => {
        expect(['r1', 'r2'].map((rake) => showsRake(some, rake, 'r1'))).toEqual([true, false]);
        const surfaces = [
            { surface: 's1', rake: 'r1' },
            { surface: 's2', rake: 'r1' },
            { surface: 's3', rake: 'r2' },
        ];
        expect(surfaces.map((each) => showsSurface(some, each, 'r1'))).toEqual([false, true, false]);
    });

    it('is the chosen rake alone where that is asked for, though it is hidden otherwise', () => {
        const alone = { ...some, alone: true };
        expect(['r1', 'r2'].map((rake) => showsRake(alone, rake, 'r2'))).toEqual([false, true]);
        expect(showsRake(alone, 'r1', null)).toBe(true);
    });

    it('goes through a link unchanged, and takes no room there where everything is shown', () => {
        const encoded = encodeVisibility({ ...some, alone: true });
        expect(decodeVisibility(JSON.parse(JSON.stringify(encoded)))).toEqual({ ...some, alone: true });
        expect(encodeVisibility(allShown)).toBeUndefined();
    });

    it('is everything where a link is damaged', () => {
        for (const value of [null, 7, 'x', {}, { rakes: 7, surfaces: [3, null], locked: {}, alone: 'yes' }]) {
            expect(decodeVisibility(value)).toEqual(allShown);
        }
    });

    it('goes on under other names, without what is not there any more', () => {
        const renamed = renamedVisibility(some, new Map([['r2', 'r9']]), new Map([['s1', 's4']]));
        expect(renamed).toEqual({
            ...some,
            hiddenRakes: new Set(['r9']),
            hiddenSurfaces: new Set(['s4']),
            lockedRakes: new Set(),
        });
    });

    it('is switched on and off', () => {
        expect([...toggled(new Set(['a']), 'b')]).toEqual(['a', 'b']);
        expect([...toggled(new Set(['a', 'b']), 'a')]).toEqual(['b']);
    });
});

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
