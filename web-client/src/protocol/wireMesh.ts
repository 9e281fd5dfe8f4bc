// The state of a surface on the wire: integers that the server and all its clients hold alike.
// protocol/wire/FORMAT.md, State. Twin: protocol/wire/wire_mesh.hpp; unlike there, updates change it in
// place.
import { cellStride } from './cell.ts';
import { Neighbours } from './neighbours.ts';
import { roomFor } from './room.ts';
import { removeRuns, type Runs } from './runs.ts';
import { WordSum, wordSum } from './stateSum.ts';

/** Describes what the codes 0 and the last one of an attribute stand for, until the next KEY. */
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
    readonly neighbours = new Neighbours();
    vertices = 0;
    cellCount = 0;
    private cellRoom = new Int32Array(0);
    private cellSum = new WordSum();

    constructor(latticeBits: number, ranges: readonly AttributeRange[]) {
        this.latticeBits = latticeBits;
        this.ranges = ranges;
        this.position = new Channel(3, 2 ** latticeBits - 1);
        this.codes = ranges.map(() => new Channel(1, lastCode));
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
