// Finds what a fixed grid cannot resolve of a surface (after von Funck, Weinkauf, Theisel, Seidel, Smoke
// Surfaces, 2008): smoke hides it. Of a triangle of area A with sides a, b, c the paper's factor of shape is
// 4 A / (sqrt 3 max(ab, bc, ca)), 1 where they are equal; here it is counted from half a square, which a grid
// begins with. Its factor of curvature falls with the greatest |n . e| / |e| of a vertex with normal n, over
// the sides e that meet there.

export interface Triangles {
    positions: Float32Array;
    /** Have length 1. */
    normals: Float32Array;
    indices: Uint32Array;
    vertices: number;
}

/** Is the value of half a square: 4 (1/2) / (sqrt 3 sqrt 2). */
const halfSquare = Math.sqrt(2 / 3);

/** Two a vertex: what shape takes away, the mean over its triangles by their area; the sine of how far sides
 *  there leave its plane. */
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
