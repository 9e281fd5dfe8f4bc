// Which time-steps of the dataset are in the server's memory: asked for once a connection, then told change by change.
import type { StepChange } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';

export class StepStates {
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>) {
        this.state = state;
        this.worker = worker;
    }

    /** Nothing is shown where the server cannot tell. */
    async load(dataset: string): Promise<void> {
        try {
            const { steps } = await this.worker.call('cache.status', { dataset });
            if (this.state.dataset.value?.dataset === dataset) this.state.stepStates.value = steps;
        } catch {
            this.state.stepStates.value = [];
        }
    }

    /** Changes that come before the answer to the question are older than it. */
    patched(dataset: string, changes: readonly StepChange[]): void {
        const { stepStates } = this.state;
        if (this.state.dataset.value?.dataset !== dataset || stepStates.value.length === 0) return;
        const steps = [...stepStates.value];
        for (const [step, state] of changes) {
            while (steps.length < step) steps.push('cold'); // steps that an import has added
            steps[step] = state;
        }
        stepStates.value = steps;
    }
}
