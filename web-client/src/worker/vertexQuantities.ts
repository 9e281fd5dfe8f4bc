// Quantities of the vertices of a triangle mesh: normals, how long a unit of s and t is on the surface, and what a fixed grid cannot
// resolve.

/**
 * Each vertex gets the mean of its triangles' normals, weighted by area. Fills `normals`, which are 0, for the vertices from
 * `from` on; `indices` are those of the whole mesh. Vertices without area stay 0.
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

/**
 * What even distances are measured by (core/surface/even_lines, lengths_per_unit): at a vertex the inverse of the gradient's
 * mean over its triangles. Two a vertex; 0 where the parameter does not change.
 * @param seeds s and t in turns. @param closed beside the last column of the rake lies its first
 */
export function unitLengths(
    {
        positions,
        indices,
        seeds,
        vertices,
    }: Record<'positions' | 'seeds', Float32Array> & { indices: Uint32Array; vertices: number },
    closed: boolean,
): Float32Array {
    // Of each vertex: the sums of both gradients, times the area, and of the areas.
    const sums = new Float64Array(7 * vertices);
    for (let i = 0; i < indices.length; i += 3) addTriangle(sums, positions, seeds, indices.subarray(i, i + 3), closed);
    const units = new Float32Array(2 * vertices);
    for (let v = 0; v < vertices; ++v) {
        const area = sums[7 * v + 6]!;
        for (const parameter of [0, 1]) {
            const at = 7 * v + 3 * parameter;
            const gradient = Math.hypot(sums[at]!, sums[at + 1]!, sums[at + 2]!);
            units[2 * v + parameter] = gradient > 0 ? area / gradient : 0;
        }
    }
    return units;
}

function addTriangle(
    sums: Float64Array,
    positions: Float32Array,
    seeds: Float32Array,
    corners: Uint32Array,
    closed: boolean,
): void {
    const [a, b, c] = corners as unknown as [number, number, number];
    const p = (v: number, axis: number): number => positions[3 * v + axis]!;
    const [ux, uy, uz] = [p(b, 0) - p(a, 0), p(b, 1) - p(a, 1), p(b, 2) - p(a, 2)];
    const [vx, vy, vz] = [p(c, 0) - p(a, 0), p(c, 1) - p(a, 1), p(c, 2) - p(a, 2)];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const twice = Math.sqrt(nx * nx + ny * ny + nz * nz);
    if (twice === 0) return;
    for (const parameter of [0, 1]) {
        const value = (v: number): number => seeds[2 * v + parameter]!;
        const apart = (v: number): number => {
            const by = value(v) - value(a);
            return closed && parameter === 0 ? by - Math.round(by) : by;
        };
        // Along the surface, across the other side: its value there times that side, turned by a right angle.
        const [db, dc] = [apart(b) / (2 * twice), apart(c) / (2 * twice)];
        const [gx, gy, gz] = [db * vx - dc * ux, db * vy - dc * uy, db * vz - dc * uz];
        for (const v of corners) {
            sums[7 * v + 3 * parameter]! += gy * nz - gz * ny;
            sums[7 * v + 3 * parameter + 1]! += gz * nx - gx * nz;
            sums[7 * v + 3 * parameter + 2]! += gx * ny - gy * nx;
        }
    }
    for (const v of corners) sums[7 * v + 6]! += twice / 2;
}

export interface Triangles {
    positions: Float32Array;
    /** Have length 1. */
    normals: Float32Array;
    indices: Uint32Array;
    vertices: number;
}

/** The value of half a square: 4 (1/2) / (sqrt 3 sqrt 2). */
const halfSquare = Math.sqrt(2 / 3);

/**
 * What smoke hides of a surface (after von Funck, Weinkauf, Theisel, Seidel, Smoke Surfaces, 2008). Of a triangle of area A
 * with sides a, b, c the paper's factor of shape is 4 A / (sqrt 3 max(ab, bc, ca)), 1 where they are equal; here it is counted
 * from half a square, which a grid begins with. Its factor of curvature falls with the greatest |n . e| / |e| of a vertex with
 * normal n, over the sides e that meet there. Two a vertex: what shape takes away, the mean over its triangles by their area;
 * the sine of how far sides there leave its plane.
 */
export function unresolved({ positions, normals, indices, vertices }: Triangles): Float32Array {
    const found = new Float32Array(2 * vertices);
    const areas = new Float32Array(vertices);
    for (let i = 0; i < indices.length; i += 3) {
        const corners = [indices[i]!, indices[i + 1]!, indices[i + 2]!];
        const sides = corners.map((v, k) => sideOf(positions, v, corners[(k + 1) % 3]!));
        const lengths = sides.map((side) => Math.hypot(...side));
        const [a, b, c] = lengths as [number, number, number];
        const area = Math.hypot(...cross(sides[0]!, sides[1]!)) / 2;
        const longest = Math.max(a * b, b * c, c * a);
        const shape = longest > 0 ? Math.min(1, (4 * area) / (Math.sqrt(3) * longest) / halfSquare) : 0;
        for (const [k, v] of corners.entries()) {
            found[2 * v]! += area * (1 - shape);
            areas[v]! += area;
            for (const at of [k, (k + 2) % 3]) {
                const part = lengths[at]! > 0 ? outOf(normals, v, sides[at]!) / lengths[at]! : 0;
                found[2 * v + 1] = Math.max(found[2 * v + 1]!, part);
            }
        }
    }
    for (let v = 0; v < vertices; ++v) found[2 * v] = areas[v]! > 0 ? found[2 * v]! / areas[v]! : 1;
    return found;
}

type Side = readonly [number, number, number];

function sideOf(positions: Float32Array, from: number, to: number): Side {
    const along = (axis: number): number => positions[3 * to + axis]! - positions[3 * from + axis]!;
    return [along(0), along(1), along(2)];
}

function cross([ax, ay, az]: Side, [bx, by, bz]: Side): Side {
    return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

function outOf(normals: Float32Array, v: number, [x, y, z]: Side): number {
    return Math.abs(normals[3 * v]! * x + normals[3 * v + 1]! * y + normals[3 * v + 2]! * z);
}
