// What the page says of the computation of a surface: how far one that takes long has come, how to stop it and what one could have instead;
// and of a finished one whether it is as fine as it was asked for, and why there is nothing to see of it. Short ones come and go without a
// word.
import { computed, effect } from '@preact/signals-core';
import type { SurfaceStats } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import { type AppState, type SurfaceStatus, withEntry } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import type { Calls } from '../base/calls.ts';
import type { SurfaceIntent } from '../edits/surfaceIntent.ts';
import { timeWords, withUnit } from '../picture/writtenNumbers.ts';

/** The time in milliseconds up to which there is no bar. */
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

/** What the server tells of its work. */
export type ReportedProgress = Pick<SurfaceStatus, 'fraction' | 'message' | 'time' | 'quads' | 'remaining'> & {
    /** How long it has been at work. */
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
    progressed(token: string | number, reported: ReportedProgress): void {
        const { progress } = this.options.state;
        if (token !== this.token || progress.value === null) return;
        const { seconds, ...status } = reported;
        progress.value = { ...progress.value, ...status };
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

/** Coarser by so much, where everything else is as fast as it gets. */
const coarser = 2;
/** Rounds an end to this part of the time that the surface was followed for. */
const finestPart = 1000;

/** Returns words like "t = 8.2 of 19.2, 12 345 quads, about 8 s left". Empty: there is nothing to say yet. */
export function progressWords(
    status: SurfaceStatus,
    state: Pick<AppState, 'dataset' | 'surfaces'>,
    view: Pick<ViewState, 'units'>,
): string {
    const words: string[] = [];
    const to = state.surfaces.value.get(status.surface)?.to;
    if (status.time !== null && to !== undefined) {
        const reached = shortNumber(status.time);
        words.push(`t = ${reached} of ${timeWords(state, view, to)}`);
    } else if (status.fraction !== null) words.push(`${Math.floor(100 * status.fraction)} %`);
    if (status.quads !== null) words.push(`${status.quads.toLocaleString('en').replaceAll(',', '\u202f')} quads`);
    if (status.remaining !== null) words.push(leftWords(status.remaining));
    return words.join(', ');
}

function leftWords(seconds: number): string {
    const about = (count: number, unit: string): string => `about ${Math.max(1, Math.round(count))} ${unit} left`;
    if (seconds < 90) return about(seconds, 's');
    return seconds < 5400 ? about(seconds / 60, 'min') : about(seconds / 3600, 'h');
}

/** A surface that takes less, and words for it. */
export interface LessWork {
    change: Partial<SurfaceIntent>;
    words: string;
}

/** First what costs least of the picture. */
export function faster(intent: SurfaceIntent, view: Pick<ViewState, 'units'>): LessWork[] {
    const separation = intent.separation * coarser;
    const coarse = { change: { separation }, words: `Separation ${withUnit(shortNumber(separation), view.units.value.length)}` };
    if (intent.accuracy === 'fast') return [coarse];
    return [{ change: { accuracy: 'fast' }, words: 'Fast accuracy' }, coarse];
}

/** Ends where the work has come to; null: of a surface all of which is at one time there is no shorter
 *  one. */
export function untilHere(intent: SurfaceIntent, status: SurfaceStatus, view: Pick<ViewState, 'units'>): LessWork | null {
    if (status.time === null) return null;
    const unit = 10 ** Math.floor(Math.log10(intent.length / finestPart));
    const length = Math.floor(Math.abs(status.time - intent.from) / unit) * unit;
    if (!(length > 0 && length < intent.length)) return null;
    const end = intent.from + (intent.direction === 'backward' ? -length : length);
    return { change: { length }, words: `Until t = ${withUnit(shortNumber(end), view.units.value.time)}` };
}

export interface SurfaceOutcomesOptions {
    state: Pick<AppState, 'displayed' | 'outcomes' | 'stage' | 'surfaces'>;
    worker: Pick<WorkerClient, 'call'>;
}

/** Counts are announced as a surface is finished, and asked for where this page came later. */
export class SurfaceOutcomes {
    private readonly options: SurfaceOutcomesOptions;
    /** States that were asked for once, by surface. */
    private readonly requested = new Map<string, number>();

    constructor(options: SurfaceOutcomesOptions) {
        this.options = options;
        const { state } = options;
        effect(() => {
            const there = state.surfaces.value;
            for (const surface of this.requested.keys()) if (!there.has(surface)) this.requested.delete(surface);
            const { outcomes } = state;
            const present = [...outcomes.peek()].filter(([surface]) => there.has(surface));
            if (present.length < outcomes.peek().size) outcomes.value = new Map(present);
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
        if (this.requested.get(surface) === stateSum || state.outcomes.peek().get(surface)?.stateSum === stateSum) return;
        this.requested.set(surface, stateSum);
        // Where there is no answer, the surface is gone or the connection is.
        worker.call('surface.stats', { surface }).then(
            (stats) => this.done(stats),
            () => this.requested.delete(surface),
        );
    }
}
