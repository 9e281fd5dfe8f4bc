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

/** What the worker made of one complete state. */
export interface MeshArrays {
    positions: Float32Array;
    normals: Float32Array;
    scalars: Float32Array;
    indices: Uint32Array;
}

const smallestCapacity = 1 << 14;

export class SurfaceMesh {
    readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
    private vertexCapacity = 0;
    private indexCapacity = 0;

    constructor(material: ShaderMaterial) {
        this.mesh = new Mesh(new BufferGeometry(), material);
        // Bounds would have to be recomputed at every state; the domain is in view nearly always.
        this.mesh.frustumCulled = false;
    }

    update(arrays: MeshArrays): void {
        const vertices = arrays.positions.length / 3;
        this.reserve(vertices, arrays.indices.length);
        const { geometry } = this.mesh;
        refill(geometry.getAttribute('position') as BufferAttribute, arrays.positions);
        refill(geometry.getAttribute('normal') as BufferAttribute, arrays.normals);
        refill(geometry.getAttribute('scalar') as BufferAttribute, arrays.scalars);
        if (geometry.index !== null) refill(geometry.index, arrays.indices);
        geometry.setDrawRange(0, arrays.indices.length);
        this.mesh.visible = arrays.indices.length > 0;
    }

    dispose(): void {
        this.mesh.geometry.dispose();
    }

    private reserve(vertices: number, indices: number): void {
        if (vertices <= this.vertexCapacity && indices <= this.indexCapacity) return;
        this.vertexCapacity = grown(this.vertexCapacity, vertices);
        this.indexCapacity = grown(this.indexCapacity, indices);
        // A buffer on the GPU cannot grow: a larger geometry takes the place of the old one.
        this.mesh.geometry.dispose();
        const geometry = new BufferGeometry();
        geometry.setAttribute('position', floats(this.vertexCapacity, 3));
        geometry.setAttribute('normal', floats(this.vertexCapacity, 3));
        geometry.setAttribute('scalar', floats(this.vertexCapacity, 1));
        const index = new BufferAttribute(new Uint32Array(this.indexCapacity), 1);
        index.setUsage(DynamicDrawUsage);
        geometry.setIndex(index);
        geometry.boundingSphere = new Sphere(undefined, Number.POSITIVE_INFINITY);
        this.mesh.geometry = geometry;
    }
}

function grown(capacity: number, needed: number): number {
    let size = Math.max(capacity, smallestCapacity);
    while (size < needed) size *= 2;
    return size;
}

function floats(count: number, itemSize: number): BufferAttribute {
    const attribute = new BufferAttribute(new Float32Array(count * itemSize), itemSize);
    attribute.setUsage(DynamicDrawUsage);
    return attribute;
}

function refill(attribute: BufferAttribute, values: Float32Array | Uint32Array): void {
    attribute.array.set(values);
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(0, values.length);
    attribute.needsUpdate = true;
}
