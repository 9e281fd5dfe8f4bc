// Connected parts of a surface: a tear leaves several. Found by joining the vertices of each cell (disjoint
// sets with path halving, Tarjan and van Leeuwen 1984).
import { cellStride, noVertex } from '../protocol/wireMesh.ts';
import { type SurfacePart, wholeCut } from '../mesh/meshChange.ts';
import type { PartsWish } from './workerMessages.ts';

/** Returns for each vertex the first vertex of its part. */
export function rootsOf(cells: Int32Array, vertices: number): Int32Array {
    const parent = new Int32Array(vertices);
    for (let i = 0; i < vertices; ++i) parent[i] = i;
    const find = (vertex: number): number => {
        let at = vertex;
        while (parent[at] !== at) {
            parent[at] = parent[parent[at]!]!;
            at = parent[at]!;
        }
        return at;
    };
    for (let base = 0; base < cells.length; base += cellStride) {
        let root = find(cells[base]!);
        for (let i = base + 1; i < base + cellStride; ++i) {
            const other = cells[i]!;
            if (other === noVertex || parent[other] === root) continue;
            // The lower one leads, so that a part keeps its root while it grows.
            const joined = find(other);
            if (root < joined) parent[joined] = root;
            else {
                parent[root] = joined;
                root = joined;
            }
        }
    }
    for (let i = 0; i < vertices; ++i) parent[i] = find(i);
    return parent;
}

/** Connected parts, and the levels (`Cut`) of those that are hidden. @param seeds s and t less tFrom of each
 *  vertex */
export function findParts(
    cells: Int32Array,
    vertices: number,
    { seeds, tFrom }: { seeds: Float32Array; tFrom: number },
    wish: PartsWish,
): { hidden: Uint8Array; parts: readonly SurfacePart[] } {
    const roots = rootsOf(cells, vertices);
    const cellsOf = new Map<number, number>();
    for (let base = 0; base < cells.length; base += cellStride) {
        const root = roots[cells[base]!]!;
        cellsOf.set(root, (cellsOf.get(root) ?? 0) + 1);
    }
    const hiddenRoots = new Set(wish.hidden.map(([s, t]) => roots[nearest(seeds, [s, t - tFrom])] ?? -1));
    const parts: SurfacePart[] = [...cellsOf]
        .sort(([a], [b]) => a - b)
        .map(([root, count]) => ({
            cells: count,
            seed: [seeds[2 * root] ?? 0, tFrom + (seeds[2 * root + 1] ?? 0)],
            hidden: hiddenRoots.has(root),
        }));
    const hidden = new Uint8Array(vertices);
    if (hiddenRoots.size > 0) roots.forEach((root, i) => (hidden[i] = hiddenRoots.has(root) ? wholeCut : 0));
    return { hidden, parts };
}

/** The vertex nearest to a place on the surface; s and t count alike, as they span it. */
function nearest(seeds: Float32Array, [s, t]: readonly [number, number]): number {
    let low = Number.POSITIVE_INFINITY;
    let high = Number.NEGATIVE_INFINITY;
    for (let i = 1; i < seeds.length; i += 2) {
        low = Math.min(low, seeds[i]!);
        high = Math.max(high, seeds[i]!);
    }
    const scale = high > low ? 1 / (high - low) : 1;
    let best = -1;
    let least = Number.POSITIVE_INFINITY;
    for (let i = 0; 2 * i < seeds.length; ++i) {
        const [ds, dt] = [seeds[2 * i]! - s, (seeds[2 * i + 1]! - t) * scale];
        const apart = ds * ds + dt * dt;
        if (apart < least) [least, best] = [apart, i];
    }
    return best;
}
