// What a surface is coloured by, with the area that each value stands for: a third of the triangles round its vertex. For histograms.
import type { Camera } from 'three';
import { Matrix4, Vector4 } from 'three';
import type { SurfaceMesh } from './surfaceMesh.ts';
import type { SurfaceStyle } from './surfaceStyle.ts';

export interface WeighedValues {
    values: number[];
    weights: number[];
}

/** Of larger meshes every so many triangles are taken: a histogram is no finer for more. Values at the others have no weight. */
const mostTriangles = 200_000;

/** @param camera  leaves out what is beside its picture; null: all counts */
export function weighedValues(
    mesh: Pick<SurfaceMesh, 'mesh' | 'vertices' | 'time' | 'tFrom'>,
    { source, tIsRelease }: Pick<SurfaceStyle, 'source' | 'tIsRelease'>,
    camera: Pick<Camera, 'projectionMatrix' | 'matrixWorldInverse'> | null,
): WeighedValues {
    const { geometry } = mesh.mesh;
    const index = geometry.index?.array ?? [];
    const triangles = geometry.drawRange.count / 3;
    const positions = geometry.getAttribute('position')?.array ?? [];
    const areas = new Float64Array(mesh.vertices);
    const every = Math.max(1, Math.ceil(triangles / mostTriangles));
    /** Corners of any triangle. */
    const used = new Uint8Array(mesh.vertices);
    for (let i = 0; i < 3 * triangles; ++i) used[index[i]!] = 1;
    for (let i = 0; i < triangles; i += every) {
        const [a, b, c] = [index[3 * i]!, index[3 * i + 1]!, index[3 * i + 2]!];
        const third = areaOf(positions, a, b, c) / 3;
        for (const corner of [a, b, c]) areas[corner]! += third;
    }
    const isSeen = camera === null ? () => true : seenBy(camera, positions);
    const seeds = geometry.getAttribute('seed')?.array ?? [];
    const scalars = geometry.getAttribute('scalar')?.array ?? [];
    const valueOf = (i: number): number => {
        if (source === 'scalar') return scalars[i] ?? Number.NaN;
        if (source === 's') return seeds[2 * i] ?? Number.NaN;
        const t = mesh.tFrom + (seeds[2 * i + 1] ?? Number.NaN);
        return tIsRelease ? mesh.time - t : t;
    };
    const found: WeighedValues = { values: [], weights: [] };
    for (let i = 0; i < mesh.vertices; ++i) {
        const value = valueOf(i);
        if (used[i] === 0 || !Number.isFinite(value) || !isSeen(i)) continue;
        found.values.push(value);
        found.weights.push(areas[i]!);
    }
    return found;
}

function areaOf(positions: ArrayLike<number>, a: number, b: number, c: number): number {
    const side = (to: number, k: number): number => positions[3 * to + k]! - positions[3 * a + k]!;
    const [ux, uy, uz, vx, vy, vz] = [side(b, 0), side(b, 1), side(b, 2), side(c, 0), side(c, 1), side(c, 2)];
    return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}

function seenBy(
    camera: Pick<Camera, 'projectionMatrix' | 'matrixWorldInverse'>,
    positions: ArrayLike<number>,
): (i: number) => boolean {
    const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const place = new Vector4();
    return (i) => {
        place.set(positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!, 1).applyMatrix4(matrix);
        return Math.abs(place.x) <= place.w && Math.abs(place.y) <= place.w;
    };
}
