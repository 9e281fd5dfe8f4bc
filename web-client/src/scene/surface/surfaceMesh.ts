// One surface in the scene. Its buffers are larger than the mesh and are refilled in place, so that
// a stream of new states costs one upload each and no allocation.
import {
    BufferAttribute,
    BufferGeometry,
    DynamicDrawUsage,
    Mesh,
    type ShaderMaterial,
    Sphere,
} from 'three';

/** What is new in a mesh: everything from some vertex and some index on. */
export interface MeshChange {
    vertices: number;
    triangles: number;
    fromVertex: number;
    positions: Float32Array;
    normals: Float32Array;
    scalars: Float32Array;
    fromIndex: number;
    indices: Uint32Array;
}

const smallestCapacity = 1 << 14;
const attributes = [
    ['position', 3],
    ['normal', 3],
    ['scalar', 1],
] as const;

export class SurfaceMesh {
    readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
    private vertexCapacity = 0;
    private indexCapacity = 0;

    constructor(material: ShaderMaterial) {
        this.mesh = new Mesh(new BufferGeometry(), material);
        // Bounds would have to be recomputed at every state; the domain is in view nearly always.
        this.mesh.frustumCulled = false;
    }

    update(change: MeshChange): void {
        const { vertices, triangles, fromVertex, positions, normals, scalars } = change;
        this.reserve(vertices, 3 * triangles);
        const { geometry } = this.mesh;
        refill(this.attribute('position'), positions, 3 * fromVertex);
        refill(this.attribute('normal'), normals, 3 * fromVertex);
        refill(this.attribute('scalar'), scalars, fromVertex);
        if (geometry.index !== null) refill(geometry.index, change.indices, change.fromIndex);
        geometry.setDrawRange(0, 3 * triangles);
        this.mesh.visible = triangles > 0;
    }

    vertex(i: number): { point: [number, number, number]; scalar: number } {
        const position = this.attribute('position');
        const point: [number, number, number] = [position.getX(i), position.getY(i), position.getZ(i)];
        return { point, scalar: this.attribute('scalar').getX(i) };
    }

    dispose(): void {
        this.mesh.geometry.dispose();
    }

    private attribute(name: string): BufferAttribute {
        return this.mesh.geometry.getAttribute(name) as BufferAttribute;
    }

    private reserve(vertices: number, indices: number): void {
        if (vertices <= this.vertexCapacity && indices <= this.indexCapacity) return;
        this.vertexCapacity = grown(this.vertexCapacity, vertices);
        this.indexCapacity = grown(this.indexCapacity, indices);
        // A buffer on the GPU cannot grow: a larger geometry takes the place of the old one.
        const old = this.mesh.geometry;
        old.dispose();
        const geometry = new BufferGeometry();
        for (const [name, itemSize] of attributes) {
            const attribute = new BufferAttribute(new Float32Array(this.vertexCapacity * itemSize), itemSize);
            geometry.setAttribute(name, dynamic(attribute, old.attributes[name]));
        }
        const index = new BufferAttribute(new Uint32Array(this.indexCapacity), 1);
        geometry.setIndex(dynamic(index, old.index));
        geometry.boundingSphere = new Sphere(undefined, Number.POSITIVE_INFINITY);
        this.mesh.geometry = geometry;
    }
}

function grown(capacity: number, needed: number): number {
    let size = Math.max(capacity, smallestCapacity);
    while (size < needed) size *= 2;
    return size;
}

/** Refilled often, and beginning like the attribute whose place it takes. */
function dynamic(attribute: BufferAttribute, old: { array: ArrayLike<number> } | null | undefined): BufferAttribute {
    attribute.setUsage(DynamicDrawUsage);
    if (old !== null && old !== undefined) attribute.array.set(old.array);
    return attribute;
}

/** Marks one range for the upload, around all that has changed since the last. */
function refill(attribute: BufferAttribute, values: Float32Array | Uint32Array, from: number): void {
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
