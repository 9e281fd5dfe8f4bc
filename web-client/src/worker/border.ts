// The sides of a surface's cells, and its borders along them.
import { borderOf } from '../mesh/border.ts';
import { cellStride, noVertex } from '../protocol/cell.ts';

/** The sides of cells, over their mids. @param gone 1 for each cell that does not count */
export function eachSide(cells: Int32Array, gone: Uint8Array, use: (from: number, to: number) => void): void {
    for (let base = 0; base < cells.length; base += cellStride) {
        if (gone[base / cellStride] !== 0) continue;
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
export function neighboursOnBorder(cells: Int32Array, vertices: number, gone: Uint8Array): Map<number, number[]> {
    const onBorder = borderOf((use) => eachSide(cells, gone, use), vertices);
    const met = new Map<number, [number, number]>();
    eachSide(cells, gone, (from, to) => {
        if (onBorder[from] === 0 || onBorder[to] === 0) return;
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
