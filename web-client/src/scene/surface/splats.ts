// A surface as points: at each vertex an elliptical disc in the plane of the surface, as large as the
// neighbours are away, so that discs leave no holes (after Schafhitzel, Tejada, Weiskopf, Ertl, Point-based
// stream surfaces and path surfaces, 2007), cut at the surface's border. They are made of what the surface's buffers hold, and drawn by
// the surface's own shader.
import {
    BufferAttribute,
    type BufferGeometry,
    InstancedBufferAttribute,
    InstancedBufferGeometry,
    Mesh,
    type ShaderMaterial,
    Sphere,
} from 'three';
import { cutLevel } from '../../mesh/meshChange.ts';
import { type SplatAxes, splatEnds, type SplatSurface } from './splatEnds.ts';

/** In the frame in which the farthest neighbours are 1 away along both axes, sides of triangles are 2 sqrt 2
 *  long at most, and usually sqrt 2. */
const reach = 0.85;

export class Splats {
    readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;

    constructor(material: ShaderMaterial) {
        this.mesh = new Mesh<BufferGeometry, ShaderMaterial>(new InstancedBufferGeometry(), material);
        this.mesh.frustumCulled = false;
    }

    /** Takes a surface's buffers as they are now. */
    update(of: BufferGeometry, vertices: number): void {
        const geometry = new InstancedBufferGeometry();
        for (const [name, { array, itemSize }] of Object.entries(of.attributes as Record<string, BufferAttribute>)) {
            geometry.setAttribute(name, new InstancedBufferAttribute(array, itemSize));
        }
        const surface: SplatSurface = {
            ...{ positions: arrayOf(of, 'position'), normals: arrayOf(of, 'normal'), vertices },
            indices: drawn((of.index!.array as Uint32Array).subarray(0, of.drawRange.count), of),
        };
        const axes = splatAxes(surface);
        const ends = splatEnds(surface, axes, 'cut' in of.attributes ? arrayOf(of, 'cut') : null);
        geometry.setAttribute('axisU', new InstancedBufferAttribute(axes.u, 3));
        geometry.setAttribute('axisV', new InstancedBufferAttribute(axes.v, 3));
        geometry.setAttribute('endsThrough', new InstancedBufferAttribute(ends.through, 4));
        geometry.setAttribute('endBeside', new InstancedBufferAttribute(ends.beside, 4));
        geometry.setAttribute('corner', new BufferAttribute(Float32Array.of(-1, -1, 1, -1, 1, 1, -1, 1), 2));
        geometry.setIndex([0, 1, 2, 0, 2, 3]);
        geometry.instanceCount = vertices;
        geometry.boundingSphere = new Sphere(undefined, Number.POSITIVE_INFINITY);
        this.mesh.geometry.dispose();
        this.mesh.geometry = geometry;
        this.mesh.visible = vertices > 0;
    }

    dispose(): void {
        this.mesh.geometry.dispose();
    }
}

function arrayOf(geometry: BufferGeometry, name: string): Float32Array {
    return geometry.getAttribute(name).array as Float32Array;
}

/** Triangles without those that are cut as a whole. */
function drawn(indices: Uint32Array, { attributes }: BufferGeometry): Uint32Array {
    const levels = (attributes as Record<string, BufferAttribute>)['cut']?.array;
    if (levels === undefined) return indices;
    return indices.filter((_, i) => [0, 1, 2].some((k) => levels[indices[i - (i % 3) + k]!]! <= cutLevel));
}

/** Half axes of the discs: along the side of a triangle that is longest there, and across it. */
function splatAxes({ positions, normals, indices, vertices }: SplatSurface): SplatAxes {
    const [u, v] = [new Float32Array(3 * vertices), new Float32Array(3 * vertices)];
    const longest = new Float32Array(vertices);
    const across = new Float32Array(vertices);
    const sides = (use: (from: number, x: number, y: number, z: number) => void): void => {
        for (let i = 0; i < indices.length; ++i) {
            const at = 3 * indices[i]!;
            for (const other of [i - (i % 3) + ((i + 1) % 3), i - (i % 3) + ((i + 2) % 3)]) {
                const to = 3 * indices[other]!;
                const [x, y, z] = [
                    positions[to]! - positions[at]!,
                    positions[to + 1]! - positions[at + 1]!,
                    positions[to + 2]! - positions[at + 2]!,
                ];
                use(at / 3, x, y, z);
            }
        }
    };
    sides((k, x, y, z) => {
        const length = Math.hypot(x, y, z);
        if (length > longest[k]!) {
            longest[k] = length;
            u.set([x / length, y / length, z / length], 3 * k);
        }
    });
    for (let k = 0; k < 3 * vertices; k += 3) {
        const [nx, ny, nz] = [normals[k]!, normals[k + 1]!, normals[k + 2]!];
        v.set([ny * u[k + 2]! - nz * u[k + 1]!, nz * u[k]! - nx * u[k + 2]!, nx * u[k + 1]! - ny * u[k]!], k);
    }
    sides((k, x, y, z) => {
        across[k] = Math.max(across[k]!, Math.abs(x * v[3 * k]! + y * v[3 * k + 1]! + z * v[3 * k + 2]!));
    });
    for (let i = 0; i < 3 * vertices; ++i) {
        const k = Math.floor(i / 3);
        u[i]! *= reach * longest[k]!;
        v[i]! *= reach * across[k]!;
    }
    return { u, v };
}
