// How far a surface that takes long has come, and how to stop it. Short ones come and go without a word.
import { computed, effect } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import type { Calls } from '../base/calls.ts';

/** What takes no longer needs no bar. */
const patienceMs = 500;
/** The most that the server takes. */
const waitMs = 600_000;
const unfinished: ReadonlySet<string> = new Set(['none', 'updating', 'coarse']);

export interface SurfaceProgressOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    calls: Pick<Calls, 'try'>;
}

export class SurfaceProgress {
    private readonly options: SurfaceProgressOptions;
    private timer: ReturnType<typeof setTimeout> | null = null;
    private token = '';
    private tokens = 0;

    constructor(options: SurfaceProgressOptions) {
        this.options = options;
        const { state } = options;
        // As one text, so that what happens to other surfaces is no change.
        const busy = computed(() => {
            const surface = state.activeSurface.value;
            const epoch = state.requestedEpochs.value.get(surface ?? '') ?? 0;
            return surface !== null && unfinished.has(state.phase.value) ? JSON.stringify([surface, epoch]) : null;
        });
        effect(() => {
            const now = busy.value;
            this.forget();
            if (now === null) return;
            const [surface, epoch] = JSON.parse(now) as [string, number];
            this.timer = setTimeout(() => void this.wait(surface, epoch), patienceMs);
        });
    }

    /** From the notification $/progress. */
    progressed(token: string | number, fraction: number | null, message: string): void {
        const { progress } = this.options.state;
        if (token !== this.token || progress.value === null) return;
        progress.value = { ...progress.value, fraction, message };
    }

    /** What is there by now stays. */
    async stop(): Promise<void> {
        const surface = this.options.state.progress.value?.surface;
        if (surface !== undefined) await this.options.calls.try('surface.stop', { surface });
    }

    private async wait(surface: string, epoch: number): Promise<void> {
        const { state, worker } = this.options;
        const token = `surface-${++this.tokens}`;
        this.token = token;
        state.progress.value = { surface, fraction: null, message: '' };
        const asked = { surface, epoch, timeoutMs: waitMs, workDoneToken: token };
        // Failures of the surface are told by surface.done.
        await worker.call('surface.wait', asked).catch(() => null);
        if (this.token === token) this.forget();
    }

    private forget(): void {
        if (this.timer !== null) clearTimeout(this.timer);
        this.timer = null;
        this.token = '';
        if (this.options.state.progress.peek() !== null) this.options.state.progress.value = null;
    }
}
