// Which times and directions go together: a surface starts at `from` and ends `length` later, or earlier
// where it goes backward. All but stream surfaces stay in the data, and what has to give way for that is
// said.
import type { Direction, SurfaceKind } from '../../protocol/messages.ts';
import { rounding, shortNumber } from '../../scene/base/numbers.ts';

/** The parts of a surface's intent that its times depend on. */
interface Times {
    kind: SurfaceKind;
    from: number;
    length: number;
    direction: Direction;
}

/** All of a streak, time or level surface is there at one time: it cannot go both ways. */
export function directionsOf(kind: SurfaceKind): readonly Direction[] {
    if (kind === 'level') return ['forward'];
    return kind === 'streak' || kind === 'time' ? ['forward', 'backward'] : ['forward', 'backward', 'both'];
}

/** Returns how long it can be followed, and is as far as that is asked for; both ways, after its release. 0:
 *  no time is left. */
export function followed(wanted: Times, times: readonly number[], steady: boolean): number {
    return isFree(wanted, steady) ? wanted.length : Math.min(wanted.length, timeLeft(wanted, times));
}

/** The longest that it could be followed, with its release where it is; null: as long as one likes. */
export function longestLength(wanted: Times, times: readonly number[], steady: boolean): number | null {
    return isFree(wanted, steady) ? null : timeLeft(wanted, times);
}

/** Where it ends: `to` of its record. */
export function endOf(wanted: Times, times: readonly number[], steady: boolean): number {
    const length = followed(wanted, times, steady);
    const end = wanted.from + (wanted.direction === 'backward' ? -length : length);
    // A sum that is rounded must not lie beyond them.
    return isFree(wanted, steady) ? end : inData(end, times);
}

export interface TypedTime {
    /** Null: it says nothing that could be done. */
    change: Partial<Times> | null;
    /** What of it could not be so, and why; null: nothing. */
    remark: string | null;
}

/** Another first time: the surface still ends where it did, if that is later. The field of a stream surface
 *  is frozen then. */
export function typedFrom(wanted: Times, typed: number, times: readonly number[], steady: boolean): TypedTime {
    const from = steady ? typed : inData(typed, times);
    const remark = outsideWords(typed, from, times);
    if (wanted.kind === 'stream') return { change: { from }, remark };
    const end = endOf(wanted, times, steady);
    const left = wanted.direction === 'backward' ? from - end : end - from;
    return { change: left > 0 ? { from, length: left } : { from }, remark };
}

/** Another last time; one that is earlier than the first is that of a surface which goes backward. */
export function typedTo(wanted: Times, typed: number, times: readonly number[], steady: boolean): TypedTime {
    const to = isFree(wanted, steady) ? typed : inData(typed, times);
    const remark = outsideWords(typed, to, times);
    const length = Math.abs(to - wanted.from);
    if (!(length > 0)) return { change: null, remark: remark ?? 'It ends at another time than it begins.' };
    const direction = wanted.direction === 'both' ? 'both' : to < wanted.from ? 'backward' : 'forward';
    return { change: direction === wanted.direction ? { length } : { length, direction }, remark };
}

function inData(time: number, times: readonly number[]): number {
    return Math.min(Math.max(time, times[0] ?? time), times.at(-1) ?? time);
}

function outsideWords(typed: number, taken: number, times: readonly number[]): string | null {
    const [low, high] = [times[0] ?? taken, times.at(-1) ?? taken];
    if (Math.abs(typed - taken) <= rounding(low, high)) return null;
    const [first, last] = [low, high].map(shortNumber);
    return `t = ${shortNumber(typed)} is outside the data, which go from ${first} to ${last}: ${shortNumber(taken)} is taken.`;
}

/** Where the data begin, if a path surface that goes both ways ends there before it has gone back as long as
 *  forward. */
export function cutBackAt(wanted: Times, times: readonly number[], steady: boolean): number | null {
    if (isFree(wanted, steady) || wanted.direction !== 'both') return null;
    const first = times[0] ?? wanted.from;
    return wanted.from - followed(wanted, times, steady) < first ? first : null;
}

export interface Adapted<Intent> {
    intent: Intent;
    /** What was changed beside what the user has changed, and why; null: nothing. */
    remark: string | null;
}

/**
 * Returns what comes nearest to a change that cannot be as it is: a direction that the kind has, and a
 * release with time left in the data.
 * @param dragged the release is what the user changes: it stops where no time would be left. Otherwise it
 * goes where most is.
 */
export function adapted<Intent extends Times>(
    wanted: Intent,
    dragged: boolean,
    times: readonly number[],
    steady: boolean,
): Adapted<Intent> {
    const remark: string[] = [];
    const intent = { ...wanted };
    if (!directionsOf(intent.kind).includes(intent.direction)) {
        intent.direction = 'forward';
        if (intent.kind === 'level') return { intent, remark: null };
        remark.push(`A ${intent.kind} surface goes one way in time: this one goes forward.`);
    }
    if (intent.kind !== 'level' && times.length > 1 && !(followed(intent, times, steady) > 0)) {
        const from = dragged ? nearestRelease(intent.direction, times) : bestRelease(intent.direction, times);
        const side = intent.direction === 'backward' ? 'before' : 'after';
        remark.push(`Released at ${shortNumber(from)}: the data have nothing ${side} ${shortNumber(intent.from)}.`);
        intent.from = from;
    }
    return { intent, remark: remark.length === 0 ? null : remark.join(' ') };
}

/** The field of a stream surface stands still, and so does steady flow. */
function isFree({ kind }: Times, steady: boolean): boolean {
    return kind === 'stream' || steady;
}

function timeLeft({ from, direction }: Times, times: readonly number[]): number {
    const after = (times.at(-1) ?? from) - from;
    const before = from - (times[0] ?? from);
    return direction === 'backward' ? before : after;
}

function nearestRelease(direction: Direction, times: readonly number[]): number {
    return times.at(direction === 'backward' ? 1 : -2)!;
}

function bestRelease(direction: Direction, times: readonly number[]): number {
    if (direction === 'both') return times[Math.floor((times.length - 1) / 2)]!;
    return times.at(direction === 'backward' ? -1 : 0)!;
}
