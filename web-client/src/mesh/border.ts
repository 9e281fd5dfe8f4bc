// Which vertices of a surface are on its border: by the sides of its cells or triangles, of which those inside belong to two.

/** Calls `use` with both ends of each side of each cell, so twice for those between two. */
export type Sides = (use: (from: number, to: number) => void) => void;

/**
 * 1 for each vertex on a border. Inside, each neighbour is met by two cells, and what is written of it twice
 * is gone again; of a vertex on the border two neighbours are met once.
 */
export function borderOf(sides: Sides, vertices: number): Uint8Array {
    const met = new Int32Array(vertices);
    sides((from, to) => {
        met[from]! ^= mixed(to);
        met[to]! ^= mixed(from);
    });
    const border = new Uint8Array(vertices);
    for (let v = 0; v < vertices; ++v) if (met[v] !== 0) border[v] = 1;
    return border;
}

/** So that no sums of a few numbers are the same by chance. */
function mixed(vertex: number): number {
    const spread = Math.imul(vertex + 1, 0x9e3779b1);
    return Math.imul(spread ^ (spread >>> 15), 0x85ebca6b);
}
