import { describe, expect, it } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { usualLook } from '../../state/surfaceLook.ts';
import { ViewState } from '../../state/viewState.ts';
import { sampleSurface } from '../../testing/records.ts';
import { meshTimeWords, pieceText, timeInName } from './exportNames.ts';

function wordsOf(kind: 'stream' | 'streak', clock: { time: number | null; playing: boolean } | null): string {
    const state = new AppState();
    state.surfaces.value = new Map([['s1', sampleSurface({ kind, from: 9, to: 14 })]]);
    state.activeSurface.value = 's1';
    if (clock !== null) state.clock.value = { ...clock, rev: 1, speed: 1, loop: false, from: 9, to: 14 } as never;
    return meshTimeWords(state, new ViewState());
}

describe('the time of an exported mesh', () => {
    it('is that of the clock, as far as the surface has it', () => {
        expect(wordsOf('streak', { time: 11, playing: false })).toBe('As it is at t = 11, the time of the clock.');
        expect(wordsOf('streak', { time: 20, playing: false })).toBe('As it is at t = 14, the time of the clock.');
        expect(wordsOf('streak', { time: null, playing: false })).toBe('As it is at its end, t = 14.');
        expect(wordsOf('streak', { time: 11, playing: true })).toContain('when you press');
    });

    it('is the release of a stream surface, whatever the clock says', () => {
        expect(wordsOf('stream', { time: 11, playing: true })).toBe('Of the flow as it is at t = 9.');
        expect(wordsOf('stream', null)).toBe('Of the flow as it is at t = 9.');
    });

    it('can stand in the name of a file', () => {
        expect([timeInName(8.5), timeInName(0.1 + 0.2), timeInName(-2)]).toEqual(['t8.5', 't0.3', 't-2']);
    });
});

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
