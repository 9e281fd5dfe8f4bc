// The body of a dataset: the frames of one KEY, one after the other, each after its length in bytes. At a time it has the flow along it.
// Its normals are round where faces meet at a small angle, and have edges elsewhere: the faces about a corner are joined across every edge
// at which two of them meet at less than the crease angle; each group has the mean of its normals, by the angle that a face has there. A
// corner with several groups becomes several vertices, the first of them in its old place.
import { signed } from '../connection/ownServer.ts';
import type { BodyMesh, BodyValues } from '../mesh/meshChange.ts';
import { placesOf } from '../mesh/places.ts';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { dequantise, type Lattice } from '../protocol/lattice.ts';
import { MeshDecoder } from '../protocol/meshDecoder.ts';
import { triangleCount, triangulate } from '../protocol/triangulate.ts';
import { valueOf, type WireMesh } from '../protocol/wireMesh.ts';

export interface Place {
    baseUrl: string;
    login: string | null;
}

export interface Wanted {
    dataset: string;
    lattice: Lattice;
    /** Also those that are no part of the body. */
    allPatches: boolean;
}

/** Speed, s and t come before it. */
const velocityAt = 3;

/** Where the vertices of the body that was read last come from: its edges are not looked for again at each
 *  time. */
let last: { nodes: Int32Array; from: Uint32Array } | null = null;

/** Null when the dataset has no obstacle. */
export async function fetchObstacle(place: Place, wanted: Wanted, draco: DracoPoints): Promise<BodyMesh | null> {
    const bytes = await fetchBytes(place, wanted, {});
    return bytes === null ? null : decodeObstacle(bytes, draco, wanted.lattice);
}

/** @param wanted field: its name; empty: the flow alone */
export async function fetchBodyValues(
    place: Place,
    wanted: Wanted & { time: number; field: string },
    draco: DracoPoints,
): Promise<BodyValues | null> {
    const { time, field } = wanted;
    const bytes = await fetchBytes(place, wanted, { time: String(time), ...(field === '' ? {} : { field }) });
    return bytes === null ? null : decodeBodyValues(bytes, draco, wanted.lattice, field !== '');
}

export function decodeObstacle(bytes: Uint8Array, draco: DracoPoints, lattice: Lattice): BodyMesh | null {
    const mesh = meshOf(bytes, draco, lattice);
    if (mesh === undefined) return null;
    const { positions, normals, indices } = divided(mesh, lattice);
    return { positions, normals, indices };
}

export function decodeBodyValues(bytes: Uint8Array, draco: DracoPoints, lattice: Lattice, withField: boolean): BodyValues | null {
    const mesh = meshOf(bytes, draco, lattice);
    if (mesh === undefined) return null;
    const fieldAt = velocityAt + 3;
    if (mesh.ranges.length !== fieldAt + (withField ? 1 : 0)) {
        throw new Error('The server does not tell the values along bodies.');
    }
    const nodes = nodesOf(mesh);
    const same = last?.nodes.length === nodes.length && last.nodes.every((node, i) => node === nodes[i]);
    const from = same ? last!.from : divided(mesh, lattice).from;
    const read = (attribute: number, into: Float32Array, first: number, every: number): void => {
        const [range, { values }] = [mesh.ranges[attribute]!, mesh.codes[attribute]!];
        for (let i = 0; i < from.length; ++i) into[every * i + first] = valueOf(range, values[from[i]!]!);
    };
    const flow = new Float32Array(3 * from.length);
    for (let axis = 0; axis < 3; ++axis) read(velocityAt + axis, flow, axis, 3);
    const field = withField ? new Float32Array(from.length) : null;
    if (field !== null) read(fieldAt, field, 0, 1);
    return { flow, field };
}

async function fetchBytes(
    { baseUrl, login }: Place,
    { dataset, allPatches }: Wanted,
    asked: Record<string, string>,
): Promise<Uint8Array | null> {
    const query = new URLSearchParams({ ...asked, ...(allPatches ? { patches: 'all' } : {}) }).toString();
    const path = `api/v1/datasets/${encodeURIComponent(dataset)}/obstacle.bin${query === '' ? '' : `?${query}`}`;
    const response = await fetch(new URL(path, baseUrl), signed(login));
    if (response.status === 404) return null;
    if (!response.ok) {
        const what = asked['time'] === undefined ? 'The obstacle' : 'What is along the body';
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

/** At which a body begins to have an edge. */
export const creaseAngle = Math.PI / 6;

export interface DividedBody extends BodyMesh {
    /** Gives for each vertex that of before which is at its place. */
    from: Uint32Array;
}

/** Works for triangles that are turned either way, and for vertices that are at one place several times. */
export function creaseNormals(positions: Float32Array, indices: Uint32Array, angle = creaseAngle): DividedBody {
    const faces = faceNormals(positions, indices);
    const groups = joinedCorners(indices, placesOf(positions), faces, Math.cos(angle));
    const sums = sumsOf(groups, positions, indices, faces);
    const made = new Vertices(positions);
    const out = indices.slice();
    for (let corner = 0; corner < out.length; ++corner) {
        const face = corner - (corner % 3);
        // What has no area is not seen, and needs no vertices of its own.
        if (faces[face] === 0 && faces[face + 1] === 0 && faces[face + 2] === 0) continue;
        const root = groups.root(corner);
        out[corner] = made.vertexFor(indices[corner]!, root, groups.sign, sums);
    }
    return {
        positions: Float32Array.from(made.positions),
        normals: Float32Array.from(made.normals),
        indices: out,
        from: Uint32Array.from(made.from),
    };
}

/** Returns normals of length 1; 0 of a face without area. */
function faceNormals(p: Float32Array, indices: Uint32Array): Float64Array {
    const normals = new Float64Array(indices.length);
    for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = [3 * indices[i]!, 3 * indices[i + 1]!, 3 * indices[i + 2]!];
        const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
        const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
        const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        const length = Math.sqrt(x * x + y * y + z * z);
        if (length === 0) continue;
        normals[i] = x / length;
        normals[i + 1] = y / length;
        normals[i + 2] = z / length;
    }
    return normals;
}

/** The next corner of the same triangle. */
function after(corner: number): number {
    return corner % 3 === 2 ? corner - 2 : corner + 1;
}

/** Returns the angle of the triangle at one of its corners. */
function cornerAngle(p: Float32Array, indices: Uint32Array, corner: number): number {
    const [a, b, c] = [3 * indices[corner]!, 3 * indices[after(corner)]!, 3 * indices[after(after(corner))]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    const lengths = Math.sqrt((ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz));
    if (lengths === 0) return 0;
    return Math.acos(Math.min(1, Math.max(-1, (ux * vx + uy * vy + uz * vz) / lengths)));
}

/** Corners of triangles in groups; a corner whose triangle is turned the other way than its group's first has
 *  the sign -1. */
class CornerGroups {
    /** The sign of the corner whose root was asked for last. */
    sign = 1;
    private readonly parent: Int32Array;
    /** Against the parent. */
    private readonly turned: Int8Array;

    constructor(corners: number) {
        this.parent = Int32Array.from({ length: corners }, (_, i) => i);
        this.turned = new Int8Array(corners).fill(1);
    }

    root(corner: number): number {
        let [root, sign] = [corner, 1];
        while (this.parent[root] !== root) {
            sign *= this.turned[root]!;
            root = this.parent[root]!;
        }
        this.parent[corner] = root;
        this.turned[corner] = sign;
        this.sign = sign;
        return root;
    }

    join(a: number, b: number, turned: number): void {
        const one = this.root(a);
        const sign = this.sign;
        const other = this.root(b);
        if (one === other) return;
        this.parent[other] = one;
        this.turned[other] = sign * this.sign * turned;
    }
}

/** Joined across edges that exactly two triangles have: where more meet, there is no telling which of them
 *  are one side. */
function joinedCorners(indices: Uint32Array, places: Uint32Array, faces: Float64Array, cosine: number): CornerGroups {
    const groups = new CornerGroups(indices.length);
    /** By edge, the corner that it leads from first; and from there the second, or -2 where there are
     *  more. */
    const firsts = new Map<number, number>();
    const seconds = new Int32Array(indices.length).fill(-1);
    const placeOf = (corner: number): number => places[indices[corner]!]!;
    for (let corner = 0; corner < indices.length; ++corner) {
        const [a, b] = [placeOf(corner), placeOf(after(corner))];
        // Walls of triangles come as quads of which two corners are one: half of each has no area, and is not
        // there.
        if (a === b || a === placeOf(after(after(corner))) || b === placeOf(after(after(corner)))) continue;
        const key = Math.min(a, b) * places.length + Math.max(a, b);
        const first = firsts.get(key);
        if (first === undefined) firsts.set(key, corner);
        else seconds[first] = seconds[first] === -1 ? corner : -2;
    }
    for (let one = 0; one < indices.length; ++one) {
        const other = seconds[one]!;
        if (other < 0) continue;
        // Neighbours that are turned alike run along their edge in opposite ways.
        const sameWay = placeOf(one) === placeOf(other);
        const turned = sameWay ? -1 : 1;
        const [f, g] = [one - (one % 3), other - (other % 3)];
        const between = faces[f]! * faces[g]! + faces[f + 1]! * faces[g + 1]! + faces[f + 2]! * faces[g + 2]!;
        if (turned * between < cosine) continue;
        groups.join(one, sameWay ? other : after(other), turned);
        groups.join(after(one), sameWay ? after(other) : other, turned);
    }
    return groups;
}

/** At the root of each group: of its faces' normals, by the angles at which they meet there. */
function sumsOf(groups: CornerGroups, positions: Float32Array, indices: Uint32Array, faces: Float64Array): Float64Array {
    const sums = new Float64Array(3 * indices.length);
    for (let corner = 0; corner < indices.length; ++corner) {
        const at = 3 * groups.root(corner);
        const weight = groups.sign * cornerAngle(positions, indices, corner);
        const face = corner - (corner % 3);
        sums[at]! += weight * faces[face]!;
        sums[at + 1]! += weight * faces[face + 1]!;
        sums[at + 2]! += weight * faces[face + 2]!;
    }
    return sums;
}

/** Those of before, and more where a vertex needs several normals. */
class Vertices {
    readonly positions: number[];
    readonly normals: number[];
    readonly from: number[];
    /** Holds for a vertex the group and side that it has been taken for, and the next vertex at its place; 0:
     *  none. */
    private readonly takenFor: number[];
    private readonly next: number[];

    constructor(positions: Float32Array) {
        this.positions = Array.from(positions);
        this.normals = new Array<number>(positions.length).fill(0);
        this.from = Array.from({ length: positions.length / 3 }, (_, i) => i);
        this.takenFor = new Array<number>(positions.length / 3).fill(0);
        this.next = new Array<number>(positions.length / 3).fill(0);
    }

    vertexFor(vertex: number, root: number, sign: number, sums: Float64Array): number {
        const wanted = sign * (root + 1);
        let at = vertex;
        while (this.takenFor[at] !== wanted) {
            if (this.takenFor[at] === 0) break;
            const next = this.next[at]!;
            at = next === 0 ? this.another(vertex, at) : next;
        }
        if (this.takenFor[at] === 0) this.take(at, wanted, sign, 3 * root, sums);
        return at;
    }

    private another(vertex: number, last: number): number {
        const made = this.takenFor.length;
        this.next[last] = made;
        this.next.push(0);
        this.takenFor.push(0);
        this.from.push(vertex);
        for (let k = 0; k < 3; ++k) {
            this.positions.push(this.positions[3 * vertex + k]!);
            this.normals.push(0);
        }
        return made;
    }

    private take(vertex: number, wanted: number, sign: number, at: number, sums: Float64Array): void {
        this.takenFor[vertex] = wanted;
        const length = Math.hypot(sums[at]!, sums[at + 1]!, sums[at + 2]!);
        if (length === 0) return;
        for (let k = 0; k < 3; ++k) this.normals[3 * vertex + k] = (sign * sums[at + k]!) / length;
    }
}
