// Measures how long a unit of s, and one of t, is on a surface: what even distances are measured by
// (core/surface/even_lines, lengths_per_unit). At a vertex it is the inverse of the gradient's mean over its
// triangles.

/**
 * Two a vertex; 0 where the parameter does not change.
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
