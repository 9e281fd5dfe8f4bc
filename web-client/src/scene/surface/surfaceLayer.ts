// All surfaces of the session in the scene.
import { Group, type Vector2 } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { createSurfaceMaterial } from './surfaceMaterial.ts';
import { type MeshChange, SurfaceMesh } from './surfaceMesh.ts';

export class SurfaceLayer {
    readonly object = new Group();
    private readonly material = createSurfaceMaterial();
    private readonly surfaces = new Map<string, SurfaceMesh>();

    setRange(range: readonly [number, number]): void {
        (this.material.uniforms['range']?.value as Vector2).set(...range);
    }

    /** Takes what is new in a surface. */
    set(id: string, change: MeshChange): void {
        let surface = this.surfaces.get(id);
        if (surface === undefined) {
            surface = new SurfaceMesh(this.material);
            this.surfaces.set(id, surface);
            this.object.add(surface.mesh);
        }
        surface.update(change);
    }

    remove(id: string): void {
        const surface = this.surfaces.get(id);
        if (surface === undefined) return;
        this.surfaces.delete(id);
        this.object.remove(surface.mesh);
        surface.dispose();
    }

    /** A vertex of a surface and its scalar, as they are drawn. */
    vertexOf(id: string, vertex: number): { point: Vec3; scalar: number } | null {
        return this.surfaces.get(id)?.vertex(vertex) ?? null;
    }
}
