// The state of a surface on the wire: integers that the server and all its clients hold alike, with the neighbours that predictions need
// and the checksum over all of it. protocol/wire/FORMAT.md, State, Neighbours, State sum. Twin: protocol/wire/wire_mesh.hpp;
// unlike there, updates change the state in place.
import { removeRuns, type Runs } from './bytes.ts';

/** What the codes 0 and the last one of an attribute stand for, until the next KEY. */
export interface AttributeRange {
    lo: number;
    hi: number;
    /** Some vertices have no value. */
    gaps: boolean;
}

export const lastCode = 65535;
const lastOfGaps = 0xefff;
const firstNone = 0xf800;

/** NaN: no value. */
export function valueOf({ lo, hi, gaps }: AttributeRange, code: number): number {
    if (gaps && code >= firstNone) return Number.NaN;
    return lo + ((hi - lo) * code) / (gaps ? lastOfGaps : lastCode);
}

/** One number (or three, of a position) a vertex. Arrays may be longer than there are vertices. */
export class Channel {
    readonly components: number;
    readonly first = 0; // values are first .. last
    readonly last: number;
    values = new Int32Array(0);
    change = new Int32Array(0); // by the update that is being made, or else by the last
    changeBefore = new Int32Array(0); // of positions: by the update before that one

    constructor(components: number, last: number) {
        this.components = components;
        this.last = last;
    }

    remove(removed: Runs, vertices: number, remember: boolean): void {
        removeRuns(this.values, removed, vertices, this.components);
        if (remember) removeRuns(this.change, removed, vertices, this.components);
    }

    /** Nothing has changed yet. Only positions `remember` their last change; that of a code counts as 0. */
    begin(vertices: number, remember: boolean): void {
        const length = vertices * this.components;
        this.values = roomFor(this.values, length);
        if (remember) [this.change, this.changeBefore] = [this.changeBefore, roomFor(this.change, length)];
        this.change = roomFor(this.change, length).fill(0, 0, length);
    }
}

export class WireMesh {
    readonly latticeBits: number;
    readonly ranges: readonly AttributeRange[];
    readonly position: Channel;
    readonly codes: readonly Channel[]; // one an attribute
    readonly neighbours: Neighbours;
    vertices = 0;
    cellCount = 0;
    private cellRoom: Int32Array;
    private cellSum = new WordSum();

    /** @param ended a state that is no more: its memory is used again, as to get new memory for a large mesh takes long */
    constructor(latticeBits: number, ranges: readonly AttributeRange[], ended?: WireMesh) {
        this.latticeBits = latticeBits;
        this.ranges = ranges;
        this.position = ended?.latticeBits === latticeBits ? ended.position : new Channel(3, 2 ** latticeBits - 1);
        this.codes = ranges.map((_, i) => ended?.codes[i] ?? new Channel(1, lastCode));
        this.neighbours = ended?.neighbours ?? new Neighbours();
        this.cellRoom = ended?.cellRoom ?? new Int32Array(0);
    }

    /** How many vertices its memory has room for. */
    get room(): number {
        return this.position.values.length / 3;
    }

    /** cellStride ids a cell, noVertex as -1. */
    get cells(): Int32Array {
        return this.cellRoom.subarray(0, this.cellCount * cellStride);
    }

    /** Vertices go, the others close up; `vertices` is how many there are afterwards. */
    beginVertices(removed: Runs, vertices: number): void {
        for (const channel of [this.position, ...this.codes]) {
            const remember = channel === this.position;
            if (removed.count > 0) channel.remove(removed, this.vertices, remember);
            channel.begin(vertices, remember);
        }
        this.vertices = vertices;
    }

    /** Cells go, the others close up. */
    removeCells(removed: Runs): void {
        removeRuns(this.cellRoom, removed, this.cellCount, cellStride);
        this.cellCount -= removed.count;
    }

    appendCells(cells: Int32Array): void {
        const used = this.cellCount * cellStride;
        this.cellRoom = roomFor(this.cellRoom, used + cells.length);
        this.cellRoom.set(cells, used);
        this.cellCount += cells.length / cellStride;
    }

    /** After cells have changed: those below `unchanged`, and the numbers of their vertices, are as they
     *  were. */
    cellsChanged(unchanged: number): void {
        const from = unchanged === this.cellCount ? 0 : unchanged;
        if (from === 0) this.cellSum = new WordSum();
        this.cellSum.add(this.cells.subarray(from * cellStride));
        this.neighbours.find(this.cells, from, this.vertices);
    }

    /** The checksum of everything but the changes. Cost: O(vertices), cells were summed when they came. */
    stateSum(): number {
        const positions = wordSum(this.position.values.subarray(0, 3 * this.vertices));
        const parts = [this.vertices, positions, this.cellCount, this.cellSum.value()];
        for (const { values } of this.codes) parts.push(wordSum(values.subarray(0, this.vertices)));
        return wordSum(Int32Array.from(parts));
    }
}

/**
 * A cell as numbers: eight ids, corners 0-3, then the mids of sides 0-3, `noVertex` where there is none (in the server's
 * unsigned numbers 0xffffffff).
 */
export const cellStride = 8;
export const noVertex = -1;

/** Stands where there is no such neighbour. */
export const none = -1;

/** Neighbours of each vertex v, all below v. Arrays may be longer than there are vertices. */
export class Neighbours {
    highest = new Int32Array(0); // a(v)
    lowest = new Int32Array(0); // b(v)
    beside = new Int32Array(0); // p(v), of the first cell whose other corners are all lower
    beside2 = new Int32Array(0); // n(v)
    opposite = new Int32Array(0); // o(v); none where p and n are the ends of the side the vertex hangs on
    private known = 0; // vertices

    /** Finds the neighbours of all vertices; what cells below `from` say is known already, unless `from` is
     *  0. Cost: O(vertices + cells from there). */
    find(cells: Int32Array, from: number, vertices: number): void {
        const known = from === 0 ? 0 : this.known;
        for (const name of ['highest', 'lowest', 'beside', 'beside2', 'opposite'] as const) {
            this[name] = roomFor(this[name], vertices).fill(none, known, vertices);
        }
        this.known = vertices;
        this.add(cells, from);
    }

    /** Without function calls for a cell without mids: this is done for every cell of a surface that
     *  changes. */
    private add(cells: Int32Array, from: number): void {
        const { highest, lowest, beside, beside2, opposite } = this;
        for (let at = from * cellStride; at < cells.length; at += cellStride) {
            const c0 = cells[at]!;
            const c1 = cells[at + 1]!;
            const c2 = cells[at + 2]!;
            const c3 = cells[at + 3]!;
            side(highest, lowest, c0, cells[at + 4]!, c1);
            side(highest, lowest, c1, cells[at + 5]!, c2);
            side(highest, lowest, c2, cells[at + 6]!, c3);
            side(highest, lowest, c3, cells[at + 7]!, c0);
            // Only a cell's highest corner can have the other three below it.
            const v = Math.max(c0, c1, c2, c3);
            if (beside[v]! < 0) {
                const i = v === c0 ? 0 : v === c1 ? 1 : v === c2 ? 2 : 3;
                const p = cells[at + ((i + 3) & 3)]!;
                const n = cells[at + ((i + 1) & 3)]!;
                const o = cells[at + ((i + 2) & 3)]!;
                if (p !== v && n !== v && o !== v) {
                    beside[v] = p;
                    beside2[v] = n;
                    opposite[v] = o;
                }
            }
            if ((cells[at + 4]! & cells[at + 5]! & cells[at + 6]! & cells[at + 7]!) !== none) this.addMids(cells, at);
        }
    }

    /** Adds hanging vertices: that one hangs says more of its place than a cell that it is a corner of. */
    private addMids(cells: Int32Array, at: number): void {
        for (let i = 0; i < 4; ++i) {
            const mid = cells[at + 4 + i]!;
            const from = cells[at + i]!;
            const to = cells[at + ((i + 1) & 3)]!;
            if (from >= mid || to >= mid) continue;
            if (this.beside[mid]! >= 0 && this.opposite[mid]! < 0) continue;
            this.beside[mid] = from;
            this.beside2[mid] = to;
            this.opposite[mid] = none;
        }
    }
}

/** One side of a cell, over its mid if there is one. */
function side(highest: Int32Array, lowest: Int32Array, from: number, mid: number, to: number): void {
    if (mid < 0) join(highest, lowest, from, to);
    else {
        join(highest, lowest, from, mid);
        join(highest, lowest, mid, to);
    }
}

function join(highest: Int32Array, lowest: Int32Array, u: number, w: number): void {
    if (u === w) return;
    const low = u < w ? u : w;
    const high = u < w ? w : u;
    if (low > highest[high]!) highest[high] = low;
    const lowestSoFar = lowest[high]!;
    if (lowestSoFar < 0 || low < lowestSoFar) lowest[high] = low;
}

function stir(sum: number, word: number): number {
    const x = sum ^ word;
    return Math.imul((x << 13) | (x >>> 19), 0x9e3779b1);
}

/**
 * A checksum that scripts and vector units compute fast: sums, and sums of sums, in four lanes. Sums words in any number of
 * steps, each of which but the last adds a multiple of four.
 */
export class WordSum {
    private readonly sums = new Int32Array(4);
    private readonly ofSums = new Int32Array(4);
    private count = 0;

    add(words: Int32Array): void {
        const { sums, ofSums } = this;
        let a = sums[0]!;
        let b = sums[1]!;
        let c = sums[2]!;
        let d = sums[3]!;
        let e = ofSums[0]!;
        let f = ofSums[1]!;
        let g = ofSums[2]!;
        let h = ofSums[3]!;
        const whole = words.length & ~3;
        for (let at = 0; at < whole; at += 4) {
            a = (a + words[at]!) | 0;
            b = (b + words[at + 1]!) | 0;
            c = (c + words[at + 2]!) | 0;
            d = (d + words[at + 3]!) | 0;
            e = (e + a) | 0;
            f = (f + b) | 0;
            g = (g + c) | 0;
            h = (h + d) | 0;
        }
        sums[0] = a;
        sums[1] = b;
        sums[2] = c;
        sums[3] = d;
        ofSums[0] = e;
        ofSums[1] = f;
        ofSums[2] = g;
        ofSums[3] = h;
        for (let at = whole; at < words.length; ++at) {
            sums[at & 3]! += words[at]!;
            ofSums[at & 3]! += sums[at & 3]!;
        }
        this.count += words.length;
    }

    value(): number {
        let sum = this.count | 0;
        for (let lane = 0; lane < 4; ++lane) sum = stir(stir(sum, this.sums[lane]!), this.ofSums[lane]!);
        return (sum ^ (sum >>> 15)) >>> 0;
    }
}

/** Returns the sum of the words, as an unsigned number. */
export function wordSum(words: Int32Array): number {
    const sum = new WordSum();
    sum.add(words);
    return sum.value();
}

type Numbers = Int32Array | Uint32Array;

/**
 * `array` itself if it has `length` numbers, else one with the same beginning and room for half as many more:
 * pages that are not used cost nothing, growing soon again costs a copy.
 */
export function roomFor<Kind extends Numbers>(array: Kind, length: number): Kind {
    if (array.length >= length) return array;
    const make = array.constructor as new (length: number) => Kind;
    const longer = new make(length + (length >> 1));
    longer.set(array);
    return longer;
}
