import { describe, expect, it } from 'vitest';
import { datasetOf, fieldOf } from '../testing/records.ts';
import { AppState, type DisplayedSurface, surfacePhase } from './appState.ts';

const displayed: DisplayedSurface = {
    surface: 's1',
    epoch: 4,
    vertices: 9,
    cells: 4,
    triangles: 8,
    stateSum: 1,
    keys: 1,
    deltas: 0,
    withheld: [],
    curved: false,
    phase: 'final' as const,
    time: 0,
};

describe('surfacePhase', () => {
    const settled = { displayed, requestedEpoch: 4, editsPending: false, error: undefined };

    it('says final only of the newest epoch at its finest', () => {
        expect(surfacePhase(settled)).toBe('final');
        expect(surfacePhase({ ...settled, requestedEpoch: 5 })).toBe('updating');
        expect(surfacePhase({ ...settled, editsPending: true })).toBe('updating');
        expect(surfacePhase({ ...settled, displayed: { ...displayed, phase: 'coarse' } })).toBe('coarse');
        expect(surfacePhase({ ...settled, displayed: { ...displayed, cells: 0 } })).toBe('empty');
        expect(surfacePhase({ ...settled, displayed: undefined })).toBe('none');
    });

    it('forgets an error once something newer has been asked for', () => {
        const failed = { ...settled, error: { epoch: 4, text: 'x', stopped: false } };
        expect(surfacePhase(failed)).toBe('error');
        expect(surfacePhase({ ...failed, requestedEpoch: 5 })).toBe('updating');
        expect(surfacePhase({ ...settled, error: { ...failed.error, stopped: true } })).toBe('stopped');
    });
});

describe('AppState', () => {
    it('calls nothing final before the session has been joined, or after it was lost', () => {
        const state = new AppState();
        state.activeSurface.value = 's1';
        state.displayed.value = new Map([['s1', displayed]]);
        expect(state.phase.value).toBe('waiting');
        state.stage.value = 'running';
        expect(state.phase.value).toBe('final');
    });

    it('offers the time-steps that are ready, and at least one', () => {
        const state = new AppState();
        const times = [0, 1, 2, 3];
        state.dataset.value = datasetOf({ times });
        expect(state.times.value).toEqual(times);
        state.datasetEntry.value = {
            dataset: 'd',
            name: 'd',
            state: 'importing',
            steps: { ready: 2, total: 4 },
        };
        expect(state.times.value).toEqual([0, 1]);
    });

    it('takes the range of the colours from the velocity', () => {
        const state = new AppState();
        const fields = [fieldOf('p', { range: [5, 6] }), fieldOf('U', { components: 3, range: [0, 1.7] })];
        state.dataset.value = datasetOf({ fields });
        expect(state.speedRange.value).toEqual([0, 1.7]);
    });
});
