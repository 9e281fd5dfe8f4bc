// Says how far a surface that takes long has come, and how to stop it. Short ones come and go without a word.
import { computed, effect } from '@preact/signals-core';
import type { AppState, SurfaceStanding } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import type { Calls } from '../base/calls.ts';

/** Is the time in milliseconds up to which there is no bar. */
const patienceMs = 500;
/** From then on people ask how far it is, and later what they could have instead. */
const tellMs = 3000;
const offerMs = 10_000;
/** The most that the server takes. */
const waitMs = 600_000;
const unfinished: ReadonlySet<string> = new Set(['none', 'updating', 'coarse']);

export interface SurfaceProgressOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    calls: Pick<Calls, 'try'>;
}

/** Describes what the server tells of its work. */
export type ToldProgress = Pick<SurfaceStanding, 'fraction' | 'message' | 'time' | 'quads' | 'remaining'> & {
    /** Says how long it has been at work. */
    seconds: number | null;
};

export class SurfaceProgress {
    private readonly options: SurfaceProgressOptions;
    private timers: ReturnType<typeof setTimeout>[] = [];
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
            this.timers = [
                setTimeout(() => void this.wait(surface, epoch), patienceMs),
                setTimeout(() => this.lasts(tellMs), tellMs),
                setTimeout(() => this.lasts(offerMs), offerMs),
            ];
        });
    }

    /** From the notification $/progress. */
    progressed(token: string | number, told: ToldProgress): void {
        const { progress } = this.options.state;
        if (token !== this.token || progress.value === null) return;
        const { seconds, ...standing } = told;
        progress.value = { ...progress.value, ...standing };
        // It may have been at work before this page came.
        if (seconds !== null) this.lasts(1000 * seconds);
    }

    /** Stops the work; what is there by now stays. */
    async stop(): Promise<void> {
        const surface = this.options.state.progress.value?.surface;
        if (surface !== undefined) await this.options.calls.try('surface.stop', { surface });
    }

    private lasts(ms: number): void {
        const { progress } = this.options.state;
        const before = progress.value;
        if (before === null) return;
        const lasting = ms >= offerMs || before.lasting === 'long' ? 'long' : ms >= tellMs ? 'a while' : before.lasting;
        if (lasting !== before.lasting) progress.value = { ...before, lasting };
    }

    private async wait(surface: string, epoch: number): Promise<void> {
        const { state, worker } = this.options;
        const token = `surface-${++this.tokens}`;
        this.token = token;
        const nothing = { fraction: null, message: '', time: null, quads: null, remaining: null };
        state.progress.value = { surface, ...nothing, lasting: 'briefly' };
        const asked = { surface, epoch, timeoutMs: waitMs, workDoneToken: token };
        // Failures of the surface are told by surface.done.
        await worker.call('surface.wait', asked).catch(() => null);
        if (this.token === token) this.forget();
    }

    private forget(): void {
        for (const timer of this.timers) clearTimeout(timer);
        this.timers = [];
        this.token = '';
        if (this.options.state.progress.peek() !== null) this.options.state.progress.value = null;
    }
}
