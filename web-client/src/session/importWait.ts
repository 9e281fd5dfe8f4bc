// Waits for the import of the dataset that is opened, as one of all who do, until this page's user stops it:
// the last one who does ends the import (server/data/README.md).
import { effect, signal, untracked } from '@preact/signals-core';
import { errorCodes } from '../protocol/generated/errors.ts';
import type { DatasetEntry } from '../protocol/messages.ts';
import type { AppState } from '../state/appState.ts';
import { CallError, type WorkerClient } from '../worker/workerClient.ts';

export interface ImportWaitOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
}

export class ImportWait {
    /** This user does not wait any more, or a user has stopped the import. */
    readonly left = signal(false);
    private readonly options: ImportWaitOptions;
    private waiting: AbortController | null = null;
    /** This user has stopped; what others go on with is not waited for again before this user says so. */
    private own = false;
    /** The entry has said that the import is stopped, since it was last waited for. */
    private seenStopped = false;

    constructor(options: ImportWaitOptions) {
        this.options = options;
        effect(() => {
            const entry = options.state.datasetEntry.value;
            if (entry !== null) untracked(() => this.follow(entry));
        });
    }

    /** An import that was stopped goes on. Nothing while it is being waited for. */
    async begin(dataset: string): Promise<void> {
        if (this.waiting !== null) return;
        const waiting = new AbortController();
        this.waiting = waiting;
        this.own = false;
        this.seenStopped = false;
        this.left.value = false;
        try {
            // The server's patience ends before a long import does.
            while (!waiting.signal.aborted) {
                const entry = await this.options.worker.call('dataset.open', { dataset }, waiting.signal);
                if (entry.state !== 'importing') break;
            }
        } catch (error) {
            // Other failures are told by the dataset's entry, or by the connection.
            if (error instanceof CallError && error.failure.code === errorCodes.cancelled) this.left.value = true;
        } finally {
            this.waiting = null;
            const entry = this.options.state.datasetEntry.value;
            if (this.own) this.left.value = true;
            else if (this.left.value && entry !== null) this.follow(entry);
        }
    }

    stop(): void {
        if (this.waiting === null) return;
        this.own = true;
        this.waiting.abort();
    }

    resume(): void {
        const dataset = this.options.state.datasetEntry.value?.dataset;
        if (dataset !== undefined) void this.begin(dataset);
    }

    /** Imports with this velocity what failed as that is not clear. */
    async choose(velocity: string): Promise<void> {
        const { state, worker } = this.options;
        const dataset = state.datasetEntry.value?.dataset;
        if (dataset === undefined) return;
        try {
            state.datasetEntry.value = await worker.call('dataset.open', { dataset, velocity, timeoutMs: 0 });
            state.notices.solved('velocity');
        } catch (error) {
            state.notices.tell('velocity', error);
        }
    }

    private follow({ dataset, state }: DatasetEntry): void {
        if (state === 'stopped') this.seenStopped = true;
        // Of a dataset that becomes ready, by whatever means, there is nothing left to wait for.
        if (state === 'ready' || state === 'incomplete') {
            this.left.value = false;
            this.own = false;
        }
        if (state !== 'importing' || this.own || this.waiting !== null) return;
        // The entry may be older than the news that a user has stopped: to wait at once would have it go on.
        if (this.left.value && !this.seenStopped) return;
        void this.begin(dataset);
    }
}
