// What play, pause, step and scrub mean for the surface that is being worked on. One that moves is shown
// at the session's clock, which runs on the server for every user; of a stream surface the field is frozen at
// a time-step, and this page moves that on, one time-step after the other, when the picture of the last one
// is there.
import { computed, effect, signal } from '@preact/signals-core';
import { type Clock, systemClock, type Timer } from '../../connection/clock.ts';
import type { SurfaceRecord } from '../../protocol/messages.ts';
import type { AppState, DisplayedSurface } from '../../state/appState.ts';
import type { ClockControl } from './clockControl.ts';
import type { Edits } from '../edits/edits.ts';
import type { UndoHistory } from '../edits/undoHistory.ts';
import { endOf } from '../edits/surfaceTimes.ts';
import { clampTo, nearestStep, shownTime, type Span, stepFrom } from './timeSteps.ts';

/** The whole in this time at normal speed. */
const secondsForAll = 10;
const pollEveryMs = 30;

export interface PlaybackOptions {
    state: AppState;
    edits: Pick<Edits, 'intent' | 'changeSurface' | 'gestures'> & { history: Pick<UndoHistory, 'turns'> };
    clock: Pick<ClockControl, 'set' | 'play' | 'pause'>;
    time?: Clock;
}

/** none: nothing that time could change. */
export type PlaybackMode = 'none' | 'frozen' | 'clock';

export class Playback {
    private readonly options: PlaybackOptions;
    private readonly timer: Clock;
    private readonly frozenPlaying = signal(false);
    /** Chosen here and not told to the server yet. */
    private readonly chosenFactor = signal<number | null>(null);
    private readonly chosenLoop = signal<boolean | null>(null);
    private waiting: Timer | null = null;
    /** The clock has been asked to run, and has not answered. */
    private telling = false;

    constructor(options: PlaybackOptions) {
        this.options = options;
        this.timer = options.time ?? systemClock;
        // Another kind of surface, or none: nothing of this page goes on by itself.
        effect(() => {
            if (this.mode.value !== 'frozen' || options.state.stage.value !== 'running') this.stopFrozen();
        });
        // What plays is an edit of the surface: going on, it would put an end to what can be done again.
        effect(() => {
            if (options.edits.history.turns.value > 0) this.stopFrozen();
        });
    }

    readonly mode = computed((): PlaybackMode => {
        const { state, edits } = this.options;
        const intent = edits.intent.value;
        if (intent?.kind === 'stream' && state.surfaceTimes.value.length > 1) return 'frozen';
        return state.clock.value !== null && (this.ownMoves.value || this.others.value.length > 0) ? 'clock' : 'none';
    });

    /** The surface goes with the clock. */
    readonly ownMoves = computed((): boolean => {
        const { state, edits } = this.options;
        const kind = edits.intent.value?.kind ?? 'stream';
        // Of one time-step there is one level set at all times.
        return kind === 'level' ? state.surfaceTimes.value.length > 1 : kind !== 'stream';
    });

    /** What goes with the clock in other data than those of the surface. */
    private readonly others = computed((): readonly SurfaceRecord[] => {
        const { hiddenSurfaces, surfaceDataset, surfaces } = this.options.state;
        return [...surfaces.value.values()].filter(
            ({ surface, kind, dataset }) =>
                kind !== 'stream' && dataset !== surfaceDataset.value?.dataset && !hiddenSurfaces.value.has(surface),
        );
    });

    /** The span of the surface, or of all time-steps for a stream surface: the earlier end first, also
     *  where time runs backward. */
    readonly own = computed((): Span => {
        const [a, b] = this.ends.value;
        return [Math.min(a, b), Math.max(a, b)];
    });

    /** What is played: that span, and of a clock those of what moves in other data as well, since it is one for all. */
    readonly span = computed((): Span => {
        return this.mode.value === 'clock' ? this.moving.value : this.own.value;
    });

    private readonly moving = computed((): Span => {
        const all = [...(this.ownMoves.value ? this.own.value : []), ...this.others.value.flatMap(({ from, to }) => [from, to])];
        return [Math.min(...all), Math.max(...all)];
    });

    /** From the release of the surface to where it ends, which is earlier for a backward one. */
    private readonly ends = computed((): readonly [number, number] => {
        const { state, edits } = this.options;
        const intent = edits.intent.value;
        if (intent === null || intent.kind === 'stream') {
            return [state.surfaceTimes.value[0] ?? 0, state.surfaceTimes.value.at(-1) ?? 0];
        }
        const record = state.surface.value;
        const same =
            record !== undefined &&
            record.kind === intent.kind &&
            record.from === intent.from &&
            record.direction === intent.direction;
        if (same) return [record.from, record.to];
        // Until the server has it: what it will be asked for.
        return [intent.from, endOf(intent, state.surfaceTimes.value, state.surfaceDataset.value?.steady ?? false)];
    });

    /** The time of the picture. */
    readonly time = computed((): number => {
        const { state, edits } = this.options;
        // Slices and streamlines have a time also where no surface is chosen.
        return this.mode.value === 'clock' ? this.clockTime.value : (edits.intent.value?.from ?? shownTime(state));
    });

    /** The time of the picture in some data: a field is frozen in its own alone where those of others go with the clock. */
    timeOf(dataset: string): number {
        const { clock, surfaceDataset } = this.options.state;
        const own = dataset === surfaceDataset.value?.dataset || clock.value === null || this.others.value.length === 0;
        return own ? this.time.value : this.clockTime.value;
    }

    private readonly clockTime = computed((): number => {
        const { state } = this.options;
        const record = state.clock.value!;
        const displayed = this.clockOf(state.activeSurface.value ?? '');
        if (record.playing && displayed !== undefined) return displayed.time;
        if (record.time !== null) return clampTo(this.moving.value, record.time);
        return this.ownMoves.value ? this.ends.value[1] : this.moving.value[1];
    });

    /** What is on the screen of a surface that goes with the clock: of another where this one has come to an end of its time. */
    private clockOf(active: string): DisplayedSurface | undefined {
        const { displayed, surfaces } = this.options.state;
        const own = this.ownMoves.value ? displayed.value.get(active) : undefined;
        const [low, high] = this.own.value;
        if (own !== undefined && ((own.time > low && own.time < high) || sameSpan(this.moving.value, this.own.value))) return own;
        const going = [...surfaces.value.values()].find(({ surface, kind, from, to }) => {
            const time = displayed.value.get(surface)?.time ?? Number.NaN;
            return kind !== 'stream' && time > Math.min(from, to) && time < Math.max(from, to);
        });
        return going === undefined ? own : displayed.value.get(going.surface);
    }

    readonly playing = computed((): boolean =>
        this.mode.value === 'clock' ? this.options.state.clock.value!.playing : this.frozenPlaying.value,
    );

    /** Simulation time a second at normal speed. */
    readonly normalSpeed = computed((): number => (this.span.value[1] - this.span.value[0]) / secondsForAll);

    /** Simulation time a second. */
    readonly speed = computed((): number => {
        if (this.chosenFactor.value !== null) return this.chosenFactor.value * this.normalSpeed.value;
        const record = this.options.state.clock.value;
        const byClock = this.mode.value === 'clock' && record !== null && record.from !== null;
        return byClock ? record.speed : this.normalSpeed.value;
    });

    readonly loop = computed((): boolean => {
        if (this.chosenLoop.value !== null) return this.chosenLoop.value;
        const record = this.options.state.clock.value;
        return this.mode.value === 'clock' && record !== null && record.from !== null ? record.loop : true;
    });

    async toggle(): Promise<void> {
        if (this.playing.value) await this.pause();
        else await this.play();
    }

    async play(): Promise<void> {
        if (this.mode.value === 'frozen') {
            this.frozenPlaying.value = true;
            const { span } = this;
            this.options.edits.gestures.begin();
            if (!this.loop.value && this.time.value >= span.value[1]) this.goTo(span.value[0]);
            this.playFrozen();
        } else if (this.mode.value === 'clock') {
            this.computeAgain();
            await this.playClock();
        }
    }

    async pause(): Promise<void> {
        this.stopFrozen();
        if (this.mode.value === 'clock' && this.playing.value) await this.options.clock.pause();
    }

    /** By one stored time-step; the end of the surface's time counts as one. */
    async step(sign: 1 | -1): Promise<void> {
        const at = this.time.value;
        await this.pause();
        const { pictured, surfaceTimes } = this.options.state;
        const others = this.mode.value === 'clock' ? pictured.value.flatMap((each) => each.times) : [];
        this.goTo(stepFrom([...surfaceTimes.value, ...others], at, sign, this.span.value));
    }

    async toEnd(sign: 1 | -1): Promise<void> {
        if (sign > 0) await this.pause();
        this.goTo(this.span.value[sign > 0 ? 1 : 0]);
    }

    /** A surface that was stopped shows nothing new, whatever the clock says. */
    private computeAgain(): void {
        const { state, edits } = this.options;
        if (state.phase.value === 'stopped' && !state.locked.value) edits.changeSurface({});
    }

    /** Goes to a time as a slider moves: the newest of a frame counts. */
    goTo(time: number): void {
        if (!Number.isFinite(time)) return;
        if (this.mode.value === 'clock') this.options.clock.set(clampTo(this.span.value, time));
        else if (this.mode.value === 'frozen') this.release(time);
    }

    /** When the surface is released, or its field frozen: at the time-step nearest to a time. */
    release(time: number, gesture?: string): void {
        const { state, edits } = this.options;
        const times = state.surfaceTimes.value;
        const from = times[nearestStep(times, time)];
        if (from !== undefined && from !== edits.intent.value?.from) edits.changeSurface({ from }, gesture);
    }

    /** A multiple of the normal speed. */
    async setSpeed(factor: number): Promise<void> {
        this.chosenFactor.value = factor;
        await this.sendIfRunning();
    }

    async setLoop(loop: boolean): Promise<void> {
        this.chosenLoop.value = loop;
        await this.sendIfRunning();
    }

    private async sendIfRunning(): Promise<void> {
        if (this.mode.value === 'clock') {
            // What is chosen before the clock has started is told when it has.
            if (this.playing.value && !this.telling) await this.playClock();
        } else if (this.playing.value) this.playFrozen();
    }

    private async playClock(): Promise<void> {
        const [factor, loop] = [this.chosenFactor.value, this.chosenLoop.value];
        const [from, to] = this.span.value;
        this.telling = true;
        await this.options.clock.play({ speed: this.speed.value, loop: this.loop.value, from, to });
        this.telling = false;
        if (this.chosenFactor.value !== factor || this.chosenLoop.value !== loop) {
            await this.playClock();
            return;
        }
        // From here on the record says it, also if others change it.
        this.chosenFactor.value = null;
        this.chosenLoop.value = null;
    }

    private playFrozen(): void {
        if (this.waiting !== null) this.timer.cancel(this.waiting);
        const since = this.timer.now();
        const at = this.time.value;
        const next = this.nextFrozen(at);
        if (next === null) {
            this.stopFrozen();
            return;
        }
        const due = since + (1000 * this.frozenPause(at, next)) / this.speed.value;
        const poll = (): void => {
            if (this.timer.now() < due || !this.pictureIsThere()) {
                this.waiting = this.timer.after(pollEveryMs, poll);
                return;
            }
            this.release(next, this.options.edits.gestures.current);
            this.waiting = null;
            this.playFrozen();
        };
        this.waiting = this.timer.after(pollEveryMs, poll);
    }

    private nextFrozen(at: number): number | null {
        const times = this.options.state.surfaceTimes.value;
        const next = times[nearestStep(times, at) + 1];
        if (next !== undefined) return next;
        return this.loop.value && times.length > 1 ? times[0]! : null;
    }

    /** The last time-step stays as long as the one before it. */
    private frozenPause(at: number, next: number): number {
        const times = this.options.state.surfaceTimes.value;
        return next > at ? next - at : (times.at(-1) ?? 0) - (times.at(-2) ?? 0);
    }

    private pictureIsThere(): boolean {
        return !['updating', 'none', 'waiting'].includes(this.options.state.phase.value);
    }

    private stopFrozen(): void {
        if (this.waiting !== null) this.timer.cancel(this.waiting);
        this.waiting = null;
        this.frozenPlaying.value = false;
    }
}

function sameSpan(a: Span, b: Span): boolean {
    return a[0] === b[0] && a[1] === b[1];
}
