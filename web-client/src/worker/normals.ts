// Normals of a triangle mesh: each vertex gets the mean of its triangles' normals, weighted by area.

/**
 * Fills `normals`, which are 0, for the vertices from `from` on; `indices` are those of the whole mesh.
 * Vertices without area stay 0.
 */
export function addNormals(positions: Float32Array, indices: Uint32Array, from: number, normals: Float32Array): void {
    for (let i = 0; i < indices.length; i += 3) {
        const a = indices[i]!;
        const b = indices[i + 1]!;
        const c = indices[i + 2]!;
        if (a < from && b < from && c < from) continue;
        const pa = 3 * a;
        const pb = 3 * b;
        const pc = 3 * c;
        const ux = positions[pb]! - positions[pa]!;
        const uy = positions[pb + 1]! - positions[pa + 1]!;
        const uz = positions[pb + 2]! - positions[pa + 2]!;
        const vx = positions[pc]! - positions[pa]!;
        const vy = positions[pc + 1]! - positions[pa + 1]!;
        const vz = positions[pc + 2]! - positions[pa + 2]!;
        const x = uy * vz - uz * vy;
        const y = uz * vx - ux * vz;
        const z = ux * vy - uy * vx;
        if (a >= from) add(normals, 3 * (a - from), x, y, z);
        if (b >= from) add(normals, 3 * (b - from), x, y, z);
        if (c >= from) add(normals, 3 * (c - from), x, y, z);
    }
    for (let i = 0; i < normals.length; i += 3) normalise(normals, i);
}

function add(normals: Float32Array, at: number, x: number, y: number, z: number): void {
    normals[at]! += x;
    normals[at + 1]! += y;
    normals[at + 2]! += z;
}

function normalise(normals: Float32Array, at: number): void {
    const x = normals[at]!;
    const y = normals[at + 1]!;
    const z = normals[at + 2]!;
    const squared = x * x + y * y + z * z;
    // Tiny triangles square to less than a float32 can hold, but these are doubles.
    if (squared === 0) return;
    const scale = 1 / Math.sqrt(squared);
    normals[at] = x * scale;
    normals[at + 1] = y * scale;
    normals[at + 2] = z * scale;
}
