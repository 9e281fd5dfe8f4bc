// The body of a dataset: the frames of one KEY, one after the other, each after its length in bytes.
import { signed } from '../connection/ownServer.ts';
import type { BodyMesh } from '../mesh/bodyMesh.ts';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { dequantise, type Lattice } from '../protocol/lattice.ts';
import { MeshDecoder } from '../protocol/meshDecoder.ts';
import { triangleCount, triangulate } from '../protocol/triangulate.ts';
import { creaseNormals } from './creaseNormals.ts';

/** Null when the dataset has no obstacle. */
export async function fetchObstacle(
    { baseUrl, login }: { baseUrl: string; login: string | null },
    dataset: string,
    draco: DracoPoints,
    lattice: Lattice,
): Promise<BodyMesh | null> {
    const path = `api/v1/datasets/${encodeURIComponent(dataset)}/obstacle.bin`;
    const response = await fetch(new URL(path, baseUrl), signed(login));
    if (response.status === 404) return null;
    if (!response.ok) throw new Error(`The obstacle could not be loaded (${response.status}).`);
    return decodeObstacle(new Uint8Array(await response.arrayBuffer()), draco, lattice);
}

export function decodeObstacle(bytes: Uint8Array, draco: DracoPoints, lattice: Lattice): BodyMesh | null {
    const decoder = new MeshDecoder(draco, lattice, 0);
    for (const frame of framesOf(bytes)) decoder.fold(frame);
    const { mesh } = decoder;
    if (mesh === undefined) return null;
    const nodes = mesh.position.values.subarray(0, 3 * mesh.vertices);
    const positions = new Float32Array(nodes.length);
    dequantise(lattice, nodes, positions);
    const indices = new Uint32Array(3 * triangleCount(mesh.cells));
    triangulate(mesh.cells, positions, indices);
    return creaseNormals(positions, indices);
}

export function framesOf(bytes: Uint8Array): Uint8Array[] {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const frames: Uint8Array[] = [];
    for (let at = 0; at + 4 <= bytes.length;) {
        const length = view.getUint32(at, true);
        if (at + 4 + length > bytes.length) throw new Error('The obstacle arrived incomplete.');
        frames.push(bytes.subarray(at + 4, at + 4 + length));
        at += 4 + length;
    }
    return frames;
}
