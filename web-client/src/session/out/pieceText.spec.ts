import { describe, expect, it } from 'vitest';
import { usualLook } from '../../state/surfaceLook.ts';
import { pieceText } from './pieceText.ts';

describe('what is shown of a surface, as the server names it', () => {
    it('is called as the kind has it, with lengths that follow the domain where none are said', () => {
        const bounds: [number, number, number, number, number, number] = [0, 3, 0, 4, 0, 12];
        const text = (pieces: typeof usualLook.pieces, kind: 'stream' | 'streak' | 'time', every: number | null = null) =>
            pieceText({ ...usualLook, pieces, pieceEvery: every }, { kind }, bounds);
        expect(text('whole', 'stream')).toBeNull();
        expect(text('seedlines', 'stream')).toBe('streamlines:every=1');
        expect(text('timelines', 'streak', 0.25)).toBe('timelines:every=0.25');
        expect(text('seedribbons', 'streak', 0.6)).toBe('streakribbons:every=0.6,width=0.2');
        expect(text('arrows', 'time', 2)).toBe('arrows:every=2,width=0.4');
        expect(pieceText({ ...usualLook, points: true, pieces: 'arrows' }, { kind: 'level' }, bounds)).toBe('points');
        // All of a time surface is one age.
        expect(text('timelines', 'time')).toBeNull();
    });
});
