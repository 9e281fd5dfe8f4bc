// Which things of a list are meant, as runs of consecutive ones; and what becomes of a list when some go.
// Twin: protocol/wire/runs.hpp.
import type { Numbers } from './bytes.ts';
import { FrameError } from './frameError.ts';

/** Things begin .. end - 1 of a list. */
export interface Run {
    begin: number;
    end: number;
}

/** Disjoint and ascending; `count` things in all. */
export interface Runs {
    all: readonly Run[];
    count: number;
}

/** Runs over `over` things. Throws FrameError. */
export function readRuns(numbers: Numbers, over: number): Runs {
    const all: Run[] = [];
    let at = 0;
    let count = 0;
    for (let left = numbers.next(over); left > 0; --left) {
        const begin = at + numbers.next(over);
        const end = begin + numbers.next(over);
        if (begin === end || end > over) throw new FrameError('a mesh update names vertices or cells that are not there');
        all.push({ begin, end });
        count += end - begin;
        at = end;
    }
    return { all, count };
}

/** The things themselves, ascending. */
export function thingsIn({ all, count }: Runs): Int32Array {
    const things = new Int32Array(count);
    let next = 0;
    for (const { begin, end } of all) for (let thing = begin; thing < end; ++thing) things[next++] = thing;
    return things;
}

/** The number each of `count` things has when the removed ones are gone, -1 for those. */
export function numbersAfter(removed: Runs, count: number): Int32Array {
    const now = new Int32Array(count);
    for (const { begin, end } of removed.all) now.fill(-1, begin, end);
    for (let at = 0, next = 0; at < count; ++at) if (now[at] === 0) now[at] = next++;
    return now;
}

/** Closes up what stays of the first `count` things of `stride` numbers each. */
export function removeRuns(array: Int32Array, { all }: Runs, count: number, stride: number): void {
    let to = (all[0]?.begin ?? count) * stride;
    all.forEach((run, i) => {
        const begin = run.end * stride;
        const end = (all[i + 1]?.begin ?? count) * stride;
        array.copyWithin(to, begin, end);
        to += end - begin;
    });
}
