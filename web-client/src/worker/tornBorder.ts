// Cuts what is not drawn of a surface where it is torn, so that its border is as smooth as one would draw it:
// quads that stick out one by one, crumbs, and of the quads along the border what lies outside of a smooth
// line. Levels of the vertices say so, and the GPU cuts where levels between vertices pass `cutLevel`: cells,
// triangles and vertices stay as the server has sent them.
import { borderOf } from '../mesh/border.ts';
import { cutLevel, wholeCut } from '../mesh/meshChange.ts';
import { cellStride, noVertex } from '../protocol/cell.ts';
import { eachSide } from './border.ts';
import { BorderCord, type TornSurface } from './borderCord.ts';
import { rootsOf } from './parts.ts';

export interface Trimming {
    /** Has a level for each vertex. */
    levels: Uint8Array;
    /** Is the number of cells of which something is cut. */
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
    const whole = new Uint8Array(cells.length / cellStride);
    const torn = borderOf((use) => eachSide(cells, whole, use), vertices);
    for (let v = 0; v < vertices; ++v) if (torn[v] !== 0 && isEnd(v)) torn[v] = 0;
    if (!torn.includes(1)) return null;
    const gone = leftOut(surface, torn);
    const levels = new Uint8Array(vertices);
    if (gone.includes(1)) {
        eachVertex(cells, gone, 1, (v) => (levels[v] = wholeCut));
        eachVertex(cells, gone, 0, (v) => (levels[v] = torn[v] !== 0 ? cutLevel : 0));
    }
    for (const [v, depth] of new BorderCord(surface, torn, gone).smooth()) levels[v] = Math.round(cutLevel / (1 - depth));
    let cut = 0;
    for (let base = 0; base < cells.length; base += cellStride) {
        let touched = gone[base / cellStride] !== 0;
        for (let i = 0; i < 4; ++i) touched ||= levels[cells[base + i]!]! > cutLevel;
        if (touched) ++cut;
    }
    return cut === 0 ? null : { levels, cells: cut };
}

function eachVertex(cells: Int32Array, gone: Uint8Array, which: 0 | 1, use: (vertex: number) => void): void {
    for (let base = 0; base < cells.length; base += cellStride) {
        if (gone[base / cellStride] !== which) continue;
        for (let i = 0; i < cellStride; ++i) if (cells[base + i] !== noVertex) use(cells[base + i]!);
    }
}

/** 1 for each cell that is not drawn at all. */
function leftOut({ cells, vertices, isEnd }: TornSurface, torn: Uint8Array): Uint8Array {
    const count = cells.length / cellStride;
    const gone = new Uint8Array(count);
    const roots = rootsOf(cells, vertices);
    const size = new Int32Array(vertices);
    const thin = new Int32Array(vertices);
    const ended = new Uint8Array(vertices);
    const thinCells: number[] = [];
    for (let base = 0; base < cells.length; base += cellStride) {
        const root = roots[cells[base]!]!;
        ++size[root]!;
        let inside = false;
        for (let i = 0; i < cellStride; ++i) {
            const v = cells[base + i]!;
            if (v === noVertex) continue;
            inside ||= torn[v] === 0;
            if (torn[v] === 0 && isEnd(v)) ended[root] = 1;
        }
        if (inside) continue;
        ++thin[root]!;
        thinCells.push(base);
    }
    for (let base = 0; base < cells.length; base += cellStride) {
        const root = roots[cells[base]!]!;
        const crumb = ended[root] === 0 && size[root]! <= largestCrumb && size[root]! * wholeOverCrumb <= count;
        if (crumb) gone[base / cellStride] = 1;
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
