// Made by protocol/api/generate from time.schema.json: do not edit.
import { flag, members, number, orNull } from '../checks.ts';

/**
 * A session's clock. `time` is as the message is written; it runs on by `speed` while `playing`, up to `to`, and there
 * it stops or goes on at `from` (`loop`).
 */
export interface ClockRecord {
    /** simulation time; null: never set, surfaces are shown at their end (the dataset's unit of time) */
    time: number | null;
    /** it runs */
    playing: boolean;
    /** how fast it runs (simulation time a second) */
    speed: number;
    /** it begins again at the end */
    loop: boolean;
    /** what is played begins here; null before it first was (the dataset's unit of time) */
    from: number | null;
    /** and ends here (the dataset's unit of time) */
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
    /** as it is now */
    clock: ClockRecord;
}

export const clockAnswerCheck = members<ClockAnswer>({ clock: clockRecordCheck });

/** Parameters of time.set. */
export interface TimeSetParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** simulation time; null: no time, surfaces are shown at their end (the dataset's unit of time) */
    time: number | null;
}

/** Parameters of time.play. */
export interface TimePlayParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** how fast it runs; left out: as before, at first 1 (simulation time a second) */
    speed?: number;
    /** begin again at the end; left out: as before, at first not */
    loop?: boolean;
    /** left out: as before, at first where the first surface begins (the dataset's unit of time) */
    from?: number;
    /** left out: as before, at first where the last surface ends (the dataset's unit of time) */
    to?: number;
}

/** Parameters of time.pause. */
export interface TimePauseParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What of a record time.set asks for, beside its id. */
export const timeAskedNames = [] as const;
