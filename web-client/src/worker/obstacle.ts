// The body of a dataset: the frames of one KEY, one after the other, each after its length in bytes. At a
// time it has the flow along it.
import { signed } from '../connection/ownServer.ts';
import type { BodyMesh } from '../mesh/bodyMesh.ts';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { dequantise, type Lattice } from '../protocol/lattice.ts';
import { MeshDecoder } from '../protocol/meshDecoder.ts';
import { triangleCount, triangulate } from '../protocol/triangulate.ts';
import { valueOf, type WireMesh } from '../protocol/wireMesh.ts';
import { creaseNormals, type DividedBody } from './creaseNormals.ts';

export interface Place {
    baseUrl: string;
    login: string | null;
}

export interface Wanted {
    dataset: string;
    lattice: Lattice;
}

/** Speed, s and t come before it. */
const velocityAt = 3;

/** Where the vertices of the body that was read last come from: its edges are not looked for again at each
 *  time. */
let last: { nodes: Int32Array; from: Uint32Array } | null = null;

/** Null when the dataset has no obstacle. */
export async function fetchObstacle(place: Place, wanted: Wanted, draco: DracoPoints): Promise<BodyMesh | null> {
    const bytes = await fetchBytes(place, wanted, '');
    return bytes === null ? null : decodeObstacle(bytes, draco, wanted.lattice);
}

/** Three numbers for each vertex of that obstacle. */
export async function fetchObstacleFlow(
    place: Place,
    wanted: Wanted & { time: number },
    draco: DracoPoints,
): Promise<Float32Array | null> {
    const bytes = await fetchBytes(place, wanted, `?time=${encodeURIComponent(String(wanted.time))}`);
    return bytes === null ? null : decodeObstacleFlow(bytes, draco, wanted.lattice);
}

export function decodeObstacle(bytes: Uint8Array, draco: DracoPoints, lattice: Lattice): BodyMesh | null {
    const mesh = meshOf(bytes, draco, lattice);
    if (mesh === undefined) return null;
    const { positions, normals, indices } = divided(mesh, lattice);
    return { positions, normals, indices };
}

export function decodeObstacleFlow(bytes: Uint8Array, draco: DracoPoints, lattice: Lattice): Float32Array | null {
    const mesh = meshOf(bytes, draco, lattice);
    if (mesh === undefined) return null;
    if (mesh.ranges.length !== velocityAt + 3) throw new Error('The server does not tell the flow along bodies.');
    const nodes = nodesOf(mesh);
    const same = last?.nodes.length === nodes.length && last.nodes.every((node, i) => node === nodes[i]);
    const from = same ? last!.from : divided(mesh, lattice).from;
    const flow = new Float32Array(3 * from.length);
    for (let axis = 0; axis < 3; ++axis) {
        const [range, { values }] = [mesh.ranges[velocityAt + axis]!, mesh.codes[velocityAt + axis]!];
        for (let i = 0; i < from.length; ++i) flow[3 * i + axis] = valueOf(range, values[from[i]!]!);
    }
    return flow;
}

async function fetchBytes({ baseUrl, login }: Place, { dataset }: Wanted, query: string): Promise<Uint8Array | null> {
    const path = `api/v1/datasets/${encodeURIComponent(dataset)}/obstacle.bin${query}`;
    const response = await fetch(new URL(path, baseUrl), signed(login));
    if (response.status === 404) return null;
    if (!response.ok) {
        const what = query === '' ? 'The obstacle' : 'The flow along the body';
        throw new Error(`${what} could not be loaded (${response.status}).`);
    }
    return new Uint8Array(await response.arrayBuffer());
}

function meshOf(bytes: Uint8Array, draco: DracoPoints, lattice: Lattice): WireMesh | undefined {
    const decoder = new MeshDecoder(draco, lattice, null);
    for (const frame of framesOf(bytes)) decoder.fold(frame);
    return decoder.mesh;
}

function nodesOf(mesh: WireMesh): Int32Array {
    return mesh.position.values.subarray(0, 3 * mesh.vertices);
}

function divided(mesh: WireMesh, lattice: Lattice): DividedBody {
    const nodes = nodesOf(mesh);
    const positions = new Float32Array(nodes.length);
    dequantise(lattice, nodes, positions);
    const indices = new Uint32Array(3 * triangleCount(mesh.cells));
    triangulate(mesh.cells, positions, indices);
    const body = creaseNormals(positions, indices);
    last = { nodes: nodes.slice(), from: body.from };
    return body;
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
