// Asks what the server suggests to begin with in the dataset that is shown: asked for once it is known, and
// again when the series has become much longer, as after an import.
import { effect, untracked } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { tellUnlessCut } from '../base/lostConnection.ts';

const muchLonger = 2;

export class Suggestions {
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;
    private asked = { dataset: '', steps: 0 };
    private answer: Promise<void> = Promise.resolve();

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>) {
        this.state = state;
        this.worker = worker;
        effect(() => {
            const [dataset, steps] = [state.dataset.value?.dataset, state.times.value.length];
            const running = state.stage.value === 'running';
            if (dataset !== undefined && running) untracked(() => void this.refresh(dataset, steps));
        });
    }

    /** Once it has been answered, or refused. */
    async here(): Promise<void> {
        const { dataset, times } = this.state;
        if (dataset.value !== null) await this.refresh(dataset.value.dataset, times.value.length);
    }

    private refresh(dataset: string, steps: number): Promise<void> {
        if (dataset !== this.asked.dataset || steps >= muchLonger * this.asked.steps) {
            this.asked = { dataset, steps };
            this.answer = this.ask(dataset);
        }
        return this.answer;
    }

    private async ask(dataset: string): Promise<void> {
        const { state } = this;
        if (state.suggestion.value?.dataset !== dataset) state.suggestion.value = null;
        try {
            const suggestion = await this.worker.call('dataset.suggest', { dataset });
            if (this.asked.dataset === dataset) state.suggestion.value = { dataset, ...suggestion };
            state.problems.solved('suggestion');
        } catch (error) {
            this.asked = { dataset: '', steps: 0 };
            tellUnlessCut(state.problems, 'suggestion', error);
        }
    }
}
