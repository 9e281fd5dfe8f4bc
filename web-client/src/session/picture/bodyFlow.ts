// The flow along the body for its texture: asked for while that is wanted, as the time of the picture is. One
// request at a time; of what comes meanwhile only the newest is asked for.
import { computed, effect, signal } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';

export interface BodyFlowOptions {
    state: Pick<AppState, 'dataset' | 'datasetEntry' | 'notices' | 'stage' | 'times'>;
    view: Pick<ViewState, 'bodyTexture'>;
    scene: Pick<FlowScene, 'setBodyFlow' | 'setBodyTime'>;
    worker: Pick<WorkerClient, 'obstacleFlow'>;
    /** Returns the time of the picture; no number where nothing has one. */
    time: () => number;
    /** A clock moves it. */
    moves: () => boolean;
}

const about = 'body flow';

/** What is wanted: the same again is not asked for twice. */
interface Wish {
    key: string;
    time: number;
}

export class BodyFlow {
    /** failed: the server did not send it for this time. */
    readonly status = computed((): 'off' | 'waiting' | 'shown' | 'failed' => {
        const wish = this.wish.value;
        if (wish === null) return 'off';
        if (this.answered.value !== wish.key) return 'waiting';
        return this.failed.value ? 'failed' : 'shown';
    });
    private readonly options: BodyFlowOptions;
    /** The key of the wish that was answered last. */
    private readonly answered = signal('');
    private readonly failed = signal(false);
    private asking = false;

    constructor(options: BodyFlowOptions) {
        this.options = options;
        const { state, scene } = options;
        effect(() => {
            const [first = 0] = state.times.value;
            scene.setBodyTime(options.moves() ? this.time() - first : null);
        });
        effect(() => {
            const wish = this.wish.value;
            if (wish === null) this.forget();
            // What is on the screen stays while the server does not hear.
            else if (state.stage.value === 'running') void this.ask();
        });
    }

    private readonly wish = computed((): Wish | null => {
        const { state, view } = this.options;
        const dataset = state.dataset.value;
        if (!view.bodyTexture.value || dataset?.obstacle !== true) return null;
        const times = state.times.value;
        const [first, last] = [times[0] ?? 0, times.at(-1) ?? 0];
        // A flow that stands still is the same at all times.
        const time = dataset.steady ? first : Math.min(last, Math.max(first, this.time()));
        return { key: JSON.stringify([dataset.dataset, state.datasetEntry.value?.values, time]), time };
    });

    private time(): number {
        const time = this.options.time();
        return Number.isFinite(time) ? time : (this.options.state.times.value[0] ?? 0);
    }

    private forget(): void {
        const { scene, state } = this.options;
        this.answered.value = '';
        scene.setBodyFlow(null);
        state.notices.solved(about);
    }

    private async ask(): Promise<void> {
        if (this.asking) return;
        this.asking = true;
        const { state, worker, scene } = this.options;
        for (let wish = this.next(); wish !== null; wish = this.next()) {
            const { dataset, lattice } = state.dataset.value!;
            let failure: unknown = null;
            const flow = await worker.obstacleFlow(dataset, lattice, wish.time).catch((error: unknown) => {
                failure = error ?? new Error('The flow along the body could not be loaded.');
                return null;
            });
            // Switched off, or another dataset, meanwhile.
            if (this.wish.value === null || state.dataset.value?.dataset !== dataset) continue;
            if (failure === null) {
                scene.setBodyFlow(flow);
                state.notices.solved(about);
            } else state.notices.tell(about, failure);
            this.failed.value = failure !== null;
            this.answered.value = wish.key;
        }
        this.asking = false;
    }

    private next(): Wish | null {
        const wish = this.wish.value;
        return wish === null || wish.key === this.answered.value || this.options.state.stage.value !== 'running' ? null : wish;
    }
}
