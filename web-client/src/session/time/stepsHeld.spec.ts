import { describe, expect, it } from 'vitest';
import type { StepHeld } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { answering } from '../../testing/fakes.ts';
import { datasetOf } from '../../testing/records.ts';
import { StepsHeld } from './stepsHeld.ts';

function bench(held: StepHeld[]) {
    const state = new AppState();
    state.dataset.value = datasetOf({ dataset: 'd', times: [0, 1, 2] });
    const steps = held.map(([resident]) => (resident > 0 ? 'resident' : 'cold'));
    const worker = answering(() => ({ dataset: 'd', steps, held, bytesPerStep: 100, bytes: 0, budget: 1 }));
    return { state, held: new StepsHeld(state, worker) };
}

describe('what is held of the time-steps', () => {
    it('is the answer, changed by what is told afterwards', async () => {
        const { state, held } = bench([
            [100, 0],
            [0, 0],
            [0, 0],
        ]);
        held.patched('d', [[2, 100, 0]]); // older than the answer
        await held.load('d');
        expect(state.heldSteps.value).toEqual({
            steps: [
                [100, 0],
                [0, 0],
                [0, 0],
            ],
            whole: 100,
        });
        held.patched('another', [[0, 0, 0]]);
        held.patched('d', [
            [1, 2, 30],
            [4, 100, 0],
        ]);
        expect(state.heldSteps.value.steps).toEqual([
            [100, 0],
            [2, 30],
            [0, 0],
            [0, 0],
            [100, 0],
        ]);
    });
});
