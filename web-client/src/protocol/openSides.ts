// The sides of cells that have no neighbour yet: a cell that comes later is most likely to lie along some of them.
// protocol/wire/README.md, Cells code. Twin: protocol/wire/open_sides.hpp.

import { noVertex } from './cell.ts';

/** Of each vertex at most one side that leaves it and one that arrives; where corners meet in a point the older is forgotten. */
export class OpenSides {
    private readonly leavesTo: Int32Array;
    private readonly arrivesFrom: Int32Array;

    /** All ids are below `vertices`. */
    constructor(vertices: number) {
        this.leavesTo = new Int32Array(vertices).fill(noVertex);
        this.arrivesFrom = new Int32Array(vertices).fill(noVertex);
    }

    /** A side of a cell, counter-clockwise from `x` to `y`: closes the neighbour's, from `y` to `x`, or is open now. */
    join(x: number, y: number): void {
        const { leavesTo, arrivesFrom } = this;
        const leaves = leavesTo[y] === x;
        const arrives = arrivesFrom[x] === y;
        if (leaves) leavesTo[y] = noVertex;
        if (arrives) arrivesFrom[x] = noVertex;
        if (leaves || arrives) return;
        leavesTo[x] = y;
        arrivesFrom[y] = x;
    }

    /** The vertex after `v` round a cell that closes the open side at `v`; noVertex where none is known. */
    after(v: number): number {
        return this.arrivesFrom[v]!;
    }

    /** The vertex before `v`, likewise. */
    before(v: number): number {
        return this.leavesTo[v]!;
    }
}
