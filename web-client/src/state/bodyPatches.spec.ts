import { describe, expect, it } from 'vitest';
import { hasBoundary, hiddenCells, type Patch, patchId, showsBeyondBody, showsPatch } from './bodyPatches.ts';

const patches: Patch[] = [
    { name: 'hull', kind: 'wall', triangles: 10 },
    { name: 'ground', kind: 'wall', triangles: 5 },
    { name: 'ground', kind: 'side', triangles: 7 },
    { name: 'inlet', kind: 'other', triangles: 2 },
];
const dataset = { obstacle: true, patches };
const look = (...toggled: string[]) => ({ patches: toggled });

describe('patches of the boundary', () => {
    it('are seen if they are walls of the body, unless that is changed', () => {
        expect(patches.map((patch) => showsPatch(look(), patch))).toEqual([true, true, false, false]);
        expect(patches.map((patch) => showsPatch(look('ground', 'inlet (other)'), patch))).toEqual([true, false, false, true]);
    });
    it('of one name and several kinds are shown apart', () => {
        expect(new Set(patches.map(patchId)).size).toBe(4);
    });
    it('are all there is of a boundary without a body', () => {
        expect(hasBoundary({ obstacle: false, patches })).toBe(true);
        expect(hasBoundary({ obstacle: false })).toBe(false);
        expect(hasBoundary(null)).toBe(false);
    });
    it('are fetched with the body only when one that is no part of it is shown', () => {
        expect(showsBeyondBody(dataset, look('hull'))).toBe(false);
        expect(showsBeyondBody(dataset, look('ground (side)'))).toBe(true);
        expect(showsBeyondBody({ obstacle: true }, look('ground (side)'))).toBe(false);
    });
});

describe('cells that are not seen', () => {
    it('are none of a body that is shown whole', () => {
        expect(hiddenCells(dataset, look(), false)).toEqual([]);
        expect(hiddenCells({ obstacle: true }, look('hull'), false)).toEqual([]);
    });
    it('are those of a hidden wall, with what closes the body', () => {
        expect(hiddenCells(dataset, look('ground'), false)).toEqual([
            [10, 15],
            [15, Infinity],
        ]);
    });
    it('are also those of sides that are fetched with another one', () => {
        expect(hiddenCells(dataset, look('inlet (other)'), true)).toEqual([[15, 22]]);
    });
    it('are also those of all sides and inlets that are in the picture until the body alone has come', () => {
        const hidden = hiddenCells(dataset, look(), true);
        expect(hidden.some(([from, to]) => from <= 15 && to >= 22) || hidden.length > 1).toBe(true);
    });
});
