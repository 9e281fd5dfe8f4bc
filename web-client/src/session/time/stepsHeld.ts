// Asks how much of each time-step of the dataset is in the server's memory: asked for once a connection, then
// told change by change.
import type { HeldChange } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';

export class StepsHeld {
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>) {
        this.state = state;
        this.worker = worker;
    }

    /** Nothing is shown where the server cannot tell. */
    async load(dataset: string): Promise<void> {
        try {
            const { held, bytesPerStep } = await this.worker.call('cache.status', { dataset });
            if (this.state.dataset.value?.dataset === dataset) this.state.heldSteps.value = { steps: held, whole: bytesPerStep };
        } catch {
            this.state.heldSteps.value = { steps: [], whole: 0 };
        }
    }

    /** Changes that come before the answer to the question are older than it. */
    patched(dataset: string, changes: readonly HeldChange[]): void {
        const { heldSteps } = this.state;
        if (this.state.dataset.value?.dataset !== dataset || heldSteps.value.steps.length === 0) return;
        const steps = [...heldSteps.value.steps];
        for (const [step, resident, loading] of changes) {
            while (steps.length < step) steps.push([0, 0]); // steps that an import has added
            steps[step] = [resident, loading];
        }
        heldSteps.value = { ...heldSteps.value, steps };
    }
}
