// Cells cut into smaller ones on curved patches, for a picture that stands still: sides are cubics that set
// out along the tangent planes of their ends (Vlachos et al., Curved PN Triangles, 2001), cells blend their
// sides (Coons, 1967). Of fourth order with the normals that the surface's tangents have, where they come
// with it; with means of the triangles round a vertex, of third.
import { type MeshChange, normalNames } from '../mesh/meshChange.ts';
import { cellStride, noVertex } from '../protocol/wireMesh.ts';
import { triangleCount, triangulate } from '../protocol/triangulate.ts';

const finest = 8;
/** Limits the quads of the picture: more would take longer to upload than it is worth. */
const maxQuadsWhenCurved = 400_000;
/** Sine of the angle between a side and the tangent plane, beyond which the side stays straight: there is an
 *  edge. */
const steepest = 0.4;

/** With normals from the server, where they are among the scalars, in place of its own, turned the way of
 *  those. REQUIRES: of all vertices */
export function withSentNormals(change: MeshChange): MeshChange {
    const [x, y, z] = normalNames.map((name) => change.scalars.find((each) => each.name === name)?.values);
    if (x === undefined || y === undefined || z === undefined) return change;
    const normals = change.normals.slice();
    for (let v = 0; v < change.vertices; ++v) {
        const along = x[v]! * normals[3 * v]! + y[v]! * normals[3 * v + 1]! + z[v]! * normals[3 * v + 2]!;
        if (!Number.isFinite(along)) continue;
        const turn = along < 0 ? -1 : 1;
        normals.set([turn * x[v]!, turn * y[v]!, turn * z[v]!], 3 * v);
    }
    return { ...change, normals };
}

/** All of a surface: each array from its first vertex on. @param pixels a unit of length has in the
 *  picture */
export function curvedChange(flat: MeshChange, cells: Int32Array, pixels: number): MeshChange {
    const change = withSentNormals(flat);
    const sides = new Sides(change, cells);
    const pieces = piecesFor(sides.bulge * pixels, cells.length / cellStride);
    return pieces === 1 ? change : new Cutter(change, cells, sides, pieces).change();
}

/** Returns so many that no piece is off by more than a pixel. */
function piecesFor(pixels: number, cells: number): number {
    const wanted = Math.ceil(Math.sqrt(pixels));
    const allowed = Math.floor(Math.sqrt(maxQuadsWhenCurved / Math.max(cells, 1)));
    return Math.max(1, Math.min(wanted, allowed, finest));
}

/** What two cells share: from one vertex to the next along their outlines, each once. */
class Sides {
    readonly ends: number[] = [];
    /** The farthest from its chord that a side is. */
    bulge = 0;
    private readonly numbers = new Map<number, number>();
    private readonly vertices: number;

    constructor(change: MeshChange, cells: Int32Array) {
        this.vertices = change.vertices;
        for (let base = 0; base < cells.length; base += cellStride) {
            for (let k = 0; k < 4; ++k) {
                const mid = cells[base + 4 + k]!;
                const [a, b] = [cells[base + k]!, cells[base + ((k + 1) & 3)]!];
                if (mid === noVertex) this.add(change, a, b);
                else {
                    this.add(change, a, mid);
                    this.add(change, mid, b);
                }
            }
        }
    }

    get count(): number {
        return this.ends.length / 2;
    }

    number(a: number, b: number): number {
        return this.numbers.get(this.key(a, b))!;
    }

    private key(a: number, b: number): number {
        return Math.min(a, b) * this.vertices + Math.max(a, b);
    }

    private add(change: MeshChange, a: number, b: number): void {
        const key = this.key(a, b);
        if (this.numbers.has(key)) return;
        this.numbers.set(key, this.count);
        this.ends.push(Math.min(a, b), Math.max(a, b));
        const { lean, length } = leanOf(change, a, b);
        this.bulge = Math.max(this.bulge, (length * (Math.abs(lean[0]) + Math.abs(lean[1]))) / 8);
    }
}

interface Leaning {
    /** The lean of the chord over its length, along the normals at both ends; 0 where the side stays
     *  straight. */
    lean: readonly [number, number];
    length: number;
}

function leanOf({ positions, normals }: MeshChange, a: number, b: number): Leaning {
    let [length, atA, atB] = [0, 0, 0];
    for (let i = 0; i < 3; ++i) {
        const way = positions[3 * b + i]! - positions[3 * a + i]!;
        length += way * way;
        atA += way * normals[3 * a + i]!;
        atB += way * normals[3 * b + i]!;
    }
    length = Math.sqrt(length);
    const steep = Math.max(Math.abs(atA), Math.abs(atB)) > steepest * length;
    return { lean: steep || length === 0 ? [0, 0] : [atA / length, atB / length], length };
}

class Cutter {
    private readonly from: MeshChange;
    private readonly cells: Int32Array;
    private readonly sides: Sides;
    private readonly n: number;
    private readonly inCells: number;
    private readonly total: number;
    private readonly positions: Float32Array;
    /** By place behind the vertices there were: of which ones it is a mean, and with what shares. */
    private readonly of: Uint32Array;
    private readonly share: Float32Array;

    constructor(from: MeshChange, cells: Int32Array, sides: Sides, pieces: number) {
        [this.from, this.cells, this.sides, this.n] = [from, cells, sides, pieces];
        this.inCells = from.vertices + sides.count * (pieces - 1);
        this.total = this.inCells + (cells.length / cellStride) * (pieces - 1) ** 2;
        this.positions = new Float32Array(3 * this.total);
        this.positions.set(from.positions);
        this.of = new Uint32Array(4 * (this.total - from.vertices));
        this.share = new Float32Array(this.of.length);
    }

    change(): MeshChange {
        const { from, n } = this;
        for (let k = 0; k < this.sides.count; ++k) this.cutSide(k);
        const fine = new Int32Array(this.cells.length * n * n).fill(noVertex);
        for (let c = 0; c < this.cells.length / cellStride; ++c) this.cutCell(c, fine);
        const triangles = triangleCount(fine);
        const indices = new Uint32Array(3 * triangles);
        triangulate(fine, this.positions, indices);
        const normals = this.means(from.normals, 3);
        for (let v = 3 * from.vertices; v < normals.length; v += 3) {
            const length = Math.hypot(normals[v]!, normals[v + 1]!, normals[v + 2]!);
            for (let i = 0; i < 3 && length > 0; ++i) normals[v + i]! /= length;
        }
        return {
            ...from,
            vertices: this.total,
            triangles,
            positions: this.positions,
            normals,
            seeds: this.means(from.seeds, 2),
            scalars: from.scalars.map((each) => ({ ...each, values: this.means(each.values, 1) })),
            indices,
            cut:
                from.cut === null || from.cut.levels.length === 0
                    ? from.cut
                    : { ...from.cut, levels: Uint8Array.from(this.means(from.cut.levels, 1)) },
            units: from.units === null ? null : this.means(from.units, 2),
            unresolved: from.unresolved === null ? null : this.means(from.unresolved, 1),
        };
    }

    private means(values: Float32Array | Uint8Array, size: number): Float32Array {
        const out = new Float32Array(this.total * size);
        out.set(values);
        for (let at = 0, to = this.from.vertices * size; at < this.of.length; at += 4) {
            for (let i = 0; i < size; ++i, ++to) {
                let sum = 0;
                for (let k = at; k < at + 4; ++k) if (this.share[k]! > 0) sum += this.share[k]! * values[this.of[k]! * size + i]!;
                out[to] = sum;
            }
        }
        return out;
    }

    private set(vertex: number, of: readonly number[], share: readonly number[]): void {
        const at = 4 * (vertex - this.from.vertices);
        this.of.set(of, at);
        this.share.set(share, at);
    }

    private cutSide(k: number): void {
        const { from, n, positions } = this;
        const [a, b] = [this.sides.ends[2 * k]!, this.sides.ends[2 * k + 1]!];
        const { lean, length } = leanOf(from, a, b);
        for (let j = 1; j < n; ++j) {
            const part = j / n;
            const rest = 1 - part;
            const vertex = from.vertices + k * (n - 1) + j - 1;
            this.set(vertex, [a, b], [rest, part]);
            const bend = part * rest * length;
            for (let i = 0; i < 3; ++i) {
                positions[3 * vertex + i] =
                    rest * positions[3 * a + i]! +
                    part * positions[3 * b + i]! +
                    bend * (part * lean[1] * from.normals[3 * b + i]! - rest * lean[0] * from.normals[3 * a + i]!);
            }
        }
    }

    private between(a: number, b: number, j: number): number {
        if (j === 0) return a;
        if (j === this.n) return b;
        return this.from.vertices + this.sides.number(a, b) * (this.n - 1) + (a < b ? j : this.n - j) - 1;
    }

    /** The vertex j pieces along side k of a cell; there are twice as many where a node hangs. */
    private onSide(base: number, k: number, j: number): number {
        const [a, b, mid] = [this.cells[base + k]!, this.cells[base + ((k + 1) & 3)]!, this.cells[base + 4 + k]!];
        if (mid === noVertex) return this.between(a, b, j);
        return j < this.n ? this.between(a, mid, j) : this.between(mid, b, j - this.n);
    }

    private cutCell(c: number, fine: Int32Array): void {
        const { n, positions } = this;
        const base = c * cellStride;
        const corners = [...this.cells.subarray(base, base + 4)];
        const step = [0, 1, 2, 3].map((k) => (this.cells[base + 4 + k] === noVertex ? 1 : 2));
        const at = (i: number, j: number): number => {
            if (j === 0) return this.onSide(base, 0, i * step[0]!);
            if (i === n) return this.onSide(base, 1, j * step[1]!);
            if (j === n) return this.onSide(base, 2, (n - i) * step[2]!);
            if (i === 0) return this.onSide(base, 3, (n - j) * step[3]!);
            return this.inCells + (c * (n - 1) + j - 1) * (n - 1) + i - 1;
        };
        for (let j = 1; j < n; ++j) {
            for (let i = 1; i < n; ++i) {
                const [u, v] = [i / n, j / n];
                const shares = [(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v];
                const vertex = at(i, j);
                this.set(vertex, corners, shares);
                const [below, right, above, left] = [at(i, 0), at(n, j), at(i, n), at(0, j)];
                for (let x = 0; x < 3; ++x) {
                    const p = (w: number): number => positions[3 * w + x]!;
                    positions[3 * vertex + x] =
                        (1 - v) * p(below) +
                        v * p(above) +
                        (1 - u) * p(left) +
                        u * p(right) -
                        corners.reduce((sum, corner, k) => sum + shares[k]! * p(corner), 0);
                }
            }
        }
        for (let j = 0; j < n; ++j) {
            for (let i = 0; i < n; ++i) {
                const to = ((c * n + j) * n + i) * cellStride;
                fine.set([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], to);
                const on = [j === 0, i + 1 === n, j + 1 === n, i === 0];
                const piece = [i, j, n - 1 - i, n - 1 - j];
                for (let k = 0; k < 4; ++k) {
                    if (on[k] && step[k] === 2) fine[to + 4 + k] = this.onSide(base, k, 2 * piece[k]! + 1);
                }
            }
        }
    }
}
