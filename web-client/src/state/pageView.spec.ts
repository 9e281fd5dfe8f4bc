import { describe, expect, it } from 'vitest';
import {
    allShown,
    bodyId,
    chosenRake,
    type ClipPlanes,
    decodeClip,
    decodeVisibility,
    encodeVisibility,
    noClip,
    planeNumbers,
    renamedClip,
    type SlicePlane,
    renamedVisibility,
    shows,
    showsSurface,
    toggled,
} from './pageView.ts';

const some = { hidden: new Set(['r2', 's1']), only: null, opacities: new Map([['c1', 0.5]]), lockedRakes: new Set(['r1']) };

describe('what is shown', () => {
    it('is all but what is hidden, and a hidden rake hides its surfaces', () => {
        expect(['r1', 'r2', 'c1', bodyId].map((id) => shows(some, id, 'r1'))).toEqual([true, false, true, true]);
        const surfaces = [
            { surface: 's1', rake: 'r1' },
            { surface: 's2', rake: 'r1' },
            { surface: 's3', rake: 'r2' },
            { surface: 's4' },
        ];
        expect(surfaces.map((each) => showsSurface(some, each, 'r1'))).toEqual([false, true, false, true]);
    });

    it('is one thing alone where that is asked for, though it is hidden otherwise; a rake with its surfaces', () => {
        const only = (id: string) => ({ ...some, only: id });
        expect(['r1', 'r2', 'c1', bodyId].map((id) => shows(only('r2'), id))).toEqual([false, true, false, false]);
        expect(shows(only(bodyId), bodyId)).toBe(true);
        expect(showsSurface(only('r2'), { surface: 's3', rake: 'r2' }, null)).toBe(true);
        expect(showsSurface(only('r2'), { surface: 's4' }, null)).toBe(false);
        expect(showsSurface(only('s4'), { surface: 's4' }, null)).toBe(true);
    });

    it('goes through a link unchanged, and takes no room there where everything is shown', () => {
        for (const each of [some, { ...some, only: 's4' }]) {
            expect(decodeVisibility(JSON.parse(JSON.stringify(encodeVisibility(each))))).toEqual(each);
        }
        expect(encodeVisibility(allShown)).toBeUndefined();
    });

    it('is what links of old say, which name rakes and surfaces apart and know the chosen rake alone', () => {
        const old = decodeVisibility({ rakes: ['r2'], surfaces: ['s1'], alone: true, locked: ['r1'] });
        expect(old).toEqual({ ...some, only: chosenRake, opacities: new Map() });
        expect(['r1', 'r2'].map((rake) => shows(old, rake, 'r2'))).toEqual([false, true]);
        expect(shows(old, 'r1', null)).toBe(true);
    });

    it('is everything where a link is damaged', () => {
        for (const value of [
            null,
            7,
            'x',
            {},
            { rakes: 7, surfaces: [3, null], locked: {}, alone: 'yes', opacities: { c1: 7 } },
        ]) {
            expect(decodeVisibility(value)).toEqual(allShown);
        }
    });

    it('goes on under other names, without what is not there any more', () => {
        const renamed = renamedVisibility({ ...some, only: 's1' }, new Map([['r2', 'r9']]), new Map([['s1', 's4']]));
        expect(renamed).toEqual({ hidden: new Set(['r9', 's4']), only: 's4', opacities: new Map(), lockedRakes: new Set() });
    });

    it('is switched on and off', () => {
        expect([...toggled(new Set(['a']), 'b')]).toEqual(['a', 'b']);
        expect([...toggled(new Set(['a', 'b']), 'a')]).toEqual(['b']);
    });
});

const bounds = [-2, 6, 0, 1, 10, 20];
const plane = { on: true, at: 0.25, flipped: false };

function isCut(clip: ClipPlanes, point: readonly number[], cutting: SlicePlane | null = null): boolean {
    return planeNumbers(clip, bounds, cutting).some(([x, y, z, w]) => x * point[0]! + y * point[1]! + z * point[2]! > w);
}

describe('clip planes', () => {
    it('cut away what lies beyond them, or before them when flipped', () => {
        const clip: ClipPlanes = { ...noClip, planes: [plane, noClip.planes[1], { ...plane, flipped: true }] };
        expect(isCut(clip, [-0.1, 0.5, 15])).toBe(false);
        expect(isCut(clip, [0.1, 0.5, 15])).toBe(true);
        expect(isCut(clip, [-1, 0.5, 12.4])).toBe(true);
        expect(isCut(clip, [-1, 99, 12.6])).toBe(false);
    });

    it('cut at a slice: what is on the side of its normal, or on the other when flipped; nothing once it is gone', () => {
        const slice: SlicePlane = { origin: [1, 0, 12], normal: [0.6, 0, 0.8] };
        const at = (flipped: boolean): ClipPlanes => ({ ...noClip, slice: { id: 'p1', flipped } });
        const [beyond, before] = [
            [1.6, 5, 12.8],
            [0.4, -5, 11.2],
        ];
        expect([isCut(at(false), beyond, slice), isCut(at(false), before, slice)]).toEqual([true, false]);
        expect([isCut(at(true), beyond, slice), isCut(at(true), before, slice)]).toEqual([false, true]);
        expect(isCut(at(false), beyond, null)).toBe(false);
        const long: SlicePlane = { origin: [0, 0, 3], normal: [0, 0, 2] };
        expect(planeNumbers(at(false), bounds, long).at(-1)).toEqual([0, 0, 1, 3]);
    });

    it('follow their slice to its new name, and go with it', () => {
        const clip: ClipPlanes = { ...noClip, slice: { id: 'p1', flipped: true } };
        expect(renamedClip(clip, new Map([['p1', 'p4']])).slice).toEqual({ id: 'p4', flipped: true });
        expect(renamedClip(clip, new Map())).toEqual(noClip);
    });

    it('cut nothing while they are off', () => {
        expect(isCut(noClip, [1e9, -1e9, 1e9])).toBe(false);
    });

    it('come back from JSON, and from garbage as none', () => {
        const clip: ClipPlanes = { planes: [plane, noClip.planes[1], plane], slice: { id: 'p1', flipped: true }, body: true };
        expect(decodeClip(JSON.parse(JSON.stringify(clip)))).toEqual(clip);
        for (const garbage of [null, 3, {}, { planes: 'x' }, { planes: [{ on: 1, at: '2' }, null], slice: { id: 3 } }]) {
            expect(decodeClip(garbage)).toEqual(noClip);
        }
    });
});
