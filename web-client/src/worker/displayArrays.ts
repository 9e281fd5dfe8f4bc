// The state of a surface as the GPU takes it: float32 positions, normals, one scalar, triangles. Keeps what
// it has made, so that a surface that only grows costs what has grown.
import { cellStride } from '../protocol/cell.ts';
import { dequantise, type Lattice } from '../protocol/lattice.ts';
import type { AppliedUpdate } from '../protocol/meshDecoder.ts';
import { triangleCount, triangulate } from '../protocol/triangulate.ts';
import { type Channel, lastCode, type WireMesh } from '../protocol/wireMesh.ts';
import { addNormals } from './normals.ts';
import type { MeshChange } from './workerMessages.ts';

export class DisplayArrays {
    private readonly lattice: Lattice;
    /** Which attribute is shown; -1: none. */
    private readonly scalar: number;
    private positions = new Float32Array(0);
    private indices = new Uint32Array(0);
    private triangles = 0;
    private cellsCut = 0;
    /** What has changed since take(). */
    private fromVertex = 0;
    private fromCell = 0;

    constructor(lattice: Lattice, scalar: number) {
        this.lattice = lattice;
        this.scalar = scalar;
    }

    /** Notes what an update has changed; cheap, because states that are never shown need no arrays. */
    note({ header, edit, cells, mesh }: AppliedUpdate): void {
        const { removedVertices, movedVertices, removedCells, replacedCells } = edit;
        if (header.key || removedVertices.count + removedCells.count > 0) this.fromVertex = this.fromCell = 0;
        // A vertex that has moved turns the normals all around it, in front of it and behind it in the order.
        else if (movedVertices.count > 0) this.fromVertex = 0;
        const stayed = mesh.cellCount - cells.length / cellStride + replacedCells.count;
        this.fromCell = Math.min(this.fromCell, replacedCells.all[0]?.begin ?? stayed);
        this.fromVertex = Math.min(this.fromVertex, mesh.vertices - edit.addedVertices);
        if (this.fromVertex > 0) this.fromVertex = lowest(cells, this.fromVertex);
    }

    /** All that has been noted, in arrays to give away. */
    take(mesh: WireMesh): MeshChange {
        const { fromVertex } = this;
        const { vertices } = mesh;
        this.positions = grown(this.positions, 3 * vertices);
        const nodes = mesh.position.values.subarray(3 * fromVertex, 3 * vertices);
        dequantise(this.lattice, nodes, this.positions.subarray(3 * fromVertex));
        const fromIndex = this.cutNewCells(mesh.cells);
        const normals = new Float32Array(3 * (vertices - fromVertex));
        addNormals(this.positions, this.indices.subarray(0, 3 * this.triangles), fromVertex, normals);
        this.fromVertex = vertices;
        this.fromCell = mesh.cellCount;
        return {
            vertices,
            triangles: this.triangles,
            fromVertex,
            positions: this.positions.slice(3 * fromVertex, 3 * vertices),
            normals,
            scalars: this.scalarsOf(mesh, fromVertex),
            fromIndex,
            indices: this.indices.slice(fromIndex, 3 * this.triangles),
        };
    }

    /** Triangles of the cells that have changed; where they begin among the indices. */
    private cutNewCells(cells: Int32Array): number {
        if (this.fromCell === this.cellsCut && this.cellsCut * cellStride === cells.length) {
            return 3 * this.triangles;
        }
        const changed = cells.subarray(this.fromCell * cellStride);
        const before = triangleCount(cells.subarray(0, this.fromCell * cellStride));
        const triangles = before + triangleCount(changed);
        this.indices = grown(this.indices, 3 * triangles);
        triangulate(changed, this.positions, this.indices.subarray(3 * before, 3 * triangles));
        this.triangles = triangles;
        this.cellsCut = cells.length / cellStride;
        return 3 * before;
    }

    private scalarsOf(mesh: WireMesh, from: number): Float32Array {
        const scalars = new Float32Array(mesh.vertices - from);
        const codes: Channel | undefined = mesh.codes[this.scalar];
        const range = mesh.ranges[this.scalar];
        if (codes === undefined || range === undefined) return scalars;
        const width = range.hi - range.lo;
        const { values } = codes;
        for (let i = 0; i < scalars.length; i += 1) {
            scalars[i] = range.lo + (width * values[from + i]!) / lastCode;
        }
        return scalars;
    }
}

/** Ends of new cells are vertices whose normals turn. */
function lowest(ids: Int32Array, start: number): number {
    return ids.reduce((low, id) => (id >= 0 && id < low ? id : low), start);
}

function grown<Kind extends Float32Array | Uint32Array>(array: Kind, length: number): Kind {
    if (array.length >= length) return array;
    const make = array.constructor as new (length: number) => Kind;
    const longer = new make(Math.max(length, array.length + (array.length >> 1)));
    longer.set(array);
    return longer;
}
