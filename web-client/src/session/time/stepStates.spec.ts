import { describe, expect, it } from 'vitest';
import type { StepState } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { answering } from '../../testing/answering.ts';
import { datasetOf } from '../../testing/records.ts';
import { StepStates } from './stepStates.ts';

function bench(steps: StepState[]) {
    const state = new AppState();
    state.dataset.value = datasetOf({ dataset: 'd', times: [0, 1, 2] });
    const worker = answering(() => ({ dataset: 'd', steps, bytes: 0, budget: 1 }));
    return { state, states: new StepStates(state, worker) };
}

describe('StepStates', () => {
    it('are the answer, changed by what is told afterwards', async () => {
        const { state, states } = bench(['resident', 'cold', 'cold']);
        states.patched('d', [[2, 'resident']]); // older than the answer
        await states.load('d');
        expect(state.stepStates.value).toEqual(['resident', 'cold', 'cold']);
        states.patched('another', [[0, 'cold']]);
        states.patched('d', [
            [1, 'loading'],
            [4, 'resident'],
        ]);
        expect(state.stepStates.value).toEqual(['resident', 'loading', 'cold', 'cold', 'resident']);
    });
});
