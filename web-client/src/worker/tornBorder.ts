// Cuts what is not drawn of a surface where it is torn, so that its border is as smooth as one would draw it:
// quads that stick out one by one, crumbs, and of the quads along the border what lies outside of a smooth
// line. Levels of the vertices say so, and the GPU cuts where levels between vertices pass `cutLevel`: cells,
// triangles and vertices stay as the server has sent them.
import { cutLevel, meet, notZero, wholeCut } from '../mesh/meshChange.ts';
import { cellStride, noVertex } from '../protocol/wireMesh.ts';
import { rootsOf } from './parts.ts';

export interface Trimming {
    /** Has a level for each vertex. */
    levels: Uint8Array;
    /** The number of cells of which something is cut. */
    cells: number;
}

/** Longer rows of single quads are what the flow has made of the surface, not what tearing has left of it. */
const longestTooth = 12;
/** Limits crumbs, in cells, where the whole has so many times more. */
const largestCrumb = 8;
const wholeOverCrumb = 50;

/** Null: nothing is cut. */
export function trimTornBorder(surface: TornSurface): Trimming | null {
    const { cells, vertices, isEnd } = surface;
    const border = borderOfCells(cells, vertices);
    const torn = border.slice();
    for (let v = 0; v < vertices; ++v) if (torn[v] !== 0 && isEnd(v)) torn[v] = 0;
    if (!torn.includes(1)) return null;
    const gone = leftOut(surface, torn);
    const levels = new Uint8Array(vertices);
    let [left, borderLeft] = [cells, border];
    if (gone.includes(1)) {
        left = cellsOf(cells, (base) => gone[base / cellStride] === 0);
        borderLeft = borderOfCells(left, vertices);
        levels.fill(wholeCut);
        for (const v of left) if (v !== noVertex) levels[v] = torn[v] !== 0 ? cutLevel : 0;
    }
    // The rest is far from the border, and most of a surface.
    const rim = cellsOf(left, (base) => hasOne(left, base, borderLeft, true));
    const cord = new BorderCord({ ...surface, cells: rim }, torn, borderLeft);
    for (const [v, depth] of cord.smooth()) levels[v] = Math.round(cutLevel / (1 - depth));
    let cut = (cells.length - left.length) / cellStride;
    for (let base = 0; base < rim.length; base += cellStride) {
        let touched = false;
        for (let i = 0; i < 4; ++i) touched ||= levels[rim[base + i]!]! > cutLevel;
        if (touched) ++cut;
    }
    return cut === 0 ? null : { levels, cells: cut };
}

function cellsOf(cells: Int32Array, is: (base: number) => boolean): Int32Array {
    const bases: number[] = [];
    for (let base = 0; base < cells.length; base += cellStride) if (is(base)) bases.push(base);
    const some = new Int32Array(bases.length * cellStride);
    bases.forEach((base, i) => some.set(cells.subarray(base, base + cellStride), i * cellStride));
    return some;
}

/** Whether a vertex of the cell is marked, or one is not. */
function hasOne(cells: Int32Array, base: number, marks: Uint8Array, marked: boolean): boolean {
    for (let i = base; i < base + cellStride; ++i) {
        if (cells[i] !== noVertex && (marks[cells[i]!] !== 0) === marked) return true;
    }
    return false;
}

/** 1 for each cell that is not drawn at all. */
function leftOut({ cells, vertices, isEnd }: TornSurface, torn: Uint8Array): Uint8Array {
    const count = cells.length / cellStride;
    const gone = new Uint8Array(count);
    const roots = rootsOf(cells, vertices);
    const size = new Int32Array(vertices);
    const thin = new Int32Array(vertices);
    const thinCells: number[] = [];
    for (let base = 0; base < cells.length; base += cellStride) {
        const root = roots[cells[base]!]!;
        ++size[root]!;
        if (hasOne(cells, base, torn, false)) continue;
        ++thin[root]!;
        thinCells.push(base);
    }
    const isSmall = (root: number): boolean => size[root]! <= largestCrumb && size[root]! * wholeOverCrumb <= count;
    const ended = new Uint8Array(vertices);
    for (let v = 0; v < vertices; ++v) if (torn[v] === 0 && isSmall(roots[v]!) && isEnd(v)) ended[roots[v]!] = 1;
    for (let base = 0; base < cells.length; base += cellStride) {
        const root = roots[cells[base]!]!;
        if (isSmall(root) && ended[root] === 0) gone[base / cellStride] = 1;
    }
    for (const tooth of chainsOf(thinCells, cells)) {
        const root = roots[cells[tooth[0]!]!]!;
        // A surface that is narrow as a whole is what a user asked for.
        if (tooth.length > longestTooth || 2 * thin[root]! > size[root]!) continue;
        for (const base of tooth) gone[base / cellStride] = 1;
    }
    return gone;
}

/** Those that share a vertex, together. */
function chainsOf(bases: readonly number[], cells: Int32Array): number[][] {
    const chainOf = new Map<number, number[]>();
    const chains = new Set<number[]>();
    for (const base of bases) {
        let chain = [base];
        chains.add(chain);
        for (let i = 0; i < cellStride; ++i) {
            const v = cells[base + i]!;
            if (v === noVertex) continue;
            const other = chainOf.get(v);
            if (other !== undefined && other !== chain && chains.has(other)) {
                const [longer, shorter] = other.length >= chain.length ? [other, chain] : [chain, other];
                chains.delete(shorter);
                for (const each of shorter) for (let k = 0; k < cellStride; ++k) chainOf.set(cells[each + k]!, longer);
                longer.push(...shorter);
                chain = longer;
            }
            chainOf.set(v, chain);
        }
    }
    return [...chains];
}

export interface TornSurface {
    cells: Int32Array;
    vertices: number;
    positions: Float32Array;
    /** Returns whether a vertex is where the surface was meant to end: an end of the rake, the first or the
     *  last time. */
    isEnd: (vertex: number) => boolean;
}

/** Limits the cord to this part of a quad's depth: the cord stays within the outermost quads. */
const deepest = 0.75;
/** Smoothing that leaves alone what is larger than a few vertices (Taubin 1995): inwards and outwards in
 *  turns. */
const steps = Array.from({ length: 12 }, (_, i) => (i % 2 === 0 ? 0.6 : -0.63));
const cuts = 4;

/** A smooth line along the torn border of a surface, within its outermost cells. Lies along the torn border, and is smoothed there. */
export class BorderCord {
    private readonly surface: TornSurface;
    /** Vertices on the border; arrays go by their place here. */
    private readonly vertices: readonly number[];
    /** Neighbours along the border, by their places; below 0: it stays. */
    private readonly before: Int32Array;
    private readonly after: Int32Array;
    /** From the vertex to those inside that it is joined with, xyz. */
    private readonly inward: Float64Array;
    /** Is measured inwards: where the border is, and where a smooth one would be; below 0 outside of it. */
    private readonly depth: Float64Array;
    private readonly wanted: Float64Array;

    /** @param surface needs those cells alone that touch the border. @param torn 1 where the border is to be smooth */
    constructor(surface: TornSurface, torn: Uint8Array, border: Uint8Array) {
        this.surface = surface;
        const neighbours = neighboursOnBorder(surface.cells, surface.vertices, border);
        this.vertices = [...neighbours.keys()];
        const count = this.vertices.length;
        const placeOf = new Int32Array(surface.vertices).fill(-1);
        this.vertices.forEach((vertex, i) => (placeOf[vertex] = i));
        [this.before, this.after] = [new Int32Array(count).fill(-1), new Int32Array(count)];
        [this.inward, this.depth, this.wanted] = [new Float64Array(3 * count), new Float64Array(count), new Float64Array(count)];
        const inside = this.insideOf(torn, placeOf);
        this.vertices.forEach((vertex, i) => {
            const [before, after, ...more] = neighbours.get(vertex)!;
            const sum = inside.subarray(4 * i, 4 * i + 4);
            if (torn[vertex] === 0 || before === undefined || after === undefined || more.length > 0 || sum[3] === 0) return;
            [this.before[i], this.after[i]] = [placeOf[before]!, placeOf[after]!];
            for (let k = 0; k < 3; ++k) this.inward[3 * i + k] = sum[k]! / sum[3]! - this.at(vertex, k);
        });
    }

    /** Where a smooth border would be, of the way inwards from each vertex; below 0 outside of it. */
    smooth(): [vertex: number, depth: number][] {
        for (let i = 0; i < cuts; ++i) this.cut();
        const { before, depth, wanted } = this;
        const all = this.vertices.map((vertex, i): [number, number] => [vertex, depth[i]! > 0.02 ? depth[i]! : wanted[i]!]);
        return all.filter((_, i) => before[i]! >= 0);
    }

    /** Cuts off what sticks out of the border as smoothed: without what is left of dents, which the next cut
     *  makes less of. */
    private cut(): void {
        const { before, inward, depth, wanted } = this;
        const here = new Float64Array(inward.length);
        this.vertices.forEach((vertex, i) => {
            for (let k = 0; k < 3; ++k) here[3 * i + k] = this.at(vertex, k) + depth[i]! * inward[3 * i + k]!;
        });
        let [from, to] = [here.slice(), here.slice()];
        for (const by of steps) {
            this.step(from, to, by);
            [from, to] = [to, from];
        }
        for (let i = 0; i < before.length; ++i) {
            let [along, squared] = [0, 0];
            for (let k = 3 * i; k < 3 * i + 3; ++k) {
                along += (from[k]! - here[k]!) * inward[k]!;
                squared += inward[k]! ** 2;
            }
            const way = squared > 0 ? along / squared : 0;
            depth[i] = Math.min(deepest, depth[i]! + Math.max(0, way));
            wanted[i] = Math.max(-1, Math.min(0, way));
        }
    }

    /** Each by a part of the way to the line between its neighbours, where that is as far along as it is. */
    private step(from: Float64Array, to: Float64Array, by: number): void {
        const { before, after } = this;
        for (let i = 0; i < before.length; ++i) {
            if (before[i]! < 0) continue;
            const [at, a, b] = [3 * i, 3 * before[i]!, 3 * after[i]!];
            const [toA, toB] = [distance(from, at, a), distance(from, at, b)];
            const weight = toA + toB > 0 ? toB / (toA + toB) : 0.5;
            for (let k = 0; k < 3; ++k) {
                const x = from[at + k]!;
                to[at + k] = x + by * (from[a + k]! * weight + from[b + k]! * (1 - weight) - x);
            }
        }
    }

    private at(vertex: number, axis: number): number {
        return this.surface.positions[3 * vertex + axis]!;
    }

    /** Sums of the places of what lies inside, and of how many: across a side, or else across a cell. */
    private insideOf(torn: Uint8Array, placeOf: Int32Array): Float64Array {
        const sums = new Float64Array(4 * this.vertices.length);
        const add = (vertex: number, inner: number): void => {
            const sum = 4 * placeOf[vertex]!;
            for (let k = 0; k < 3; ++k) sums[sum + k]! += this.at(inner, k);
            ++sums[sum + 3]!;
        };
        const { cells } = this.surface;
        const isOn = (vertex: number): boolean => torn[vertex] !== 0 && placeOf[vertex]! >= 0;
        eachSide(cells, (from, to) => {
            if (isOn(from) && placeOf[to]! < 0) add(from, to);
            if (isOn(to) && placeOf[from]! < 0) add(to, from);
        });
        const across = sums.slice();
        for (let base = 0; base < cells.length; base += cellStride) {
            for (let i = 0; i < 4; ++i) {
                const [corner, opposite] = [cells[base + i]!, cells[base + ((i + 2) & 3)]!];
                if (!isOn(corner) || placeOf[opposite]! >= 0) continue;
                if (across[4 * placeOf[corner]! + 3] === 0) add(corner, opposite);
            }
        }
        return sums;
    }
}

function distance(places: Float64Array, a: number, b: number): number {
    return Math.sqrt(
        (places[a]! - places[b]!) ** 2 + (places[a + 1]! - places[b + 1]!) ** 2 + (places[a + 2]! - places[b + 2]!) ** 2,
    );
}

/** As borderOf() of their sides, without a call for each. */
export function borderOfCells(cells: Int32Array, vertices: number): Uint8Array {
    const met = new Int32Array(vertices);
    for (let base = 0; base < cells.length; base += cellStride) {
        for (let i = 0; i < 4; ++i) {
            const from = cells[base + i]!;
            const mid = cells[base + 4 + i]!;
            const to = cells[base + ((i + 1) & 3)]!;
            meet(met, from, mid === noVertex ? to : mid);
            if (mid !== noVertex) meet(met, mid, to);
        }
    }
    return notZero(met);
}

/** The sides of cells, over their mids. */
export function eachSide(cells: Int32Array, use: (from: number, to: number) => void): void {
    for (let base = 0; base < cells.length; base += cellStride) {
        for (let i = 0; i < 4; ++i) {
            const from = cells[base + i]!;
            const mid = cells[base + 4 + i]!;
            const to = cells[base + ((i + 1) & 3)]!;
            if (mid !== noVertex) use(from, mid);
            if (from !== to || mid !== noVertex) use(mid === noVertex ? from : mid, to);
        }
    }
}

/** The neighbours along the border of each vertex that is on one. */
function neighboursOnBorder(cells: Int32Array, vertices: number, border: Uint8Array): Map<number, number[]> {
    const met = new Map<number, [number, number]>();
    eachSide(cells, (from, to) => {
        if (border[from] === 0 || border[to] === 0) return;
        const side = Math.min(from, to) * vertices + Math.max(from, to);
        if (met.has(side)) met.delete(side);
        else met.set(side, [from, to]);
    });
    const neighbours = new Map<number, number[]>();
    for (const [from, to] of met.values()) {
        for (const [u, w] of [
            [from, to],
            [to, from],
        ] as const) {
            const known = neighbours.get(u);
            if (known === undefined) neighbours.set(u, [w]);
            else known.push(w);
        }
    }
    return neighbours;
}
