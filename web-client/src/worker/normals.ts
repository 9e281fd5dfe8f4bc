// Normals of a triangle mesh: each vertex gets the mean of its triangles' normals, weighted by area.

export function vertexNormals(positions: Float32Array, indices: Uint32Array): Float32Array {
    const normals = new Float32Array(positions.length);
    for (let i = 0; i < indices.length; i += 3) addTriangle(normals, positions, indices, i);
    for (let i = 0; i < normals.length; i += 3) normalise(normals, i);
    return normals;
}

function addTriangle(
    normals: Float32Array,
    positions: Float32Array,
    indices: Uint32Array,
    at: number,
): void {
    const a = indices[at]! * 3;
    const b = indices[at + 1]! * 3;
    const c = indices[at + 2]! * 3;
    const ux = positions[b]! - positions[a]!;
    const uy = positions[b + 1]! - positions[a + 1]!;
    const uz = positions[b + 2]! - positions[a + 2]!;
    const vx = positions[c]! - positions[a]!;
    const vy = positions[c + 1]! - positions[a + 1]!;
    const vz = positions[c + 2]! - positions[a + 2]!;
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    for (const vertex of [a, b, c]) {
        normals[vertex]! += x;
        normals[vertex + 1]! += y;
        normals[vertex + 2]! += z;
    }
}

function normalise(normals: Float32Array, at: number): void {
    const length = Math.hypot(normals[at]!, normals[at + 1]!, normals[at + 2]!);
    if (length === 0) return;
    normals[at]! /= length;
    normals[at + 1]! /= length;
    normals[at + 2]! /= length;
}
