// One surface in the scene. Its buffers are larger than the mesh and are refilled in place, so that
// a stream of new states costs one upload each and no allocation.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, type ShaderMaterial, Sphere, type TypedArray } from 'three';
import type { TimedMeshChange } from '../../mesh/meshChange.ts';
import type { Vec3 } from '../../protocol/messages.ts';
import type { Bounds } from '../domain/domainAxes.ts';

/** A vertex as it is drawn; `scalar` is what the surface is coloured by, if that comes from the server. */
export interface SurfaceVertex {
    point: Vec3;
    normal: Vec3;
    scalar: number;
    s: number;
    t: number;
    /** The velocity, where it came with the surface. */
    flow: Vec3 | null;
}

type Range = [number, number];

const smallestCapacity = 1 << 14;
export const stretchName = 'deformation';
const intervalName = 'interval_error';
/** Name the components of the velocity, which the flow texture follows. */
export const flowNames = ['velocity_x', 'velocity_y', 'velocity_z'] as const;

/** What a buffer holds; those that are not always there are made when first filled. */
const kinds = {
    position: { size: 3, array: Float32Array },
    normal: { size: 3, array: Float32Array },
    seed: { size: 2, array: Float32Array },
    scalar: { size: 1, array: Float32Array },
    stretch: { size: 1, array: Float32Array },
    interval: { size: 1, array: Float32Array },
    cut: { size: 1, array: Uint8Array },
    flowX: { size: 1, array: Float32Array },
    flowY: { size: 1, array: Float32Array },
    flowZ: { size: 1, array: Float32Array },
    unit: { size: 2, array: Float32Array },
    unresolved: { size: 2, array: Float32Array },
} as const;
type Kind = keyof typeof kinds;
const flowKinds = ['flowX', 'flowY', 'flowZ'] as const;

export class SurfaceMesh {
    readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
    /** Which attribute the surface is to be coloured by. */
    wantedScalar = 'speed';
    time = 0;
    vertices = 0;
    /** The range of all values so far, since the buffers were last filled from the start. */
    scalarRange: Range = emptyRange();
    /** What t is counted from in its buffer: MeshChange.tFrom. */
    tFrom = 0;
    private intervalKnown = false;
    private seenT: Range = emptyRange();
    private vertexCapacity = 0;
    private indexCapacity = 0;
    /** Which attribute the scalars in the buffer are. */
    private heldScalar = '';
    private readonly used = new Set<Kind>(['position', 'normal', 'seed', 'scalar']);
    /** Says up to which vertex values came with the mesh as it is: buffers keep those of the one before, which
     *  say nothing of it. */
    private readonly filled = new Map<Kind, number>();

    constructor(material: ShaderMaterial) {
        this.mesh = new Mesh(new BufferGeometry(), material);
        // Bounds would have to be recomputed at every state; the domain is in view nearly always.
        this.mesh.frustumCulled = false;
    }

    /** The attribute that every vertex has a scalar of; empty: there is none. */
    get scalar(): string {
        return this.has('scalar') ? this.heldScalar : '';
    }

    get hasStretch(): boolean {
        return this.has('stretch');
    }

    /** Whether any vertex has an error between stored times: none has until it is estimated. */
    get hasIntervals(): boolean {
        return this.has('interval') && this.intervalKnown;
    }

    get hasFlow(): boolean {
        return flowKinds.every((kind) => this.has(kind));
    }

    get hasUnits(): boolean {
        return this.has('unit');
    }

    get hasUnresolved(): boolean {
        return this.has('unresolved');
    }

    get tRange(): Range {
        return [this.tFrom + this.seenT[0], this.tFrom + this.seenT[1]];
    }

    update(change: TimedMeshChange): void {
        const { vertices, triangles, fromVertex, fromSeed, positions, normals, seeds, cut } = change;
        this.reserve(vertices, 3 * triangles);
        this.time = change.time;
        this.vertices = vertices;
        for (const [kind, upTo] of this.filled) this.filled.set(kind, Math.min(upTo, fromVertex));
        this.refill('position', positions, 3 * fromVertex);
        this.refill('normal', normals, 3 * change.fromNormal);
        this.refill('seed', seeds, 2 * fromSeed);
        this.tFrom = change.tFrom;
        this.seenT = widened(fromSeed === 0 && seeds.length > 0 ? emptyRange() : this.seenT, seeds, 2, 1);
        for (const each of change.scalars) this.takeScalar(each.name, each.values, each.fromVertex);
        if (cut !== null) this.refill('cut', cut.levels, 0);
        // What no one has said to be cut is drawn.
        const said = cut?.levels.length === 0 ? 0 : (this.filled.get('cut') ?? 0);
        if (this.used.has('cut')) this.refill('cut', new Uint8Array(vertices - said), said);
        if (change.units !== null) this.refill('unit', change.units, 0);
        if (change.unresolved !== null) this.refill('unresolved', change.unresolved, 0);
        const { geometry } = this.mesh;
        if (geometry.index !== null) refill(geometry.index, change.indices, change.fromIndex);
        geometry.setDrawRange(0, 3 * triangles);
        this.mesh.visible = triangles > 0;
    }

    /** Round all vertices; null: there are none. */
    get box(): Bounds | null {
        if (this.vertices === 0) return null;
        const { array } = this.attribute('position');
        const low = [Infinity, Infinity, Infinity];
        const high = [-Infinity, -Infinity, -Infinity];
        for (let i = 0; i < 3 * this.vertices; ++i) {
            low[i % 3] = Math.min(low[i % 3]!, array[i]!);
            high[i % 3] = Math.max(high[i % 3]!, array[i]!);
        }
        return [low[0]!, high[0]!, low[1]!, high[1]!, low[2]!, high[2]!];
    }

    vertex(i: number): SurfaceVertex {
        const seed = this.attribute('seed');
        const at = (kind: 'position' | 'normal'): Vec3 => {
            const values = this.attribute(kind);
            return [values.getX(i), values.getY(i), values.getZ(i)];
        };
        return {
            point: at('position'),
            normal: at('normal'),
            scalar: this.has('scalar') ? this.attribute('scalar').getX(i) : Number.NaN,
            s: seed.getX(i),
            t: this.tFrom + seed.getY(i),
            flow: this.hasFlow ? (flowKinds.map((kind) => this.attribute(kind).getX(i)) as Vec3) : null,
        };
    }

    dispose(): void {
        this.mesh.geometry.dispose();
    }

    private takeScalar(name: string, values: Float32Array, from: number): void {
        if (name === stretchName) this.refill('stretch', values, from);
        if (name === intervalName) {
            this.refill('interval', values, from);
            this.intervalKnown = (from > 0 && this.intervalKnown) || values.some(Number.isFinite);
        }
        const component = flowNames.findIndex((each) => each === name);
        if (component >= 0) this.refill(flowKinds[component]!, values, from);
        if (name === this.wantedScalar && from === 0) this.heldScalar = name;
        // What was shown before goes on until what is wanted is here.
        if (name !== this.heldScalar) return;
        this.refill('scalar', values, from);
        this.scalarRange = widened(from === 0 ? emptyRange() : this.scalarRange, values, 1, 0);
    }

    private has(kind: Kind): boolean {
        return this.filled.get(kind) === this.vertices;
    }

    private attribute(name: Kind): BufferAttribute {
        return this.mesh.geometry.getAttribute(name) as BufferAttribute;
    }

    private refill(name: Kind, values: TypedArray, from: number): void {
        if (values.length === 0) return;
        if (!this.used.has(name)) {
            this.used.add(name);
            // Made with the others: the vertex array on the GPU is bound to the geometry as a whole.
            this.rebuild();
        }
        refill(this.attribute(name), values, from);
        const { size } = kinds[name];
        if (from / size <= (this.filled.get(name) ?? 0)) this.filled.set(name, (from + values.length) / size);
    }

    private reserve(vertices: number, indices: number): void {
        if (vertices <= this.vertexCapacity && indices <= this.indexCapacity) return;
        this.vertexCapacity = grown(this.vertexCapacity, vertices);
        this.indexCapacity = grown(this.indexCapacity, indices);
        this.rebuild();
    }

    /** A buffer on the GPU cannot grow: a larger geometry takes the place of the old one. */
    private rebuild(): void {
        const old = this.mesh.geometry;
        old.dispose();
        const geometry = new BufferGeometry();
        for (const name of this.used) {
            const { size, array } = kinds[name];
            const attribute = new BufferAttribute(new array(this.vertexCapacity * size), size);
            geometry.setAttribute(name, dynamic(attribute, old.attributes[name]));
        }
        const index = new BufferAttribute(new Uint32Array(this.indexCapacity), 1);
        geometry.setIndex(dynamic(index, old.index));
        geometry.boundingSphere = new Sphere(undefined, Number.POSITIVE_INFINITY);
        geometry.setDrawRange(old.drawRange.start, old.drawRange.count);
        this.mesh.geometry = geometry;
    }
}

function grown(capacity: number, needed: number): number {
    let size = Math.max(capacity, smallestCapacity);
    while (size < needed) size *= 2;
    return size;
}

function emptyRange(): Range {
    return [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
}

function widened([low, high]: Range, values: Float32Array, stride: number, offset: number): Range {
    let [least, most] = [low, high];
    for (let i = offset; i < values.length; i += stride) {
        const value = values[i]!;
        if (value < least) least = value;
        if (value > most) most = value;
    }
    return [least, most];
}

/** Refilled often, and beginning like the attribute whose place it takes. */
function dynamic(attribute: BufferAttribute, old: { array: ArrayLike<number> } | null | undefined): BufferAttribute {
    attribute.setUsage(DynamicDrawUsage);
    if (old !== null && old !== undefined) attribute.array.set(old.array);
    return attribute;
}

/** Marks one range for the upload, around all that has changed since the last. */
function refill(attribute: BufferAttribute, values: TypedArray, from: number): void {
    if (values.length === 0) return;
    attribute.array.set(values, from);
    let [start, end] = [from, from + values.length];
    for (const range of attribute.updateRanges) {
        start = Math.min(start, range.start);
        end = Math.max(end, range.start + range.count);
    }
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(start, end - start);
    attribute.needsUpdate = true;
}
