// Says what the server counted on each finished surface: whether it is as fine as it was asked for, and why
// there is nothing to see of it. Told as it is finished; asked for where this page came later.
import { effect } from '@preact/signals-core';
import type { SurfaceStats } from '../../protocol/messages.ts';
import { type AppState, withEntry } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';

export interface SurfaceOutcomesOptions {
    state: Pick<AppState, 'displayed' | 'outcomes' | 'stage' | 'surfaces'>;
    worker: Pick<WorkerClient, 'call'>;
}

export class SurfaceOutcomes {
    private readonly options: SurfaceOutcomesOptions;
    /** States that were asked for once, by surface. */
    private readonly asked = new Map<string, number>();

    constructor(options: SurfaceOutcomesOptions) {
        this.options = options;
        const { state } = options;
        effect(() => {
            const there = state.surfaces.value;
            for (const surface of this.asked.keys()) if (!there.has(surface)) this.asked.delete(surface);
            const { outcomes } = state;
            const kept = [...outcomes.peek()].filter(([surface]) => there.has(surface));
            if (kept.length < outcomes.peek().size) outcomes.value = new Map(kept);
        });
        effect(() => {
            if (state.stage.value !== 'running') return;
            for (const { surface, phase, stateSum } of state.displayed.value.values()) {
                if (phase === 'final') this.ask(surface, stateSum);
            }
        });
    }

    /** From the notification surface.done. That of a surface which is gone is no user's. */
    done(stats: SurfaceStats | undefined): void {
        const { outcomes, surfaces } = this.options.state;
        if (stats === undefined || !surfaces.peek().has(stats.surface)) return;
        outcomes.value = withEntry(outcomes.value, stats.surface, stats);
    }

    private ask(surface: string, stateSum: number): void {
        const { state, worker } = this.options;
        if (this.asked.get(surface) === stateSum || state.outcomes.peek().get(surface)?.stateSum === stateSum) return;
        this.asked.set(surface, stateSum);
        // Where there is no answer, the surface is gone or the connection is.
        worker.call('surface.stats', { surface }).then(
            (stats) => this.done(stats),
            () => this.asked.delete(surface),
        );
    }
}
