import { describe, expect, it } from 'vitest';
import { AppState, type SurfaceStanding } from '../../state/appState.ts';
import { datasetOf, surfaceOf } from '../../testing/records.ts';
import { intentOf } from '../edits/surfaceIntent.ts';
import { faster, standingWords, untilHere } from './longPass.ts';

const view = { units: { value: { length: 'm', time: 's', speed: '' } } } as unknown as Parameters<typeof standingWords>[2];
const standing: SurfaceStanding = {
    ...{ surface: 's', fraction: 0.427, message: '', lasting: 'a while' },
    ...{ time: 8.2, quads: 12_345, remaining: 8.4 },
};

function bench(change: Parameters<typeof surfaceOf>[1] = {}) {
    const record = surfaceOf('s', { kind: 'streak', from: 0, to: 19.2, separation: 0.1, ...change });
    const state = new AppState();
    state.dataset.value = datasetOf({ times: [0, 9.6, 19.2] });
    state.surfaces.value = new Map([['s', record]]);
    return { state, intent: intentOf(record) };
}

describe('standingWords', () => {
    it('tells the simulation time, the quads and the seconds left', () => {
        const { state } = bench();
        expect(standingWords(standing, state, view)).toBe('t = 8.2 of 19.2 s, 12\u202f345 quads, about 8 s left');
    });

    it('tells the part where a surface is not moved in time, and nothing that is not known', () => {
        const { state } = bench({ kind: 'stream' });
        expect(standingWords({ ...standing, time: null, remaining: null }, state, view)).toBe('42 %, 12\u202f345 quads');
        const unknown = { ...standing, fraction: null, time: null, quads: null, remaining: 200 };
        expect(standingWords(unknown, state, view)).toBe('about 3 min left');
    });
});

describe('what one can have instead', () => {
    it('is Fast first, and half as many lines where it is fast already', () => {
        const { intent } = bench({ accuracy: 'balanced' });
        expect(faster(intent, view)).toEqual([
            { change: { accuracy: 'fast' }, words: 'Fast accuracy' },
            { change: { separation: 0.2 }, words: 'Separation 0.2 m' },
        ]);
        expect(faster({ ...intent, accuracy: 'fast' }, view).map(({ change }) => change)).toEqual([{ separation: 0.2 }]);
    });

    it('ends where the work has come to, whichever way time runs, and never later', () => {
        const { intent } = bench();
        const reached = { ...standing, time: 8.123_456 };
        expect(untilHere(intent, reached, view)).toMatchObject({ words: 'Until t = 8.12 s' });
        expect(untilHere(intent, reached, view)!.change.length).toBeCloseTo(8.12);
        const backward = bench({ from: 19.2, to: 0, direction: 'backward' }).intent;
        const there = untilHere(backward, { ...standing, time: 11.075 }, view)!;
        expect(there.change.length).toBeCloseTo(8.12);
        expect(there.words).toBe('Until t = 11.08 s');
    });

    it('is no end where there is none: nothing reached, all of it, or no time to speak of', () => {
        const { intent } = bench();
        for (const time of [null, 0, 19.2]) expect(untilHere(intent, { ...standing, time }, view)).toBeNull();
    });
});
