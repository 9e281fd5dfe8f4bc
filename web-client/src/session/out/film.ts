// A film of a playback: for every frame the time is set, the surfaces of that time are waited for, and the
// picture is drawn. It takes as long as it takes; no frame is left out. Afterwards the time is what it was.
import { effect, type ReadonlySignal, signal } from '@preact/signals-core';
import type { ClockRecord, SurfaceRecord } from '../../protocol/messages.ts';
import type { BodyFields } from '../picture/bodyFields.ts';
import { timeText, withUnit } from '../picture/writtenNumbers.ts';
import type { ScreenSize } from '../../scene/base/view.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import type { Edits } from '../edits/edits.ts';
import { type Figure, unfinishedSurface } from './figure.ts';
import type { Playback } from '../time/playback.ts';
import type { ViewState } from '../../state/viewState.ts';
import { automaticRanges } from '../picture/surfaceStyleOf.ts';
import { poseAlong } from '../../scene/camera/cameraPath.ts';
import type { CameraControls, CameraPose } from '../../scene/camera/cameraControls.ts';
import type { FilmFormat } from './filmFile.ts';
import { canEncode, VideoEncoding } from './videoEncoding.ts';

const patienceMs = 60_000;
const resendEveryMs = 5000;
/** Times at which the colours' range is sampled up. */
const maxRangeSamples = 13;
export const maxFrames = 3600;

export interface FilmSetting extends ScreenSize {
    format: FilmFormat;
    fps: number;
    seconds: number;
    /** Writes the time into the picture. */
    time: boolean;
    /** The unit of the time; empty: none. */
    unit: string;
    /** The camera goes through these, evenly in time; none: it stays. */
    path: readonly CameraPose[];
}

export interface FilmProgress {
    /** measuring: what the colours are to stand for is sampled up, before the first frame. */
    state: 'idle' | 'measuring' | 'recording' | 'failed';
    done: number;
    frames: number;
    /** Why it failed. */
    words: string;
}

const idle: FilmProgress = { state: 'idle', done: 0, frames: 0, words: '' };

export interface FilmOptions {
    state: AppState;
    view: Pick<ViewState, 'lookOf' | 'looks' | 'fixedRanges'>;
    worker: Pick<WorkerClient, 'call'>;
    edits: Pick<Edits, 'intent' | 'gestures'>;
    playback: Playback;
    bodyFields: Pick<BodyFields, 'status'>;
    controls: Pick<CameraControls, 'place' | 'pose'>;
    /** Slices and lines. */
    fieldsShown: { waiting: ReadonlySignal<boolean> };
    figure: Figure;
}

/** The times of the frames: the first and the last are the ends. */
export function frameTimes([from, to]: readonly [number, number], { fps, seconds }: { fps: number; seconds: number }): number[] {
    const frames = Math.min(maxFrames, Math.max(2, Math.round(fps * seconds)));
    return Array.from({ length: frames }, (_, i) => from + ((to - from) * i) / (frames - 1));
}

/** At most so many of them, both ends among them. */
function spread(times: readonly number[], most: number): number[] {
    if (times.length <= most) return [...times];
    return Array.from({ length: most }, (_, i) => times[Math.round((i * (times.length - 1)) / (most - 1))]!);
}

const noEncoder: Record<FilmFormat, string> = {
    webm: 'This browser cannot record at this size. Choose a smaller size.',
    mp4: 'This browser cannot record H.264 at this size. Choose WebM, or a smaller size.',
};

class Cancelled extends Error {}

export class FilmMaker {
    readonly progress = signal<FilmProgress>(idle);
    private readonly options: FilmOptions;
    private cancelled = false;

    constructor(options: FilmOptions) {
        this.options = options;
    }

    /** Null where it was cancelled or failed; why is in `progress`. */
    async record(setting: FilmSetting): Promise<Blob | null> {
        const { playback, state, figure, controls } = this.options;
        if (this.busy) return null;
        if (!canEncode()) return this.fail('Recording needs a current browser over HTTPS (or on localhost).');
        const size = { width: 2 * Math.floor(setting.width / 2), height: 2 * Math.floor(setting.height / 2) };
        const times = frameTimes(playback.span.value, setting);
        const before = state.clock.value;
        const seenFrom = controls.pose;
        const frozenAt = this.options.edits.intent.value?.from ?? 0;
        this.cancelled = false;
        this.progress.value = { state: 'recording', done: 0, frames: times.length, words: '' };
        let encoding: VideoEncoding | null = null;
        let begun = false;
        const recipes = new Set<string>();
        try {
            encoding = await VideoEncoding.begin({ ...size, format: setting.format, fps: setting.fps });
            if (encoding === null) return this.fail(noEncoder[setting.format]);
            begun = true;
            await playback.pause();
            this.options.edits.gestures.begin();
            await this.fixColours(times);
            for (const [i, time] of times.entries()) {
                await this.show(time);
                if (setting.path.length > 0) controls.place(poseAlong(setting.path, i / (times.length - 1)));
                const background = figure.background.value === 'clear' ? 'white' : figure.background.value;
                const caption = setting.time ? `t = ${withUnit(timeText(state, playback.time.value), setting.unit)}` : null;
                const picture = figure.draw(size, caption, background);
                const shown = figure.recipes();
                await encoding.add(picture);
                for (const recipe of await shown) recipes.add(recipe);
                this.progress.value = { ...this.progress.value, done: i + 1 };
            }
            const film = await encoding.finish([...recipes]);
            this.progress.value = idle;
            return film;
        } catch (error) {
            encoding?.abandon();
            if (error instanceof Cancelled) this.progress.value = idle;
            else this.fail(error instanceof Error ? error.message : String(error));
            return null;
        } finally {
            this.options.view.fixedRanges.value = null;
            if (setting.path.length > 0) controls.place(seenFrom);
            if (begun) await this.putBack(before, frozenAt).catch(() => undefined);
        }
    }

    cancel(): void {
        this.cancelled = true;
        // Wakes those who wait for a surface.
        if (this.busy) this.progress.value = { ...this.progress.value };
    }

    private get busy(): boolean {
        return ['measuring', 'recording'].includes(this.progress.value.state);
    }

    /** Colours mean the same in all frames: what the values range over is sampled up before the first. */
    private async fixColours(times: readonly number[]): Promise<void> {
        const { state, view } = this.options;
        const recording = this.progress.value;
        const sampled = spread(times, maxRangeSamples);
        const coloured = automaticRanges(state, view).size + state.slices.value.size + state.lines.value.size > 0;
        for (const [i, time] of coloured ? sampled.entries() : []) {
            this.progress.value = { ...recording, state: 'measuring', done: i, frames: sampled.length };
            await this.show(time);
        }
        view.fixedRanges.value = automaticRanges(state, view);
        this.progress.value = recording;
    }

    private fail(words: string): null {
        this.progress.value = { ...idle, state: 'failed', words };
        return null;
    }

    private async show(time: number): Promise<void> {
        const { playback, worker, state, bodyFields, fieldsShown } = this.options;
        const clocked = this.clocked;
        if (clocked) await worker.call('time.set', { time });
        if (playback.mode.value === 'frozen') playback.release(time, this.options.edits.gestures.current);
        // Another user may have moved the clock since.
        const retry = clocked
            ? setInterval(() => void worker.call('time.set', { time }).catch(() => undefined), resendEveryMs)
            : undefined;
        try {
            await this.until(() => {
                // The release of a stream surface is on its way.
                const surfaces = state.phase.value !== 'updating' && this.surfacesAt(clocked ? time : null);
                return bodyFields.status.value !== 'waiting' && !fieldsShown.waiting.value && surfaces;
            });
        } finally {
            clearInterval(retry);
        }
    }

    /** Surfaces that the session's clock moves: also those beside a stream surface, whose field is frozen at other times. */
    private get clocked(): boolean {
        const { playback, state } = this.options;
        return playback.mode.value !== 'none' && [...state.surfaces.value.values()].some(({ kind }) => kind !== 'stream');
    }

    /** All that move are drawn as they are at this time, within their own. */
    private surfacesAt(time: number | null): boolean {
        const { state, view } = this.options;
        const done = (record: SurfaceRecord): boolean =>
            state.surfaceErrors.value.has(record.surface) || unfinishedSurface(state, view, record, time) === '';
        return [...state.surfaces.value.values()].every(done);
    }

    private until(met: () => boolean): Promise<void> {
        return new Promise((resolve, reject) => {
            let stop: (() => void) | null = null;
            let settled = false;
            const settle = (act: () => void): void => {
                if (settled) return;
                settled = true;
                clearTimeout(timer);
                act();
                stop?.();
            };
            const timer = setTimeout(
                () =>
                    settle(() =>
                        reject(
                            new Error(
                                'The surface of the next frame has not arrived for a minute. The server may be busy, or this page may be hidden.',
                            ),
                        ),
                    ),
                patienceMs,
            );
            stop = effect(() => {
                void this.progress.value;
                if (this.cancelled) settle(() => reject(new Cancelled()));
                else if (this.options.state.stage.value === 'running' && met()) settle(resolve);
            });
            if (settled) stop();
        });
    }

    private async putBack(clock: ClockRecord | null, frozenAt: number): Promise<void> {
        const { playback, worker } = this.options;
        if (playback.mode.value === 'frozen') playback.release(frozenAt, this.options.edits.gestures.current);
        if (clock === null || !this.clocked) return;
        await worker.call('time.set', { time: clock.time });
        if (!clock.playing || clock.from === null || clock.to === null) return;
        const { speed, loop, from, to } = clock;
        await worker.call('time.play', { speed, loop, from, to });
    }
}
