// The cells of a state and what predictions need of them: for each vertex the neighbours of lower index.
// protocol/wire/README.md, Neighbours. Twin: protocol/wire/wire_topology.hpp.
import { cellStride } from './cell.ts';
import type { KeptCells } from './keptCells.ts';
import { roomFor } from './room.ts';
import type { Runs } from './runs.ts';

/** Stands where there is no such neighbour. */
export const none = -1;

/** Neighbours of each vertex v, all below v. Arrays may be longer than there are vertices. */
export class Neighbours {
    highest = new Int32Array(0); // a(v)
    lowest = new Int32Array(0); // b(v)
    beside = new Int32Array(0); // p(v), of the first cell whose other corners are all lower
    beside2 = new Int32Array(0); // n(v)
    opposite = new Int32Array(0); // o(v); none where p and n are the ends of the side the vertex hangs on

    /**
     * After an update of the cells, of which those from `keptCells` on were added: finds the neighbours of vertices that have other
     * cells than before, the others keep theirs in new numbers. Vertices keep their order, so that which neighbour is the highest or the
     * lowest stays as well.
     */
    follow(kept: KeptCells, replaced: Runs, keptCells: number, cells: Int32Array, vertices: number): void {
        const { now, touched, near } = kept;
        this.highest = roomFor(this.highest, vertices);
        this.lowest = roomFor(this.lowest, vertices);
        this.beside = roomFor(this.beside, vertices);
        this.beside2 = roomFor(this.beside2, vertices);
        this.opposite = roomFor(this.opposite, vertices);
        if (now !== undefined) this.renumber(now);
        for (let v = 0; v < touched.length; ++v) if (touched[v] !== 0) this.forget(v);
        for (let v = touched.length; v < vertices; ++v) this.forget(v);
        if (this.forgetTaken(touched, replaced, cells)) {
            this.add(cells, 0, cells.length / cellStride);
            return;
        }
        let next = 0;
        for (const { begin, end } of replaced.all) {
            for (; next < near.length && near[next]! < begin; ++next) this.add(cells, near[next]!, near[next]! + 1);
            this.add(cells, begin, end);
        }
        for (; next < near.length; ++next) this.add(cells, near[next]!, near[next]! + 1);
        this.add(cells, keptCells, cells.length / cellStride);
    }

    private forget(v: number): void {
        this.highest[v] = this.lowest[v] = this.beside[v] = this.beside2[v] = this.opposite[v] = none;
    }

    /**
     * Whether a cell that replaces another takes a vertex that has lost nothing: which cell is the first there may then be another
     * one. Forgets the neighbours of those.
     */
    private forgetTaken(touched: Uint8Array, replaced: Runs, cells: Int32Array): boolean {
        let taken = false;
        for (const { begin, end } of replaced.all) {
            for (let at = begin * cellStride; at < end * cellStride; ++at) {
                const v = cells[at]!;
                if (v < 0 || v >= touched.length || touched[v] !== 0) continue;
                this.forget(v);
                taken = true;
            }
        }
        return taken;
    }

    /** In place, from the first to the last: a vertex never gets a higher number. */
    private renumber(now: Int32Array): void {
        const { highest, lowest, beside, beside2, opposite } = this;
        for (let v = 0; v < now.length; ++v) {
            const to = now[v]!;
            if (to < 0) continue;
            const a = highest[v]!;
            highest[to] = a < 0 ? none : now[a]!;
            lowest[to] = a < 0 ? none : now[lowest[v]!]!; // there is none where there is no highest
            const p = beside[v]!;
            beside[to] = p < 0 ? none : now[p]!;
            beside2[to] = p < 0 ? none : now[beside2[v]!]!;
            const o = opposite[v]!;
            opposite[to] = o < 0 ? none : now[o]!;
        }
    }

    /** Cells first .. last - 1. Adding one again makes no difference. */
    private add(cells: Int32Array, first: number, last: number): void {
        const { highest, lowest, beside, beside2, opposite } = this;
        for (let at = first * cellStride; at < last * cellStride; at += cellStride) {
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
            if ((cells[at + 4]! & cells[at + 5]! & cells[at + 6]! & cells[at + 7]!) >= 0) this.addMids(cells, at);
        }
    }

    /** That a vertex hangs says more of its place than a cell that it is a corner of. */
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
