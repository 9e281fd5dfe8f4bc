// The cells of a state and what predictions need of them: for each vertex the neighbours of lower index.
// protocol/README.md, Neighbours. Twin: protocol/wire_topology.hpp.
import { cellStride } from './cell.ts';
import { hasMarked } from './cellsCode.ts';
import type { KeptCells } from './keptCells.ts';
import { roomFor } from './room.ts';

/// Stands where there is no such neighbour.
export const none = -1;

/// Neighbours of each vertex v, all below v. Arrays may be longer than there are vertices.
export class Neighbours {
    highest = new Int32Array(0); // a(v)
    lowest = new Int32Array(0); // b(v)
    beside = new Int32Array(0); // p(v), of the first cell whose other corners are all lower
    beside2 = new Int32Array(0); // n(v)
    opposite = new Int32Array(0); // o(v); none where p and n are the ends of the side the vertex hangs on

    /// After an update: finds the neighbours of the vertices that are marked, the others keep theirs in new numbers.
    /// Vertices keep their order, so that which neighbour is the highest or the lowest stays as well.
    follow({ now, touched }: KeptCells, cells: Int32Array, vertices: number): void {
        this.highest = roomFor(this.highest, vertices);
        this.lowest = roomFor(this.lowest, vertices);
        this.beside = roomFor(this.beside, vertices);
        this.beside2 = roomFor(this.beside2, vertices);
        this.opposite = roomFor(this.opposite, vertices);
        if (now !== undefined)
            this.renumber(now);
        for (let v = 0; v < vertices; v += 1)
            if (touched[v] !== 0)
                this.highest[v] = this.lowest[v] = this.beside[v] = this.beside2[v] = this.opposite[v] = none;
        this.add(cells, touched);
    }

    /// In place, from the first to the last: a vertex never gets a higher number.
    private renumber(now: Int32Array): void {
        const { highest, lowest, beside, beside2, opposite } = this;
        for (let v = 0; v < now.length; v += 1) {
            const to = now[v]!;
            if (to < 0)
                continue;
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

    /// Of those cells that have a marked vertex, for the marked ones.
    private add(cells: Int32Array, marked: Uint8Array): void {
        const { highest, lowest, beside, beside2, opposite } = this;
        for (let at = 0; at < cells.length; at += cellStride) {
            if (!hasMarked(cells, at, marked))
                continue;
            const c0 = cells[at]!;
            const c1 = cells[at + 1]!;
            const c2 = cells[at + 2]!;
            const c3 = cells[at + 3]!;
            side(highest, lowest, marked, c0, cells[at + 4]!, c1);
            side(highest, lowest, marked, c1, cells[at + 5]!, c2);
            side(highest, lowest, marked, c2, cells[at + 6]!, c3);
            side(highest, lowest, marked, c3, cells[at + 7]!, c0);
            // Only a cell's highest corner can have the other three below it.
            const v = Math.max(c0, c1, c2, c3);
            if (marked[v] !== 0 && beside[v]! < 0) {
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
            if ((cells[at + 4]! & cells[at + 5]! & cells[at + 6]! & cells[at + 7]!) >= 0)
                this.addMids(cells, at, marked);
        }
    }

    /// That a vertex hangs says more of its place than a cell that it is a corner of.
    private addMids(cells: Int32Array, at: number, marked: Uint8Array): void {
        for (let i = 0; i < 4; i += 1) {
            const mid = cells[at + 4 + i]!;
            const from = cells[at + i]!;
            const to = cells[at + ((i + 1) & 3)]!;
            if (from >= mid || to >= mid || marked[mid] === 0)
                continue;
            if (this.beside[mid]! >= 0 && this.opposite[mid]! < 0)
                continue;
            this.beside[mid] = from;
            this.beside2[mid] = to;
            this.opposite[mid] = none;
        }
    }
}

/// One side of a cell, over its mid if there is one.
function side(
    highest: Int32Array,
    lowest: Int32Array,
    marked: Uint8Array,
    from: number,
    mid: number,
    to: number,
): void {
    if (mid < 0)
        join(highest, lowest, marked, from, to);
    else {
        join(highest, lowest, marked, from, mid);
        join(highest, lowest, marked, mid, to);
    }
}

function join(highest: Int32Array, lowest: Int32Array, marked: Uint8Array, u: number, w: number): void {
    const low = u < w ? u : w;
    const high = u < w ? w : u;
    if (low === high || marked[high] === 0)
        return;
    if (low > highest[high]!)
        highest[high] = low;
    const lowestSoFar = lowest[high]!;
    if (lowestSoFar < 0 || low < lowestSoFar)
        lowest[high] = low;
}
