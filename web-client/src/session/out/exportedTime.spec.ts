import { describe, expect, it } from 'vitest';
import { sampleSurface } from '../../testing/records.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { meshTimeWords, timeInName } from './exportedTime.ts';

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
