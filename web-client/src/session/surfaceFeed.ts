// The surfaces as they arrive: subscriptions, and of the states of each surface only the newest, put
// on the screen at the next frame.
import { errorWords, type ReportedError } from '../protocol/messages.ts';
import type { FlowScene } from '../scene/scene.ts';
import { type AppState, withEntry, withoutEntry } from '../state/appState.ts';
import type { LatencyLog } from '../state/latency.ts';
import type { WorkerClient } from '../worker/workerClient.ts';
import type { SurfaceState } from '../worker/workerMessages.ts';

const firstPauseMs = 500;
const troublesAtMost = 4;

export interface SurfaceFeedOptions {
    state: AppState;
    scene: FlowScene;
    worker: WorkerClient;
    latency: LatencyLog;
}

export class SurfaceFeed {
    private readonly options: SurfaceFeedOptions;
    private readonly surfaceOf = new Map<number, string>();
    private readonly waiting = new Map<string, SurfaceState>();
    /** How often in a row the frames of a surface did not fit together. */
    private readonly troubles = new Map<string, number>();
    /** The state on the screen with its arrays, for tests of what is displayed. */
    private readonly arrays = new Map<string, SurfaceState>();

    constructor(options: SurfaceFeedOptions) {
        this.options = options;
    }

    async subscribe(surface: string): Promise<void> {
        const { worker } = this.options;
        const { subscription } = await worker.call('surface.subscribe', { surface });
        this.surfaceOf.set(subscription, surface);
    }

    /**
     * Starts afresh after frames that did not fit together. Each time later than before: if page and server
     * do not understand each other, asking again at once would keep both busy for ever.
     */
    async troubled(subscription: number, reason: string): Promise<void> {
        const { worker, state } = this.options;
        const surface = this.surfaceOf.get(subscription);
        if (surface === undefined) return;
        this.surfaceOf.delete(subscription);
        const troubles = (this.troubles.get(surface) ?? 0) + 1;
        this.troubles.set(surface, troubles);
        if (troubles > troublesAtMost) {
            state.notice.value = `The surface cannot be shown: ${reason}. Reload the page.`;
            return;
        }
        await new Promise((resolve) => setTimeout(resolve, firstPauseMs * 2 ** (troubles - 1)));
        await worker.call('surface.unsubscribe', { subscription }).catch(() => null);
        await this.subscribe(surface).catch(() => undefined);
    }

    /** A new connection: old subscriptions are void, epochs may count from the start again. */
    reset(): void {
        const { state, scene } = this.options;
        this.surfaceOf.clear();
        this.troubles.clear();
        this.waiting.clear();
        for (const id of state.displayed.value.keys()) {
            if (!state.surfaces.value.has(id)) scene.removeSurface(id);
        }
        state.displayed.value = new Map();
    }

    receive(arrived: SurfaceState): void {
        const surface = this.surfaceOf.get(arrived.subscription);
        if (surface === undefined) return;
        const newest = this.waiting.get(surface) ?? this.options.state.displayed.value.get(surface);
        if (newest !== undefined && arrived.epoch < newest.epoch) return;
        this.troubles.delete(surface);
        this.waiting.set(surface, arrived);
        this.options.scene.loop.request();
    }

    /** Called at the start of every frame. */
    apply(): void {
        const { state, scene, latency } = this.options;
        for (const [surface, arrived] of this.waiting) {
            const { epoch, vertices, cells, triangles, stateCrc, final } = arrived;
            scene.setSurface(surface, arrived, (time) => {
                latency.shown(surface, epoch, time);
                state.latencyMs.value = latency.samples.at(-1)?.milliseconds ?? null;
            });
            const shown = { surface, epoch, vertices, cells, triangles, stateCrc, final };
            state.displayed.value = withEntry(state.displayed.value, surface, shown);
            this.arrays.set(surface, arrived);
            this.requested(surface, epoch);
        }
        this.waiting.clear();
    }

    shownArrays(surface: string): SurfaceState | undefined {
        return this.arrays.get(surface);
    }

    requested(surface: string, epoch: number): void {
        const { requestedEpochs } = this.options.state;
        if (epoch <= (requestedEpochs.value.get(surface) ?? 0)) return;
        requestedEpochs.value = withEntry(requestedEpochs.value, surface, epoch);
    }

    done(surface: string, epoch: number, error: ReportedError | null): void {
        const { surfaceErrors } = this.options.state;
        if (error !== null) {
            surfaceErrors.value = withEntry(surfaceErrors.value, surface, { epoch, text: errorWords(error) });
        } else if (surfaceErrors.value.has(surface)) {
            surfaceErrors.value = withoutEntry(surfaceErrors.value, surface);
        }
    }

    removed(surface: string): void {
        const { state, scene } = this.options;
        this.waiting.delete(surface);
        this.arrays.delete(surface);
        for (const [subscription, id] of this.surfaceOf) {
            if (id === surface) this.surfaceOf.delete(subscription);
        }
        scene.removeSurface(surface);
        state.displayed.value = withoutEntry(state.displayed.value, surface);
    }
}
