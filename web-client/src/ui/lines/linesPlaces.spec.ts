import { expect, it } from 'vitest';
import type { Patch } from '../../state/bodyPatches.ts';
import { alongWalls, inletAmong, offWalls, patchNames, seedsWords } from './linesPlaces.ts';

const patches: Patch[] = [
    { name: 'hull', kind: 'wall', triangles: 9 },
    { name: 'hull', kind: 'side', triangles: 9 },
    { name: 'outlet', kind: 'other', triangles: 9 },
    { name: 'velocity-inlet', kind: 'other', triangles: 9 },
];

it('seeds at a patch begin at an inlet, and each name is offered once, first those where flow comes in or goes out', () => {
    expect(inletAmong(patches)).toBe('velocity-inlet');
    expect(inletAmong(patches.slice(0, 3))).toBe('outlet');
    expect(inletAmong(undefined)).toBeUndefined();
    expect(patchNames(patches)).toEqual(['outlet', 'velocity-inlet', 'hull']);
});

it('seeds at walls and patches are said in words', () => {
    const bounds = [0, 1, 0, 0, 0, 0] as const;
    expect(seedsWords(offWalls(bounds))).toBe('100 from 0.005 off the walls');
    expect(seedsWords(offWalls(bounds, ['hull']))).toMatch(/^100 from 0.005 off .*hull/);
    expect(seedsWords(alongWalls())).toBe('200 along walls');
    expect(seedsWords(alongWalls(['hull', 'wing']))).toMatch(/^200 along .*hull.*, .*wing/);
});
