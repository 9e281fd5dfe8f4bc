// What an update is read by: varints, deflated numbers, and runs of consecutive things. protocol/wire/FORMAT.md, Update. Twins:
// protocol/wire/numbers.hpp, runs.hpp.
import { inflateSync } from 'fflate';

/** Deflate makes nothing more than so many times smaller. */
const mostInflation = 1032;

/** Differences near zero, of either sign, stand as small numbers: 0, 1, 2, 3 ... are 0, -1, 1, -2 ... */
export function unzigzag(code: number): number {
    return (code >>> 1) ^ -(code & 1);
}

/** Reads one number, seven bits a byte and at most 32 in all, lowest first, into `into[count]`; where the
 *  next one begins. */
function readVarint(bytes: Uint8Array, from: number, into: Uint32Array, count: number): number {
    let value = 0;
    for (let at = from, shift = 0; at < bytes.length; ++at, shift += 7) {
        const byte = bytes[at]!;
        if (shift === 28 && byte > 0x0f) break;
        value |= (byte & 0x7f) << shift;
        if (byte >= 0x80) continue;
        into[count] = value;
        return at + 1;
    }
    throw new FrameError('a mesh update holds a number that is cut off or has more than 32 bits');
}

function inflated(bytes: Uint8Array, size: number): Uint8Array {
    if (size > mostInflation * bytes.length) throw new FrameError('a mesh update announces more numbers than it can hold');
    let result: Uint8Array;
    try {
        result = inflateSync(bytes, { out: new Uint8Array(size + 1) });
    } catch (error) {
        throw new FrameError(`the numbers of a mesh update are damaged: ${String(error)}`);
    }
    if (result.length !== size) throw new FrameError('a mesh update holds other numbers than it announces');
    return result;
}

/** Numbers, to be taken one after the other. */
export class Numbers {
    /** What follows the numbers. */
    readonly rest: Uint8Array;
    private readonly all: Uint32Array;
    private at = 0;

    /** Reads the bytes of a whole update. Throws FrameError. Allocates O(bytes). */
    constructor(update: Uint8Array) {
        const lengths = new Uint32Array(2);
        const begin = readVarint(update, readVarint(update, 0, lengths, 0), lengths, 1);
        const [packed, size] = lengths as unknown as [number, number];
        if (packed > update.length - begin) throw new FrameError('a mesh update ends within its numbers');
        const bytes = inflated(update.subarray(begin, begin + packed), size);
        const room = new Uint32Array(bytes.length);
        let count = 0;
        for (let at = 0; at < bytes.length; ++count) {
            if (bytes[at]! < 0x80) room[count] = bytes[at++]!;
            else at = readVarint(bytes, at, room, count);
        }
        this.all = room.subarray(0, count);
        this.rest = update.subarray(begin + packed);
    }

    get left(): number {
        return this.all.length - this.at;
    }

    /** Throws FrameError where there is none, or a larger one than `most`. */
    next(most = 0xffffffff): number {
        if (this.at === this.all.length) throw new FrameError('a mesh update holds too few numbers');
        const value = this.all[this.at++]!;
        if (value > most) throw new FrameError(`a mesh update holds ${value} where at most ${most} may stand`);
        return value;
    }

    take(count: number): Uint32Array {
        if (count > this.left) throw new FrameError('a mesh update holds too few numbers');
        this.at += count;
        return this.all.subarray(this.at - count, this.at);
    }
}

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

/** The bytes are not a frame that continues the mesh. The cure is always the same: drop the mesh and subscribe again. */
export class FrameError extends Error {
    override readonly name = 'FrameError';
}
