// All surfaces of the session in the scene: their meshes, materials and looks.
import { Group } from 'three';
import { SurfaceMesh, type MeshChange, type SurfaceVertex } from './surfaceMesh.ts';
import { noPlanes, sharedUniforms, SurfaceMaterials } from './surfaceMaterial.ts';
import { plainStyle, type SurfaceStyle } from './surfaceStyle.ts';
import { SurfaceTextures } from './surfaceTextures.ts';

export interface DrawnSurface {
    id: string;
    mesh: SurfaceMesh;
    materials: SurfaceMaterials;
    style: SurfaceStyle;
}

export class SurfaceLayer {
    readonly object = new Group();
    readonly textures = new SurfaceTextures();
    readonly shared = sharedUniforms(this.textures);
    /** Planes (xyz, w) that cut the body: nothing is left where xyz . point > w. */
    readonly bodyClip = { value: noPlanes() };
    private readonly surfaces = new Map<string, DrawnSurface>();
    private readonly styles = new Map<string, SurfaceStyle>();
    private usual = plainStyle;

    /** Of the speed, where a surface has no look of its own. */
    setRange(range: readonly [number, number]): void {
        this.usual = { ...this.usual, range };
        for (const surface of this.surfaces.values()) this.restyle(surface);
    }

    /** From now on, and of a surface that is still to come. */
    setStyle(id: string, style: SurfaceStyle): void {
        this.styles.set(id, style);
        const surface = this.surfaces.get(id);
        if (surface !== undefined) this.restyle(surface);
    }

    /** Takes what is new in a surface. */
    set(id: string, change: MeshChange): void {
        let surface = this.surfaces.get(id);
        if (surface === undefined) {
            const materials = new SurfaceMaterials(this.textures, this.shared);
            surface = { id, mesh: new SurfaceMesh(materials.opaque), materials, style: plainStyle };
            this.surfaces.set(id, surface);
            this.object.add(surface.mesh.mesh);
            this.wish(surface);
        }
        surface.mesh.update(change);
        this.restyle(surface);
    }

    remove(id: string): void {
        const surface = this.surfaces.get(id);
        this.styles.delete(id);
        if (surface === undefined) return;
        this.surfaces.delete(id);
        this.object.remove(surface.mesh.mesh);
        surface.mesh.dispose();
        surface.materials.dispose();
    }

    get all(): DrawnSurface[] {
        return [...this.surfaces.values()];
    }

    /** A vertex of a surface and its scalar, as they are drawn. */
    vertexOf(id: string, vertex: number): SurfaceVertex | null {
        return this.surfaces.get(id)?.mesh.vertex(vertex) ?? null;
    }

    /** What both ends of the colours stand for, as drawn. */
    rangeOf(id: string): [number, number] | null {
        return this.surfaces.get(id)?.materials.range ?? null;
    }

    private wish({ id, mesh }: DrawnSurface): void {
        const style = this.styles.get(id) ?? this.usual;
        if (style.source === 'scalar') mesh.wantedScalar = style.scalar;
    }

    private restyle(surface: DrawnSurface): void {
        this.wish(surface);
        const wanted = this.styles.get(surface.id) ?? this.usual;
        const { mesh, materials } = surface;
        // The colours change over when what they show is here.
        const here = wanted.source !== 'scalar' || mesh.shownScalar === wanted.scalar;
        surface.style = here ? wanted : { ...wanted, ...coloursOf(surface.style) };
        materials.apply(surface.style, mesh);
    }
}

function coloursOf({ source, scalar, map, range, centre, inverted, logarithmic }: SurfaceStyle): Partial<SurfaceStyle> {
    return { source, scalar, map, range, centre, inverted, logarithmic };
}
