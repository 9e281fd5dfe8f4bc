// Finds what predictions need of the cells: for each vertex its neighbours of lower index.
// protocol/wire/FORMAT.md, Neighbours. Twin: protocol/wire/wire_topology.hpp.
import { cellStride } from './cell.ts';
import { roomFor } from './room.ts';

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
