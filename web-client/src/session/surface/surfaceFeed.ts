// The surfaces as they arrive: subscriptions, and what is new in each surface, put on the screen at the next
// frame. A surface that this page hides has no subscription: the server sends nothing of it.
import { effect, untracked } from '@preact/signals-core';
import { errorWords, type PassSeconds, type ReportedError, type ValueRange } from '../../protocol/messages.ts';
import type { FrameLoop } from '../../scene/frameLoop.ts';
import type { FlowScene } from '../../scene/scene.ts';
import { type AppState, withEntry, withoutEntry } from '../../state/appState.ts';
import type { LatencyLog } from '../../state/latency.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import type { SurfaceState } from '../../worker/workerMessages.ts';
import { announceUnlessDisconnected } from '../base/calls.ts';

const firstPauseMs = 500;
const maxTroubles = 4;

export interface SurfaceFeedOptions {
    state: AppState;
    scene: Pick<FlowScene, 'setSurface' | 'removeSurface' | 'whenDrawn'> & { loop: Pick<FrameLoop, 'request'> };
    worker: Pick<WorkerClient, 'call' | 'taken' | 'forget'>;
    latency: LatencyLog;
}

export class SurfaceFeed {
    private readonly options: SurfaceFeedOptions;
    private readonly subscribed = new Set<string>();
    /** What the server calls a subscription that it has agreed to. */
    private readonly agreed = new Map<string, number>();
    /** Would be subscribed if they were not hidden. */
    private readonly hidden = new Set<string>();
    /** Each builds on the one before, so all are drawn; the worker keeps them few. */
    private readonly waiting = new Map<string, SurfaceState[]>();
    /** How often in a row the frames of a surface did not fit together. */
    private readonly troubles = new Map<string, number>();

    constructor(options: SurfaceFeedOptions) {
        this.options = options;
        effect(() => {
            const { value } = options.state.hiddenSurfaces;
            untracked(() => this.hide(value));
        });
    }

    /** The mesh on the screen stays, and goes on if the server still has what follows. */
    async subscribe(surface: string): Promise<void> {
        const { worker, state } = this.options;
        if (state.hiddenSurfaces.value.has(surface)) {
            this.hidden.add(surface);
            return;
        }
        this.subscribed.add(surface);
        const { subscription, resumed, ranges } = await worker.call('surface.subscribe', { surface }).catch((error: unknown) => {
            this.subscribed.delete(surface);
            throw error;
        });
        if (!this.subscribed.has(surface)) {
            // Hidden or deleted since.
            worker.forget(surface);
            await worker.call('surface.unsubscribe', { subscription }).catch(() => null);
            return;
        }
        this.agreed.set(surface, subscription);
        if (ranges !== undefined) this.ranged(surface, ranges);
        // What is on the screen is of an epoch that the server may number again.
        if (!resumed) state.displayed.value = withoutEntry(state.displayed.value, surface);
        void this.askWhyNot(surface);
    }

    /** Leaves out what has ended without a surface: that was told to those who were here then. */
    private async askWhyNot(surface: string): Promise<void> {
        const stats = await this.options.worker.call('surface.stats', { surface }).catch(() => null);
        if (stats?.error === undefined || !this.subscribed.has(surface)) return;
        this.requested(surface, stats.epoch);
        this.done(surface, stats.epoch, stats.error);
    }

    /**
     * Starts afresh after frames that did not fit together. Each time later than before: if page and server
     * do not understand each other, asking again at once would keep both busy for ever.
     */
    async troubled(surface: string, subscription: number, reason: string): Promise<void> {
        const { worker, state } = this.options;
        if (!this.subscribed.has(surface)) return;
        const troubles = (this.troubles.get(surface) ?? 0) + 1;
        this.troubles.set(surface, troubles);
        if (troubles > maxTroubles) {
            state.notices.say(`surface ${surface}`, `The surface cannot be shown: ${reason}. Reload the page.`);
            return;
        }
        await new Promise((resolve) => setTimeout(resolve, firstPauseMs * 2 ** (troubles - 1)));
        await worker.call('surface.unsubscribe', { subscription }).catch(() => null);
        if (this.subscribed.has(surface)) await this.subscribe(surface).catch(() => undefined);
    }

    /** A new connection: old subscriptions are void. */
    reset(): void {
        const { state } = this.options;
        this.troubles.clear();
        this.agreed.clear();
        for (const surface of this.subscribed) if (!state.surfaces.value.has(surface)) this.removed(surface);
    }

    receive(arrived: SurfaceState): void {
        const { surface, fromVertex, fromSeed, fromIndex } = arrived;
        const { worker, scene } = this.options;
        if (!this.subscribed.has(surface)) {
            worker.taken(surface);
            return;
        }
        this.troubles.delete(surface);
        const before = this.waiting.get(surface) ?? [];
        const whole = fromVertex + fromSeed + fromIndex === 0;
        // Drawn unseen it would cost as much as seen.
        if (whole) for (const _ of before) worker.taken(surface);
        this.waiting.set(surface, whole ? [arrived] : [...before, arrived]);
        scene.loop.request();
    }

    /** Called at the start of every frame. */
    apply(): void {
        const { state, scene, latency, worker } = this.options;
        const applied = performance.now();
        for (const [surface, arrived] of this.waiting) {
            for (const change of arrived) {
                scene.setSurface(surface, change);
                if (change.parts !== null) state.parts.value = withEntry(state.parts.value, surface, change.parts);
                if (change.cut !== null) state.trimmed.value = withEntry(state.trimmed.value, surface, change.cut.trimmedCells);
                worker.taken(surface);
            }
            const {
                epoch,
                meshVertices: vertices,
                cells,
                triangles,
                stateSum,
                phase,
                time,
                keys,
                deltas,
                withheld,
                curved,
            } = arrived.at(-1)!;
            const decodeMs = arrived.reduce((sum, each) => sum + each.decodeMs, 0);
            scene.whenDrawn((at) => {
                const drawn = { decodeMs, drawMs: at - applied, roundTripMs: state.roundTripMs.value };
                latency.shown(surface, epoch, at, drawn);
                state.latency.value = latency.samples.at(-1) ?? null;
            });
            const shown = {
                ...{ surface, epoch, vertices, cells, triangles, stateSum, phase, time, keys, deltas, withheld },
                curved,
            };
            state.displayed.value = withEntry(state.displayed.value, surface, shown);
            this.requested(surface, epoch);
        }
        this.waiting.clear();
    }

    requested(surface: string, epoch: number): void {
        const { requestedEpochs } = this.options.state;
        if (epoch <= (requestedEpochs.value.get(surface) ?? 0)) return;
        requestedEpochs.value = withEntry(requestedEpochs.value, surface, epoch);
    }

    /** Told before the state that has these values. */
    ranged(surface: string, ranges: readonly ValueRange[]): void {
        const { valueRanges } = this.options.state;
        valueRanges.value = withEntry(valueRanges.value, surface, ranges);
    }

    /** Takes what the pass behind a state took on the server. */
    progressed(surface: string, epoch: number, seconds: PassSeconds | null): void {
        if (seconds !== null) this.options.latency.passed(surface, epoch, seconds);
    }

    done(surface: string, epoch: number, error: ReportedError | null): void {
        const { surfaceErrors } = this.options.state;
        if (error !== null) {
            surfaceErrors.value = withEntry(surfaceErrors.value, surface, {
                // What is cancelled has a button beside it; the hint is for programs.
                ...{ epoch, text: error.kind === 'cancelled' ? error.message : errorWords(error) },
                stopped: error.kind === 'cancelled',
            });
        } else if (surfaceErrors.value.has(surface)) {
            surfaceErrors.value = withoutEntry(surfaceErrors.value, surface);
        }
    }

    /** Ends the subscriptions of these surfaces, and begins those of the others again. */
    private hide(surfaces: ReadonlySet<string>): void {
        const { state, worker } = this.options;
        for (const surface of [...this.subscribed].filter((each) => surfaces.has(each))) {
            const subscription = this.agreed.get(surface);
            this.removed(surface);
            this.hidden.add(surface);
            if (subscription !== undefined) void worker.call('surface.unsubscribe', { subscription }).catch(() => null);
        }
        for (const surface of [...this.hidden].filter((each) => !surfaces.has(each))) {
            this.hidden.delete(surface);
            // Without a connection it is subscribed with the others, when there is one again.
            if (state.stage.value !== 'running' || !state.surfaces.value.has(surface)) continue;
            this.subscribe(surface).catch((error: unknown) =>
                announceUnlessDisconnected(state.notices, `surface ${surface}`, error),
            );
        }
    }

    removed(surface: string): void {
        const { state, scene, worker } = this.options;
        this.subscribed.delete(surface);
        this.hidden.delete(surface);
        this.agreed.delete(surface);
        this.waiting.delete(surface);
        worker.forget(surface);
        scene.removeSurface(surface);
        state.displayed.value = withoutEntry(state.displayed.value, surface);
        state.parts.value = withoutEntry(state.parts.value, surface);
        state.trimmed.value = withoutEntry(state.trimmed.value, surface);
        state.valueRanges.value = withoutEntry(state.valueRanges.value, surface);
    }
}
