// Made by protocol/api/generate from time.schema.json: do not edit.
import { flag, members, number, orNull } from '../checks.ts';
import type { InSession } from './shared.ts';

/**
 * The clock of a session. `time` is its time when the message was written. While it is `playing`, it advances by
 * `speed` up to `to`, and there it stops or goes on at `from` (`loop`).
 */
export interface ClockRecord {
    /** simulation time; null: it was never set, and surfaces are shown at their end (the dataset's unit of time) */
    time: number | null;
    /** true: the clock runs */
    playing: boolean;
    /** how fast the clock runs (simulation time a second) */
    speed: number;
    /** true: the clock goes on at `from` when it reaches `to` */
    loop: boolean;
    /** time at which playing starts; null before the clock was first played (the dataset's unit of time) */
    from: number | null;
    /** time at which playing ends; null before the clock was first played (the dataset's unit of time) */
    to: number | null;
}

export const clockRecordCheck = members<ClockRecord>({
    time: orNull(number),
    playing: flag,
    speed: number,
    loop: flag,
    from: orNull(number),
    to: orNull(number),
});

/** The clock after the call. */
export interface ClockAnswer {
    /** the clock as it is now */
    clock: ClockRecord;
}

export const clockAnswerCheck = members<ClockAnswer>({ clock: clockRecordCheck });

/** Parameters of time.set. */
export interface TimeSetParams extends InSession {
    /** simulation time; null: no time, and surfaces are shown at their end (the dataset's unit of time) */
    time: number | null;
}

/** Parameters of time.play. */
export interface TimePlayParams extends InSession {
    /** how fast the clock runs; if left out, as before, at first 1 (simulation time a second) */
    speed?: number;
    /** true: go on at `from` when the clock reaches `to`; if left out, as before, at first false */
    loop?: boolean;
    /**
     * time at which playing starts; if left out, as before, at first where the first surface begins (the dataset's
     * unit of time)
     */
    from?: number;
    /**
     * time at which playing ends; if left out, as before, at first where the last surface ends (the dataset's unit of
     * time)
     */
    to?: number;
}

/** Parameters of time.pause. */
export type TimePauseParams = InSession;
