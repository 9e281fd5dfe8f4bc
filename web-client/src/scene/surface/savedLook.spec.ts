import { describe, expect, it } from 'vitest';
import { readLook, savedLook, withoutColours } from './savedLook.ts';
import { plainStyle } from './surfaceStyle.ts';

const drawn = { ...plainStyle, scalar: 'p', map: 'inferno' as const, opacity: 0.5, range: [0, 2] as const, texture: true };

describe('a saved look', () => {
    it('is what differs from the plain style, and a range only where a user chose it', () => {
        expect(savedLook(drawn)).toEqual({ source: 'scalar', scalar: 'p', map: 'inferno', opacity: 0.5, texture: true });
        expect(savedLook({ ...drawn, rangeOf: 'locked' }).range).toEqual([0, 2]);
    });

    it('comes back the same as text', () => {
        const look = savedLook({ ...drawn, rangeOf: 'data', centre: 1, sWindow: [0, 0.5], pieces: 'arrows', hatchAbove: 0.1 });
        expect(readLook(JSON.parse(JSON.stringify(look)))).toEqual(look);
    });

    it('of a stranger is read without what is not of its type', () => {
        const wrong = {
            map: 'x',
            range: [1],
            opacity: '1',
            colour: 'url(x)',
            centre: null,
            painting: true,
            constructor: 1,
            smoke: 0.5,
        };
        expect(readLook(wrong)).toEqual({ smoke: 0.5 });
        expect(readLook('viridis')).toEqual({});
        expect(readLook(null)).toEqual({});
    });

    it('loses its colours for another value, and nothing else', () => {
        expect(withoutColours(savedLook(drawn))).toEqual({ opacity: 0.5, texture: true });
    });
});
