import { describe, expect, it } from 'vitest';
import type { AnimationDescription } from './animationFile.ts';
import { colourChoices, wishOf } from './animationLook.ts';

const values = [
    { name: 'p', title: 'Pressure', range: [-0.97, 1.94], signed: true },
    { name: 'speed', title: 'Speed', range: [0.02, 2.93], signed: false },
    { name: 't', title: 'Age', range: [0, 5], signed: false },
];
const described = (look?: unknown): AnimationDescription =>
    ({ kind: 'streak', from: 4, values, look }) as unknown as AnimationDescription;

describe('the colours of an animation', () => {
    it('are those of its values, over all steps, where nobody has chosen any', () => {
        const [first, second, third] = colourChoices(described());
        expect(first!.style).toMatchObject({ scalar: 'p', map: 'coolToWarm', centre: 0, range: [-1, 2] });
        expect(second!.style).toMatchObject({ source: 'scalar', scalar: 'speed', map: 'viridis', range: [0, 3], centre: null });
        // The frames have the time of release.
        expect(third!.style).toMatchObject({ source: 'age', tIsRelease: true, tOrigin: 4, range: [0, 5] });
    });

    it('begin with those that the page showed, and keep the rest of the look for others', () => {
        const choices = colourChoices(described({ source: 'scalar', scalar: 'speed', map: 'grey', opacity: 0.5 }));
        expect(choices.map(({ title }) => title)).toEqual(['Speed', 'Pressure', 'Age']);
        expect(choices[0]!.style).toMatchObject({ map: 'grey', range: [0, 3], opacity: 0.5 });
        expect(choices[1]!.style).toMatchObject({ map: 'coolToWarm', opacity: 0.5 });
    });

    it('have the range that a user locked', () => {
        expect(colourChoices(described({ source: 'scalar', scalar: 'p', range: [0, 1] }))[0]!.style).toMatchObject({
            map: 'viridis',
            range: [0, 1],
            centre: null,
        });
    });

    it('may be one colour, or the place along the rake', () => {
        const one = colourChoices(described({ source: 'constant', scalar: '', colour: '#ff0000' }))[0]!;
        expect(one).toMatchObject({ title: 'One colour', style: { source: 'constant', colour: '#ff0000' } });
        expect(colourChoices(described({ source: 's', scalar: '' }))[0]!.title).toBe('Place along the rake');
    });

    it('are the usual ones where the file lacks what the page showed', () => {
        expect(colourChoices(described({ source: 'scalar', scalar: 'twin_distance' }))).toHaveLength(3);
    });

    it('take of each step what the look needs, and no more', () => {
        const { style } = colourChoices(described({ source: 'scalar', scalar: 'p', pieces: 'arrows', hatchAbove: 0.1 }))[0]!;
        expect(wishOf(style)).toEqual({
            attributes: ['p', 'velocity_x', 'velocity_y', 'velocity_z', 'interval_error'],
            parts: null,
            trimmed: true,
            units: 'open',
        });
    });
});
