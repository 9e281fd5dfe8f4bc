// Which things of a list are meant, as runs of consecutive ones; and what becomes of a list when some go. Twin:
// protocol/runs.hpp.

/// Things begin .. end - 1 of a list.
export interface Run {
    begin: number;
    end: number;
}

/// Disjoint and ascending; `count` things in all.
export interface Runs {
    all: readonly Run[];
    count: number;
}

/// Calls each(begin, end) for the runs of those of `count` things that are not taken.
export function forEachGap(taken: Runs, count: number, each: (begin: number, end: number) => void): void {
    let at = 0;
    for (const { begin, end } of taken.all) {
        if (at < begin)
            each(at, begin);
        at = end;
    }
    if (at < count)
        each(at, count);
}

/// The number each of `count` things has when the removed ones are gone, -1 for those.
export function numbersAfter(removed: Runs, count: number): Int32Array {
    const now = new Int32Array(count).fill(-1);
    let next = 0;
    forEachGap(removed, count, (begin, end) => {
        for (let i = begin; i < end; i += 1)
            now[i] = next++;
    });
    return now;
}

/// A call that moves memory costs as much as moving so many numbers one by one.
const worthACall = 64;

/// Closes up what stays of the first `count` things of `stride` numbers each.
export function removeRuns(array: Int32Array, removed: Runs, count: number, stride: number): void {
    let to = 0;
    forEachGap(removed, count, (first, last) => {
        const begin = first * stride;
        const end = last * stride;
        if (to !== begin && end - begin > worthACall)
            array.copyWithin(to, begin, end);
        else if (to !== begin)
            for (let from = begin, into = to; from < end; from += 1, into += 1)
                array[into] = array[from]!;
        to += end - begin;
    });
}
