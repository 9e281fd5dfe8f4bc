// All surfaces of the session in the scene: their meshes, materials, looks and what the painter has left of
// them.
import { Group, type Scene, Vector2, type Vector4, WebGLRenderTarget } from 'three';
import type { TimedMeshChange } from '../../mesh/meshChange.ts';
import type { Bounds } from '../domain/domainAxes.ts';
import { bodyPush } from './renderPasses.ts';
import { ContactShade, shadedLayer } from './contactShade.ts';
import { grainsPerLength } from './flowTexture.ts';
import { type BrushPrint, decodeMask, SurfaceMask } from './surfaceMask.ts';
import { Splats } from './splats.ts';
import { SurfaceMesh, type SurfaceVertex } from './surfaceMesh.ts';
import { noPlanes, sharedUniforms, SurfaceMaterials, SurfaceTextures } from './surfaceMaterial.ts';
import { isPlain, isTransparent, plainStyle, type SurfaceStyle } from './surfaceStyle.ts';
import { type WeighedValues, weighedValues } from './weighedValues.ts';
import type { SceneCamera } from '../base/view.ts';
import { Transparency } from './transparency.ts';

/** How many times its length a mask that was brought may be away. */
const farthestMask = 4096;

type Range = [number, number];
type Planes = readonly (readonly [number, number, number, number])[];

export interface DrawnSurface {
    id: string;
    mesh: SurfaceMesh;
    materials: SurfaceMaterials;
    style: SurfaceStyle;
    mask: SurfaceMask | null;
    splats: Splats | null;
}

/** What a surface spans, as it is drawn. */
export interface SurfaceSpan {
    /** What both ends of the colours stand for. */
    colours: Range;
    t: Range;
    s: Range;
    /** The age of what is shown now, the same as t but for streak surfaces. */
    age: Range;
    /** How it is drawn now; a wish may still wait for what it shows. */
    style: SurfaceStyle;
    /** What it should be coloured by, and has no values of, so that it has one colour; empty: nothing. */
    lacks: string;
}

export class SurfaceLayer {
    readonly object = new Group();
    readonly textures = new SurfaceTextures();
    readonly shared = sharedUniforms();
    /** Planes (n, w) that cut the body: nothing is left where n . point > w. */
    readonly bodyClip = { value: noPlanes() };
    /** How much further from the eye the body is drawn, in depth alone. */
    readonly bodyPush = { value: 0 };
    readonly transparency = new Transparency(this.shared.depthRange.value, this.shared);
    readonly shade = new ContactShade();
    private readonly surfaces = new Map<string, DrawnSurface>();
    private readonly styles = new Map<string, SurfaceStyle>();
    /** Masks, or their codes, for surfaces that are not painted, or not there, at the moment. */
    private readonly wishedMasks = new Map<string, string | SurfaceMask>();
    /** How often the painter has changed something. */
    strokes = 0;
    private clipped = false;

    constructor() {
        this.object.add(this.transparency.object, this.shade.object);
    }

    /** Whatever renders the scene gets transparency with it. */
    attach(scene: Scene): void {
        scene.add(this.object);
        // Of a scene, the fourth is the target, other than the types say (WebGLRenderer.render).
        scene.onBeforeRender = (renderer, _scene, camera, target: unknown) => {
            const into = target instanceof WebGLRenderTarget ? target : null;
            const height = into?.height ?? renderer.getDrawingBufferSize(new Vector2()).y;
            this.shared.noiseScale.value = grainsPerLength(
                camera.projectionMatrix.elements,
                height,
                this.shared.pixelRatio.value,
            );
            this.shade.prepare(renderer, scene, camera, into, () => this.transparency.drawDense(renderer, camera));
            this.transparency.prepare(renderer, scene, camera, into);
        };
    }

    setBounds(bounds: readonly [number, number, number, number, number, number]): void {
        const [x0, x1, y0, y1, z0, z1] = bounds;
        this.bodyPush.value = bodyPush * Math.hypot(x1 - x0, y1 - y0, z1 - z0);
        this.shared.noiseFrom.value.set(x0, y0, z0);
        this.transparency.setBounds(bounds);
    }

    /** Whether what can be seen through is drawn in the quickest way, as screen doors. */
    setDoors(on: boolean): void {
        this.shared.doors.value = on;
        this.transparency.setDoors(on);
    }

    setClip(planes: Planes, body: boolean): void {
        setPlanes(this.shared.clip.value, planes);
        setPlanes(this.bodyClip.value, body ? planes : []);
        this.clipped = planes.some(([x, y, z]) => x !== 0 || y !== 0 || z !== 0);
        for (const surface of this.surfaces.values()) this.restyle(surface);
    }

    /** The flow texture where fields stand still, by so much simulation time. */
    moveTexture(by: number): void {
        this.shared.flowed.value += by;
    }

    /** From now on, and of a surface that is still to come. */
    setStyle(id: string, style: SurfaceStyle): void {
        this.styles.set(id, style);
        const surface = this.surfaces.get(id);
        if (surface !== undefined) this.restyle(surface);
    }

    /** Takes what is new in a surface. */
    set(id: string, change: TimedMeshChange): void {
        let surface = this.surfaces.get(id);
        if (surface === undefined) {
            const materials = new SurfaceMaterials(this.textures, this.shared);
            surface = { id, mesh: new SurfaceMesh(materials.opaque), materials, style: plainStyle, mask: null, splats: null };
            this.surfaces.set(id, surface);
            surface.mesh.mesh.layers.enable(shadedLayer);
            this.object.add(surface.mesh.mesh);
            this.wish(surface);
        }
        surface.mesh.update(change);
        surface.splats?.update(surface.mesh.mesh.geometry, surface.mesh.vertices);
        this.restyle(surface);
    }

    remove(id: string): void {
        const surface = this.surfaces.get(id);
        this.styles.delete(id);
        if (surface === undefined) return;
        this.surfaces.delete(id);
        this.object.remove(surface.mesh.mesh);
        this.transparency.hide(surface.mesh.mesh);
        this.showPoints(surface, false);
        surface.mesh.dispose();
        surface.materials.dispose();
        surface.mask?.dispose();
        // Its deletion may be taken back.
        if (surface.mask !== null) this.wishedMasks.set(id, surface.mask);
    }

    /** For surfaces that are others now, whatever their names. */
    forgetMasks(): void {
        this.wishedMasks.clear();
        for (const surface of this.surfaces.values()) this.dropMask(surface);
    }

    get all(): DrawnSurface[] {
        return [...this.surfaces.values()];
    }

    /** A vertex of a surface and its scalar, as they are drawn. */
    vertexOf(id: string, vertex: number): SurfaceVertex | null {
        return this.surfaces.get(id)?.mesh.vertex(vertex) ?? null;
    }

    boxOf(id: string): Bounds | null {
        return this.surfaces.get(id)?.mesh.box ?? null;
    }

    spanOf(id: string): SurfaceSpan | null {
        const surface = this.surfaces.get(id);
        if (surface === undefined) return null;
        const { mesh, materials } = surface;
        const { style } = surface;
        const wanted = this.styleOf(id);
        const lacks = style.source === 'constant' && wanted.source === 'scalar' ? wanted.scalar : '';
        return { colours: materials.range, t: mesh.tRange, s: [0, 1], age: materials.ages, style, lacks };
    }

    /** What a surface is coloured by; null: one colour. @param camera  leaves out what is beside its picture */
    valuesOf(id: string, camera: SceneCamera | null): WeighedValues | null {
        const surface = this.surfaces.get(id);
        if (surface === undefined || surface.style.source === 'constant') return null;
        return weighedValues(surface.mesh, surface.style, camera);
    }

    /** Reveals or hides what the brush touches of the surfaces that are painted. */
    paint(print: BrushPrint, reveal: boolean): void {
        ++this.strokes;
        for (const surface of this.surfaces.values()) {
            if (surface.style.painting) this.maskOf(surface)?.stamp(surface.id, print, reveal);
        }
    }

    /** All of a surface. */
    revealAll(id: string, reveal: boolean): void {
        ++this.strokes;
        const surface = this.surfaces.get(id);
        if (surface !== undefined) this.maskOf(surface)?.fill(reveal);
    }

    /** Returns what the painter has left of a surface, as a text; null: it is too intricate for one.
     *  Undefined: nothing is painted. */
    maskCode(id: string): string | null | undefined {
        const mask = this.surfaces.get(id)?.mask ?? this.wishedMasks.get(id);
        return mask instanceof SurfaceMask ? mask.code : mask;
    }

    /** Shows what the code says, from now on or when the surface is painted; one that cannot be read says
     *  that nothing is revealed. */
    setMask(id: string, code: string): void {
        ++this.strokes;
        this.wishedMasks.set(id, code);
        const surface = this.surfaces.get(id);
        if (surface === undefined) return;
        this.dropMask(surface);
        this.restyle(surface);
    }

    private dropMask(surface: DrawnSurface): void {
        surface.materials.setMask(null, 0, 1);
        surface.mask?.dispose();
        surface.mask = null;
    }

    /** Null for a surface that is empty so far: a mask could not tell where its t is. */
    private maskOf(surface: DrawnSurface): SurfaceMask | null {
        if (surface.mesh.vertices === 0) return null;
        surface.mask ??= this.newMask(surface);
        this.showMask(surface);
        return surface.mask;
    }

    private newMask({ id, mesh }: DrawnSurface): SurfaceMask {
        const mask = this.wishedMasks.get(id) ?? '';
        const wished = typeof mask === 'string' ? decodeMask(mask) : mask;
        this.wishedMasks.delete(id);
        const [low, high] = mesh.tRange;
        // One of other times altogether has nothing to do with this surface, and would be doubled for long to
        // reach it.
        const near = wished !== null && Math.max(high - low, Math.abs(low - wished.tStart)) <= farthestMask * wished.tLength;
        return new SurfaceMask(mesh.tRange, near ? wished : null);
    }

    private showMask({ mask, mesh, materials }: DrawnSurface): void {
        if (mask === null) return;
        mask.cover(mesh.tRange);
        materials.setMask(mask.texture, mask.tStart - mesh.tFrom, 1 / mask.tLength);
    }

    /** What is wished; it may not be drawn so yet. */
    private styleOf(id: string): SurfaceStyle {
        return this.styles.get(id) ?? plainStyle;
    }

    private wish({ id, mesh }: DrawnSurface): void {
        const { source, scalar } = this.styleOf(id);
        if (source === 'scalar') mesh.wantedScalar = scalar;
    }

    private showPoints(surface: DrawnSurface, on: boolean): void {
        if (on === (surface.splats !== null)) return;
        const { mesh, materials } = surface;
        if (surface.splats !== null) {
            this.object.remove(surface.splats.mesh);
            surface.splats.dispose();
            surface.splats = null;
            return;
        }
        this.object.remove(mesh.mesh);
        this.transparency.hide(mesh.mesh);
        surface.splats = new Splats(materials.splats);
        surface.splats.update(mesh.mesh.geometry, mesh.vertices);
        this.object.add(surface.splats.mesh);
    }

    private restyle(surface: DrawnSurface): void {
        this.wish(surface);
        const wanted = this.styleOf(surface.id);
        const { mesh, materials } = surface;
        const isHere = ({ source, scalar }: SurfaceStyle): boolean => source !== 'scalar' || mesh.scalar === scalar;
        // The colours change over when what they show is here.
        const colours = [wanted, surface.style].find(isHere);
        surface.style =
            colours === undefined ? { ...wanted, source: 'constant', scalar: '' } : { ...wanted, ...coloursOf(colours) };
        if (surface.style.painting) this.maskOf(surface);
        materials.apply(surface.style, mesh);
        this.showPoints(surface, surface.style.points);
        if (surface.style.points) return;
        const transparent = isTransparent(surface.style);
        const plain = isPlain(surface.style) && !this.clipped;
        if (transparent) {
            this.transparency.show(mesh.mesh, materials);
        } else {
            this.transparency.hide(mesh.mesh);
            mesh.mesh.material = plain ? materials.plain : materials.opaque;
            this.object.add(mesh.mesh);
        }
    }
}

function coloursOf(style: SurfaceStyle): Partial<SurfaceStyle> {
    const { source, scalar, map, range, rangeOf, beyond, centre, inverted, logarithmic, root, bands } = style;
    return { source, scalar, map, range, rangeOf, beyond, centre, inverted, logarithmic, root, bands };
}

function setPlanes(vectors: Vector4[], planes: Planes): void {
    vectors.forEach((vector, i) => vector.set(...(planes[i] ?? ([0, 0, 0, 1] as const))));
}
