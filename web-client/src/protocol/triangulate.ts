// Triangles of cells with 0 to 4 hanging nodes, by template. Watertight: the triangles of a cell use each
// sub-edge of its outline exactly once, and none spans a side past its mid node, so none has zero area
// where a mid lies on a straight side.
import { cellStride, noVertex } from './wireMesh.ts';

/** Writes triangles, turning the way the cells' outlines turn. */
class TriangleWriter {
    readonly indices: Uint32Array;
    private at = 0;
    private readonly positions: Float32Array | Int32Array;

    constructor(indices: Uint32Array, positions: Float32Array | Int32Array) {
        this.indices = indices;
        this.positions = positions;
    }

    triangle(a: number, b: number, c: number): void {
        const { indices, at } = this;
        indices[at] = a;
        indices[at + 1] = b;
        indices[at + 2] = c;
        this.at = at + 3;
    }

    /** Cut along the shorter diagonal. */
    quad(a: number, b: number, c: number, d: number): void {
        if (this.squaredDistance(a, c) <= this.squaredDistance(b, d)) {
            this.triangle(a, b, c);
            this.triangle(a, c, d);
        } else {
            this.triangle(a, b, d);
            this.triangle(b, c, d);
        }
    }

    private squaredDistance(a: number, b: number): number {
        const p = this.positions;
        const x = p[3 * a]! - p[3 * b]!;
        const y = p[3 * a + 1]! - p[3 * b + 1]!;
        const z = p[3 * a + 2]! - p[3 * b + 2]!;
        return x * x + y * y + z * z;
    }
}

/** One cell seen with side `turn` as its side 0. */
class TurnedCell {
    private readonly cells: Int32Array;
    private readonly base: number;
    private readonly turn: number;

    constructor(cells: Int32Array, base: number, turn: number) {
        this.cells = cells;
        this.base = base;
        this.turn = turn;
    }

    corner(i: number): number {
        return this.cells[this.base + ((i + this.turn) & 3)]!;
    }

    mid(i: number): number {
        return this.cells[this.base + 4 + ((i + this.turn) & 3)]!;
    }
}

function midMask(cells: Int32Array, base: number): number {
    let mask = 0;
    for (let side = 0; side < 4; ++side) if (cells[base + 4 + side] !== noVertex) mask |= 1 << side;
    return mask;
}

const countOfMask = Uint8Array.from({ length: 16 }, (_, mask) => [1, 2, 4, 8].filter((bit) => mask & bit).length);

/** By which turn a mask becomes its template's: 1, 3 (adjacent), 5 (opposite), 7 (all but side 3) or 15. */
const turnOfMask = Uint8Array.from({ length: 16 }, (_, mask) => {
    const turned = (turn: number): number => ((mask >> turn) | (mask << (4 - turn))) & 15;
    const turn = [0, 1, 2, 3].find((t) => [0, 1, 3, 5, 7, 15].includes(turned(t)));
    return turn ?? 0;
});

function cutCell(out: TriangleWriter, cells: Int32Array, base: number, mask: number): void {
    const c = new TurnedCell(cells, base, turnOfMask[mask]!);
    switch (countOfMask[mask]!) {
        case 1:
            out.triangle(c.mid(0), c.corner(1), c.corner(2));
            out.triangle(c.mid(0), c.corner(2), c.corner(3));
            out.triangle(c.mid(0), c.corner(3), c.corner(0));
            break;
        case 2:
            if (mask === 5 || mask === 10) {
                out.quad(c.corner(0), c.mid(0), c.mid(2), c.corner(3));
                out.quad(c.mid(0), c.corner(1), c.corner(2), c.mid(2));
            } else {
                out.triangle(c.mid(0), c.corner(1), c.mid(1));
                out.triangle(c.corner(3), c.corner(0), c.mid(0));
                out.triangle(c.corner(3), c.mid(0), c.mid(1));
                out.triangle(c.corner(3), c.mid(1), c.corner(2));
            }
            break;
        case 3:
            out.triangle(c.mid(0), c.corner(1), c.mid(1));
            out.triangle(c.mid(1), c.corner(2), c.mid(2));
            out.triangle(c.mid(1), c.mid(2), c.corner(3));
            out.triangle(c.mid(1), c.corner(3), c.corner(0));
            out.triangle(c.mid(1), c.corner(0), c.mid(0));
            break;
        default:
            for (let i = 0; i < 4; ++i) out.triangle(c.mid((i + 3) & 3), c.corner(i), c.mid(i));
            out.quad(c.mid(0), c.mid(1), c.mid(2), c.mid(3));
    }
}

/** Two triangles a cell and one more for each mid. */
export function triangleCount(cells: Int32Array): number {
    let triangles = 0;
    for (let base = 0; base < cells.length; base += cellStride) triangles += 2 + countOfMask[midMask(cells, base)]!;
    return triangles;
}

/**
 * Fills `indices` with vertex ids, three a triangle.
 * `positions`: xyz of each vertex, in any unit.
 */
export function triangulate(cells: Int32Array, positions: Float32Array | Int32Array, indices: Uint32Array): void {
    const out = new TriangleWriter(indices, positions);
    for (let base = 0; base < cells.length; base += cellStride) {
        const mask = midMask(cells, base);
        if (mask === 0) out.quad(cells[base]!, cells[base + 1]!, cells[base + 2]!, cells[base + 3]!);
        else cutCell(out, cells, base, mask);
    }
}
