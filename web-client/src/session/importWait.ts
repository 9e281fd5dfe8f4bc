// Waits for the import of the dataset that is opened, as one of all who do, until this page's user stops it: the last one who
// does ends the import (protocol/README.md, "Datasets that are imported").
import { effect, signal } from '@preact/signals-core';
import type { AppState } from '../state/appState.ts';
import { CallError, type WorkerClient } from '../worker/workerClient.ts';

const cancelled = -32800;

export interface ImportWaitOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
}

export class ImportWait {
    /** This user does not wait any more, or somebody has stopped the import. */
    readonly left = signal(false);
    private readonly options: ImportWaitOptions;
    private waiting: AbortController | null = null;

    constructor(options: ImportWaitOptions) {
        this.options = options;
        // Of a dataset that becomes ready, whoever has seen to it, there is nothing left to wait for.
        effect(() => {
            if (options.state.datasetEntry.value?.state === 'ready') this.left.value = false;
        });
    }

    /** An import that was stopped goes on. Nothing while it is being waited for. */
    async begin(dataset: string): Promise<void> {
        if (this.waiting !== null) return;
        const waiting = new AbortController();
        this.waiting = waiting;
        this.left.value = false;
        try {
            await this.options.worker.call('dataset.open', { dataset }, waiting.signal);
        } catch (error) {
            // Other failures are told by the dataset's entry, or by the connection.
            if (error instanceof CallError && error.failure.code === cancelled) this.left.value = true;
        } finally {
            this.waiting = null;
        }
    }

    stop(): void {
        this.waiting?.abort();
    }

    again(): void {
        const dataset = this.options.state.datasetEntry.value?.dataset;
        if (dataset !== undefined) void this.begin(dataset);
    }
}
