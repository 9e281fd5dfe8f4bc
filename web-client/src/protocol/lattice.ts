// The integer lattice of a dataset: every position on the wire is a node of it, so both ends agree to
// the bit. Twin: protocol/wire/lattice.hpp.

export interface Lattice {
    origin: [number, number, number];
    step: number; // distance of neighbouring nodes, in the dataset's length unit
    bits: number; // nodes are numbered 0 .. 2^bits - 1 along each axis
}

export const maxLatticeBits = 20;

/** Positions of nodes, xyz interleaved, rounded to float32. `positions` is as long as `nodes`. */
export function dequantise(lattice: Lattice, nodes: Int32Array, positions: Float32Array): void {
    const [x, y, z] = lattice.origin;
    const { step } = lattice;
    for (let i = 0; i + 2 < nodes.length; i += 3) {
        positions[i] = x + step * nodes[i]!;
        positions[i + 1] = y + step * nodes[i + 1]!;
        positions[i + 2] = z + step * nodes[i + 2]!;
    }
}
