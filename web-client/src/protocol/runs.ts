// Which things of a list are meant, as runs of consecutive ones; and what becomes of a list when some go. Twin:
// protocol/wire/runs.hpp.

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

/** Calls each(begin, end) for the runs of those of `count` things that are not taken. */
export function forEachGap(taken: Runs, count: number, each: (begin: number, end: number) => void): void {
    let at = 0;
    for (const { begin, end } of taken.all) {
        if (at < begin) each(at, begin);
        at = end;
    }
    if (at < count) each(at, count);
}

/** The number each of `count` things has when the removed ones are gone, -1 for those. */
export function numbersAfter(removed: Runs, count: number): Int32Array {
    const now = new Int32Array(count);
    let next = 0;
    let at = 0;
    // Without a callback: a variable that one changes lies in memory, and this is done for every vertex.
    for (const { begin, end } of removed.all) {
        while (at < begin) now[at++] = next++;
        now.fill(-1, begin, end);
        at = end;
    }
    while (at < count) now[at++] = next++;
    return now;
}

/** A call that moves memory costs as much as moving so many numbers one by one. */
const worthACall = 64;

/** Closes up what stays of the first `count` things of `stride` numbers each. */
export function removeRuns(array: Int32Array, { all }: Runs, count: number, stride: number): void {
    let to = (all[0]?.begin ?? count) * stride;
    for (let run = 0; run < all.length; ++run) {
        const begin = all[run]!.end * stride;
        const end = (all[run + 1]?.begin ?? count) * stride;
        if (end - begin > worthACall) array.copyWithin(to, begin, end);
        else for (let from = begin, into = to; from < end; ++from, ++into) array[into] = array[from]!;
        to += end - begin;
    }
}
