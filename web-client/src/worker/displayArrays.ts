// The state of a surface as the GPU takes it: float32 positions, normals, s and t, the attributes that are
// shown, triangles. Keeps what it has made, so that a surface that only grows costs what has grown.
import { type AttributeRange, cellStride, valueOf, type WireMesh } from '../protocol/wireMesh.ts';
import { type Cut, type MeshChange, normalNames, type ScalarChange, type SurfacePart } from '../mesh/meshChange.ts';
import { dequantise, type Lattice } from '../protocol/lattice.ts';
import type { AppliedUpdate } from '../protocol/meshDecoder.ts';
import { triangleCount, triangulate } from '../protocol/triangulate.ts';
import { addNormals, unitLengths, unresolved } from './vertexQuantities.ts';
import { findParts } from './parts.ts';
import { trimTornBorder } from './tornBorder.ts';
import type { ShowWish } from './workerMessages.ts';

/** See curvedCells.ts, which is loaded when first needed. */
export type CurveCells = (change: MeshChange, cells: Int32Array, pixels: number) => MeshChange;

export class DisplayArrays {
    private readonly lattice: Lattice;
    private attributes: readonly string[];
    /** By the name of an attribute that is wanted and there: from which vertex on it has changed. */
    private shown = new Map<string, number>();
    private wish: ShowWish = { attributes: [], parts: null, trimmed: false };
    private partsRequested = false;
    private cutRequested = false;
    private unitsRequested = false;
    private unresolvedRequested = false;
    /** Whether what was given away last is of curved cells: nothing of it stays. Only take() changes
     *  it. */
    curved = false;
    private positions = new Float32Array(0);
    private seeds = new Float32Array(0);
    private indices = new Uint32Array(0);
    private triangles = 0;
    private cellsCut = 0;
    /** What has changed since take(). */
    private fromVertex = 0;
    private fromNormal = 0;
    private fromSeed = 0;
    private fromCell = 0;

    /** @param attributes what the frames carry, in their order */
    constructor(lattice: Lattice, attributes: readonly string[]) {
        this.lattice = lattice;
        this.attributes = attributes;
    }

    /** Returns what the frames carry and take() leaves out, since it has not been asked for. */
    get withheld(): string[] {
        return this.attributes.filter((name) => !this.shown.has(name));
    }

    /** Returns whether take() has anything new to give because of it. */
    show(wish: ShowWish): boolean {
        const { attributes, parts, trimmed, units } = wish;
        const before = this.wish;
        this.wish = wish;
        const isThere = (name: string): boolean => this.attributes.includes(name);
        // What is wanted may come with the next KEY: until then the picture goes on with what it has.
        const goesOn = attributes.every(isThere) ? [] : this.shown.keys();
        const known = [...new Set([...goesOn, ...attributes])].filter(isThere);
        const added = known.some((name) => !this.shown.has(name));
        this.shown = new Map(known.map((name) => [name, this.shown.get(name) ?? 0]));
        const parted = JSON.stringify(parts) !== JSON.stringify(before.parts);
        this.partsRequested ||= parted;
        this.cutRequested ||= parted || trimmed !== before.trimmed;
        const measured = units !== undefined && units !== before.units;
        this.unitsRequested ||= measured;
        const thinned = wish.unresolved !== before.unresolved;
        this.unresolvedRequested ||= thinned && wish.unresolved === true;
        return added || parted || trimmed !== before.trimmed || measured || thinned || (this.curved && wish.curved === undefined);
    }

    /** The frames carry other attributes from the next KEY on. */
    rename(attributes: readonly string[]): void {
        this.attributes = attributes;
        this.show(this.wish);
    }

    /** Notes what an update has changed; cheap, because states that are never shown need no arrays. */
    note({ header, edit, mesh }: AppliedUpdate): void {
        const { removedVertices, movedVertices, removedCells, replacedCells, cells } = edit;
        const stayed = mesh.vertices - edit.addedVertices;
        // Those behind a vertex that goes close up.
        const born = header.key ? 0 : Math.min(stayed, removedVertices.all[0]?.begin ?? stayed);
        const changed = Math.min(born, movedVertices.all[0]?.begin ?? born);
        this.fromSeed = Math.min(this.fromSeed, born);
        this.fromVertex = Math.min(this.fromVertex, changed);
        for (const [name, from] of this.shown) this.shown.set(name, Math.min(from, changed));
        // A vertex that has moved turns the normals all around it, in front of it and behind it in the order.
        const turned = header.key || removedVertices.count + removedCells.count + movedVertices.count > 0;
        this.fromNormal = Math.min(this.fromNormal, turned ? 0 : stayed);
        if (this.fromNormal > 0) this.fromNormal = lowest(cells, this.fromNormal);
        const keptCells = mesh.cellCount - cells.length / cellStride + replacedCells.count;
        if (header.key || removedVertices.count + removedCells.count > 0) this.fromCell = 0;
        this.fromCell = Math.min(this.fromCell, replacedCells.all[0]?.begin ?? keptCells);
        const isNew = turned || cells.length > 0;
        this.partsRequested ||= this.wish.parts !== null && isNew;
        this.cutRequested ||= (this.wish.parts !== null || this.wish.trimmed) && isNew;
        this.unitsRequested ||= this.wish.units !== undefined && isNew;
        this.unresolvedRequested ||= this.wish.unresolved === true && isNew;
    }

    /** Curved cells are wanted. */
    get wantsCurves(): boolean {
        return this.wish.curved !== undefined;
    }

    /** All that has been noted, in arrays to give away. @param curve makes them of curved cells, where those
     *  are wanted: all is new then, and the next time */
    take(mesh: WireMesh, curve: CurveCells | null = null): MeshChange {
        const { curved: pixels } = this.wish;
        const curved = pixels !== undefined && curve !== null;
        if (curved || this.curved) this.takeAll();
        this.curved = curved;
        const changes = this.takeChanges(mesh);
        const change = curved ? curve(changes, mesh.cells, pixels) : changes;
        const scalars = change.scalars.filter(({ name }) => !(normalNames as readonly string[]).includes(name));
        return { ...change, scalars };
    }

    private takeAll(): void {
        this.fromVertex = this.fromNormal = this.fromSeed = this.fromCell = this.cellsCut = 0;
        for (const name of this.shown.keys()) this.shown.set(name, 0);
        this.cutRequested ||= this.wish.parts !== null || this.wish.trimmed;
        this.unitsRequested ||= this.wish.units !== undefined;
        this.unresolvedRequested ||= this.wish.unresolved === true;
    }

    private takeChanges(mesh: WireMesh): MeshChange {
        const { fromVertex, fromNormal, fromSeed } = this;
        const { vertices } = mesh;
        this.positions = grown(this.positions, 3 * vertices);
        const nodes = mesh.position.values.subarray(3 * fromVertex, 3 * vertices);
        dequantise(this.lattice, nodes, this.positions.subarray(3 * fromVertex));
        this.fillSeeds(mesh, Math.min(fromVertex, fromSeed));
        const fromIndex = this.cutNewCells(mesh.cells);
        const normals = new Float32Array(3 * (vertices - fromNormal));
        addNormals(this.positions, this.indices.subarray(0, 3 * this.triangles), fromNormal, normals);
        const change = {
            vertices,
            triangles: this.triangles,
            fromVertex,
            positions: this.positions.slice(3 * fromVertex, 3 * vertices),
            fromNormal,
            normals,
            fromSeed,
            seeds: this.seeds.slice(2 * fromSeed, 2 * vertices),
            tFrom: this.rangeOf(mesh, 't')?.lo ?? 0,
            scalars: this.scalarsOf(mesh),
            fromIndex,
            indices: this.indices.slice(fromIndex, 3 * this.triangles),
            ...this.partsAndCut(mesh),
            units: this.unitsOf(mesh),
            unresolved: this.unresolvedOf(mesh),
        };
        this.fromVertex = this.fromNormal = this.fromSeed = vertices;
        this.fromCell = mesh.cellCount;
        return change;
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

    private fillSeeds(mesh: WireMesh, from: number): void {
        this.seeds = grown(this.seeds, 2 * mesh.vertices);
        const seeds = this.seeds.subarray(2 * from);
        this.fill(mesh, 's', from, seeds, 2, 0);
        this.fill(mesh, 't', from, seeds, 2, 1, this.rangeOf(mesh, 't')?.lo);
    }

    private scalarsOf(mesh: WireMesh): ScalarChange[] {
        const changes: ScalarChange[] = [];
        for (const [name, fromVertex] of this.shown) {
            if (fromVertex >= mesh.vertices) continue;
            const values = new Float32Array(mesh.vertices - fromVertex);
            this.fill(mesh, name, fromVertex, values, 1, 0);
            changes.push({ name, fromVertex, values });
            this.shown.set(name, mesh.vertices);
        }
        return changes;
    }

    private partsAndCut(mesh: WireMesh): { parts: readonly SurfacePart[] | null; cut: Cut | null } {
        const { parts: wanted, trimmed } = this.wish;
        const [partsAsked, cutAsked] = [this.partsRequested && wanted !== null, this.cutRequested];
        this.partsRequested = this.cutRequested = false;
        const { cells, vertices } = mesh;
        const seeds = this.seeds.subarray(0, 2 * vertices);
        const from = { seeds, tFrom: this.rangeOf(mesh, 't')?.lo ?? 0 };
        const found = wanted === null || !(partsAsked || cutAsked) ? null : findParts(cells, vertices, from, wanted);
        const parts = partsAsked ? (found?.parts ?? null) : null;
        if (!cutAsked) return { parts, cut: null };
        const { positions } = this;
        const trimming = trimmed ? trimTornBorder({ cells, vertices, positions, isEnd: endsOf(seeds) }) : null;
        const hides = found?.parts.some(({ hidden }) => hidden) === true;
        if (trimming === null && !hides) return { parts, cut: { levels: new Uint8Array(0), trimmedCells: 0 } };
        const levels = trimming?.levels ?? new Uint8Array(vertices);
        if (hides) found.hidden.forEach((level, v) => (levels[v] = Math.max(level, levels[v]!)));
        return { parts, cut: { levels, trimmedCells: trimming?.cells ?? 0 } };
    }

    private unitsOf(mesh: WireMesh): Float32Array | null {
        const { units } = this.wish;
        if (units === undefined || !this.unitsRequested) return null;
        this.unitsRequested = false;
        const { positions } = this;
        const indices = this.indices.subarray(0, 3 * this.triangles);
        return unitLengths({ positions, indices, seeds: this.seeds, vertices: mesh.vertices }, units === 'closed');
    }

    private unresolvedOf({ vertices }: WireMesh): Float32Array | null {
        if (!this.unresolvedRequested || this.wish.unresolved !== true) return null;
        this.unresolvedRequested = false;
        const indices = this.indices.subarray(0, 3 * this.triangles);
        const normals = new Float32Array(3 * vertices);
        addNormals(this.positions, indices, 0, normals);
        return unresolved({ positions: this.positions, normals, indices, vertices });
    }

    private rangeOf(mesh: WireMesh, name: string): AttributeRange | undefined {
        return mesh.ranges[this.attributes.indexOf(name)];
    }

    /** The values of an attribute, less `origin`, from some vertex on, NaN where there is none; those of one
     *  that does not come stay 0. */
    private fill(
        mesh: WireMesh,
        name: string,
        from: number,
        into: Float32Array,
        stride: number,
        offset: number,
        origin = 0,
    ): void {
        const values = mesh.codes[this.attributes.indexOf(name)]?.values;
        const range = this.rangeOf(mesh, name);
        if (values === undefined || range === undefined) return;
        const shifted = { ...range, lo: range.lo - origin, hi: range.hi - origin };
        for (let i = from, at = offset; i < mesh.vertices; ++i, at += stride) into[at] = valueOf(shifted, values[i]!);
    }
}

/** Where a surface was meant to end: at the ends of the rake, and at the first and the last t. @param seeds s
 *  and t in turns */
function endsOf(seeds: Float32Array): (vertex: number) => boolean {
    let [low, high] = [Infinity, -Infinity];
    for (let i = 1; i < seeds.length; i += 2) {
        low = Math.min(low, seeds[i]!);
        high = Math.max(high, seeds[i]!);
    }
    const near = 1e-4;
    const nearT = near * (high - low);
    return (vertex) => {
        const [s, t] = [seeds[2 * vertex]!, seeds[2 * vertex + 1]!];
        return s <= near || s >= 1 - near || t <= low + nearT || t >= high - nearT;
    };
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
