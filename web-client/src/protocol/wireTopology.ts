// The cells of a state and what predictions need of them: for each vertex the neighbours of lower index.
// protocol/README.md, Neighbours. Twin: protocol/wire_topology.hpp.
import { cellStride } from './cellsCode.ts';
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

    /// Vertices from `from` on have no neighbours yet.
    reset(from: number, vertices: number): void {
        this.highest = roomFor(this.highest, vertices).fill(none, from, vertices);
        this.lowest = roomFor(this.lowest, vertices).fill(none, from, vertices);
        this.beside = roomFor(this.beside, vertices).fill(none, from, vertices);
        this.beside2 = roomFor(this.beside2, vertices).fill(none, from, vertices);
        this.opposite = roomFor(this.opposite, vertices).fill(none, from, vertices);
    }

    /// Cells must come in order; those that were added before stay added.
    add(cells: Int32Array): void {
        for (let at = 0; at < cells.length; at += cellStride) {
            this.addOutline(cells, at);
            this.addHighestCorner(cells, at);
            this.addMids(cells, at);
        }
    }

    private addOutline(cells: Int32Array, at: number): void {
        for (let i = 0; i < 4; i += 1) {
            const from = cells[at + i]!;
            const to = cells[at + ((i + 1) & 3)]!;
            const mid = cells[at + 4 + i]!;
            if (mid < 0)
                this.join(from, to);
            else {
                this.join(from, mid);
                this.join(mid, to);
            }
        }
    }

    private join(u: number, w: number): void {
        if (u === w)
            return;
        const low = u < w ? u : w;
        const high = u < w ? w : u;
        if (low > this.highest[high]!)
            this.highest[high] = low;
        if (this.lowest[high]! < 0 || low < this.lowest[high]!)
            this.lowest[high] = low;
    }

    /// Only a cell's highest corner can have the other three below it.
    private addHighestCorner(cells: Int32Array, at: number): void {
        let i = 0;
        for (let k = 1; k < 4; k += 1)
            if (cells[at + k]! > cells[at + i]!)
                i = k;
        const v = cells[at + i]!;
        const p = cells[at + ((i + 3) & 3)]!;
        const n = cells[at + ((i + 1) & 3)]!;
        const o = cells[at + ((i + 2) & 3)]!;
        if (this.beside[v]! >= 0 || p === v || n === v || o === v)
            return;
        this.beside[v] = p;
        this.beside2[v] = n;
        this.opposite[v] = o;
    }

    /// That a vertex hangs says more of its place than a cell that it is a corner of.
    private addMids(cells: Int32Array, at: number): void {
        for (let i = 0; i < 4; i += 1) {
            const mid = cells[at + 4 + i]!;
            const from = cells[at + i]!;
            const to = cells[at + ((i + 1) & 3)]!;
            if (from >= mid || to >= mid)
                continue;
            if (this.beside[mid]! >= 0 && this.opposite[mid]! < 0)
                continue;
            this.beside[mid] = from;
            this.beside2[mid] = to;
            this.opposite[mid] = none;
        }
    }
}
