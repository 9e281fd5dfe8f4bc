// The solid body in the picture: a little further away in depth than it is, cut where surfaces are, coloured by a field, with lines of equal
// values, and with the flow along it as a texture, that of surfaces (flowTexture.ts), in the material that the scene lights. Programs with
// the texture light vertices, not pixels: what that saves, the texture takes. Bodies of other datasets are as it is, in grey.
import {
    BufferAttribute,
    BufferGeometry,
    type DataTexture,
    DoubleSide,
    Group,
    type Material,
    Mesh,
    MeshLambertMaterial,
    Plane,
    Vector2,
    Vector3,
} from 'three';
import type { BodyMesh, BodyValues } from '../../mesh/meshChange.ts';
import type { Vec3 } from '../../protocol/messages.ts';
import { shadedLayer } from './contactShade.ts';
import { flowTextureGlsl, flowVertexGlsl } from './flowTexture.ts';
import { pushBack, screenDoorGlsl } from './renderPasses.ts';
import type { SurfaceLayer } from './surfaceLayer.ts';
import type { ColourMapName } from './colourMap.ts';
import { makeNoise, type SharedUniforms, textureDefines } from './surfaceMaterial.ts';

/** Says of a program that it shows no values. */
const plain = 'none false';

type Uniforms = FieldUniforms & { opacityOfBody: { value: number } };
type FieldUniforms = { colours: { value: DataTexture }; fieldRange: { value: Vector2 }; contourStep: { value: number } };

/** From one cell to before another. */
export type CellSpan = readonly [number, number];

type Planes = readonly (readonly [number, number, number, number])[];

export interface BodyColours {
    map: ColourMapName;
    inverted: boolean;
    /** What both ends of the colours stand for. */
    range: readonly [number, number];
    /** From one line of equal values to the next; 0: there are none. */
    contourStep: number;
}

/** In the place of what is no number, which interpolation would spread. */
const noValue = -1e30;

export interface BodyVertex {
    point: Vec3;
    normal: Vec3;
    /** The velocity off it, where its texture is shown. */
    flow: Vec3 | null;
}

/** Of another dataset. */
export interface OtherBody {
    mesh: BodyMesh;
    hidden: readonly CellSpan[];
}

type ObstacleMesh = ReturnType<typeof createObstacleMesh>;

export class DrawnBody {
    readonly object = new Group();
    private readonly surfaces: Pick<SurfaceLayer, 'shared' | 'textures' | 'bodyPush'>;
    private readonly requestFrame: () => void;
    private readonly flowTime = { value: 0 };
    private readonly opacity = { value: 1 };
    private mesh: ObstacleMesh | null = null;
    private others: ObstacleMesh[] = [];
    private planes: Planes = [];
    /** They may come before the body does. */
    private flow: Float32Array | null = null;
    private field: Float32Array | null = null;
    private readonly fieldUniforms: FieldUniforms;
    private moving = false;
    private hidden: readonly CellSpan[] = [];
    private indices: Uint32Array | null = null;
    private program = plain;

    constructor(surfaces: Pick<SurfaceLayer, 'shared' | 'textures' | 'bodyPush'>, requestFrame: () => void) {
        this.surfaces = surfaces;
        this.requestFrame = requestFrame;
        this.fieldUniforms = {
            colours: { value: surfaces.textures.colours('viridis') },
            fieldRange: { value: new Vector2(0, 1) },
            contourStep: { value: 0 },
        };
    }

    get geometry(): BufferGeometry | null {
        return this.mesh?.geometry ?? null;
    }

    /** What a pointer can be at: nothing where it is hidden. */
    get seen(): BufferGeometry[] {
        return this.object.visible ? this.meshes.map(({ geometry }) => geometry) : [];
    }

    private get meshes(): ObstacleMesh[] {
        return [...(this.mesh === null ? [] : [this.mesh]), ...this.others];
    }

    /** All of it, and what of it is drawn; null: there is none. */
    get triangles(): { positions: Float32Array; indices: Uint32Array; shown: Uint32Array } | null {
        const { geometry, indices } = this;
        if (geometry === null || indices === null) return null;
        const shown = geometry.index!.array as Uint32Array;
        return { positions: geometry.attributes['position']!.array as Float32Array, indices, shown };
    }

    /** @param opacity 0: it is hidden */
    setOpacity(opacity: number): void {
        this.object.visible = opacity > 0;
        this.opacity.value = opacity;
        this.requestFrame();
    }

    /** Returns whether the flow along it is seen. */
    get textured(): boolean {
        return this.mesh?.geometry.hasAttribute('flow') === true;
    }

    /** Returns whether a field is seen on it. */
    get coloured(): boolean {
        return this.mesh?.geometry.hasAttribute('field') === true;
    }

    /** Every n-th of them. */
    vertices(every: number): BodyVertex[] {
        const { position, normal, flow } = this.geometry?.attributes ?? {};
        const found: BodyVertex[] = [];
        const at = (of: NonNullable<typeof position>, i: number): Vec3 => [of.getX(i), of.getY(i), of.getZ(i)];
        for (let i = 0; i < (position?.count ?? 0); i += every) {
            found.push({ point: at(position!, i), normal: at(normal!, i), flow: flow === undefined ? null : at(flow, i) });
        }
        return found;
    }

    set(body: BodyMesh): void {
        this.clear();
        this.mesh = this.add(body);
        this.indices = body.indices;
        this.showIndices();
        this.applyValues();
        this.requestFrame();
    }

    setOthers(bodies: readonly OtherBody[]): void {
        for (const each of this.others) this.discard(each);
        this.others = bodies.map(({ mesh, hidden }) => this.add({ ...mesh, indices: withoutCells(mesh.indices, hidden) }));
        this.requestFrame();
    }

    private add(body: BodyMesh): ObstacleMesh {
        const mesh = createObstacleMesh(body);
        mesh.layers.enable(shadedLayer);
        pushBack(mesh.material, this.surfaces.bodyPush);
        giveValues(mesh.material, this.surfaces.shared, this.flowTime, { ...this.fieldUniforms, opacityOfBody: this.opacity });
        clipMaterial(mesh.material, this.planes);
        this.object.add(mesh);
        return mesh;
    }

    private discard(mesh: ObstacleMesh): void {
        this.object.remove(mesh);
        mesh.geometry.dispose();
        mesh.material.dispose();
    }

    /** Cells that are not drawn, in the order of what was fetched. */
    setHidden(hidden: readonly CellSpan[]): void {
        this.hidden = hidden;
        this.showIndices();
        this.requestFrame();
    }

    private showIndices(): void {
        if (this.mesh === null || this.indices === null) return;
        const shown = this.hidden.length === 0 ? this.indices : withoutCells(this.indices, this.hidden);
        if (this.mesh.geometry.index?.array !== shown) this.mesh.geometry.setIndex(new BufferAttribute(shown, 1));
    }

    /** With its values: what comes next may be another body of as many vertices. */
    remove(): void {
        this.clear();
        this.flow = this.field = null;
        this.requestFrame();
    }

    private clear(): void {
        this.program = plain;
        if (this.mesh !== null) this.discard(this.mesh);
        this.mesh = null;
    }

    setClip(planes: Planes): void {
        this.planes = planes;
        for (const { material } of this.meshes) clipMaterial(material, planes);
    }

    /** Null: it is plain. @param textured the flow along it is shown */
    setValues(values: BodyValues | null, textured: boolean): void {
        this.flow = textured ? (values?.flow ?? null) : null;
        this.field = values?.field?.map((value) => (Number.isNaN(value) ? noValue : value)) ?? null;
        this.applyValues();
        this.requestFrame();
    }

    setColours({ map, inverted, range: [low, high], contourStep }: BodyColours): void {
        this.fieldUniforms.colours.value = this.surfaces.textures.colours(map);
        this.fieldUniforms.fieldRange.value.set(inverted ? high : low, inverted ? low : high);
        this.fieldUniforms.contourStep.value = contourStep;
        this.requestFrame();
    }

    /** For how much simulation time the flow has gone; null: no clock moves it. */
    setTime(time: number | null): void {
        this.flowTime.value = time ?? 0;
        this.moving = time !== null;
        this.showValues();
        if (this.textured) this.requestFrame();
    }

    private applyValues(): void {
        if (this.mesh === null) return;
        this.apply('flow', this.flow, 3);
        this.apply('field', this.field, 1);
        this.showValues();
    }

    private apply(name: string, values: Float32Array | null, size: number): void {
        const { geometry } = this.mesh!;
        const known = geometry.attributes[name] as BufferAttribute | undefined;
        // Those of another body, whose own are on their way, do not fit.
        if (values?.length !== size * geometry.attributes['position']!.count) geometry.deleteAttribute(name);
        else if (known === undefined) geometry.setAttribute(name, new BufferAttribute(values, size));
        else known.copyArray(values).needsUpdate = true;
    }

    private showValues(): void {
        if (this.mesh === null) return;
        const texture = !this.textured ? 'none' : this.moving ? 'flowing' : 'standing';
        const program = `${texture} ${this.coloured}`;
        if (program === this.program) return;
        this.program = program;
        makeNoise(texture, this.surfaces.shared, this.surfaces.textures);
        // Programs are made when they are first wanted.
        const { material } = this.mesh;
        material.defines = { ...textureDefines[texture], ...(this.coloured ? { COLOURED: 1 } : {}) };
        material.needsUpdate = true;
    }
}

/** @param planes (n, w): nothing is left where n . point > w */
function clipMaterial(material: Material, planes: readonly (readonly [number, number, number, number])[]): void {
    const cutting = planes.filter(([x, y, z]) => x !== 0 || y !== 0 || z !== 0);
    material.clippingPlanes = cutting.map(([x, y, z, w]) => new Plane(new Vector3(-x, -y, -z), w));
    material.needsUpdate = true;
}

/** Of a cell come two triangles, of which one has no area. */
const indicesOfCell = 6;

export function withoutCells(indices: Uint32Array, hidden: readonly CellSpan[]): Uint32Array {
    const shown = new Uint32Array(indices.length);
    let count = 0;
    let at = 0;
    for (const [from, to] of [...hidden, [Infinity, Infinity] as const]) {
        const kept = indices.subarray(at, Math.min(indicesOfCell * from, indices.length));
        shown.set(kept, count);
        count += kept.length;
        at = Math.min(indicesOfCell * to, indices.length);
    }
    return shown.slice(0, count);
}

function createObstacleMesh({ positions, normals, indices }: BodyMesh): Mesh<BufferGeometry, MeshLambertMaterial> {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    return new Mesh(geometry, new MeshLambertMaterial({ color: 0xb4bcc9, side: DoubleSide }));
}

const vertexGlsl = `
#ifdef COLOURED
attribute float field;
out float fieldValue;
#endif
#ifdef TEXTURED
#include <lights_pars_begin>
attribute vec3 flow;
out vec3 light;
${flowVertexGlsl}

/** Returns the light as MeshLambertMaterial has it. */
vec3 lightOn(vec3 n) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < NUM_DIR_LIGHTS; ++i) {
        sum += max(dot(n, directionalLights[i].direction), 0.0) * directionalLights[i].color;
    }
    for (int i = 0; i < NUM_HEMI_LIGHTS; ++i) sum += getHemisphereLightIrradiance(hemisphereLights[i], n);
    return RECIPROCAL_PI * sum;
}
#endif`;

const vertexMain = `
#ifdef COLOURED
    fieldValue = field;
#endif
#ifdef TEXTURED
    vec3 toViewer = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-mvPosition.xyz);
    float facing = dot(transformedNormal, toViewer);
    light = lightOn(facing < 0.0 ? -transformedNormal : transformedNormal);
    placeInFlow(position, normal, flow);
    // Seen edge-on, grains are finer than pixels.
    alongFlow.w *= min(1.0, 4.0 * abs(facing));
#endif`;

const fragmentGlsl = `
uniform float opacityOfBody;
${screenDoorGlsl}
#ifdef COLOURED
in float fieldValue;
uniform sampler2D colours;
uniform vec2 fieldRange;
uniform float contourStep;

/** Grey without a value. */
vec3 fieldColour(vec3 grey) {
    float at = fieldValue / max(contourStep, 1e-30);
    float apart = abs(fract(at - 0.5) - 0.5) / max(fwidth(at), 1e-9);
    if (fieldValue < -1e29) return grey;
    vec3 colour = texture(colours, vec2((fieldValue - fieldRange.x) / (fieldRange.y - fieldRange.x), 0.5)).rgb;
    return contourStep > 0.0 ? colour * mix(0.2, 1.0, smoothstep(0.5, 1.3, apart)) : colour;
}
#endif
#ifdef TEXTURED
in vec3 light;
uniform float lineDensity;
${flowTextureGlsl}
#endif`;

/** Behind it the colour is what the material has. */
const painted = '#include <color_fragment>';
/** In the place of the includes between which it begins and ends. */
const lit = ['#include <lights_lambert_fragment>', '#include <lights_fragment_end>'] as const;

/** @param time for how much simulation time the flow has gone  */
function giveValues(material: MeshLambertMaterial, shared: SharedUniforms, time: { value: number }, field: Uniforms): void {
    const before = material.onBeforeCompile.bind(material);
    const { noiseScale, noiseFrom, noise, waves, flowed } = shared;
    const own = { lineDensity: { value: 1 }, byItself: { value: false }, flowTime: time, ...field };
    material.onBeforeCompile = (shader, renderer) => {
        before(shader, renderer);
        Object.assign(shader.uniforms, own, { noiseScale, noiseFrom, noise, waves, flowed });
        shader.vertexShader = shader.vertexShader
            .replace('void main() {', `${vertexGlsl}\nvoid main() {`)
            .replace('#include <project_vertex>', `#include <project_vertex>${vertexMain}`);
        shader.fragmentShader = shader.fragmentShader
            .replace('void main() {', `${fragmentGlsl}\nvoid main() {`)
            .replace(
                painted,
                `    if (!isThere(opacityOfBody, ivec2(0))) discard;\n${painted}\n#ifdef COLOURED\n    diffuseColor.rgb = fieldColour(diffuseColor.rgb);\n#endif`,
            )
            .replace(
                lit[0],
                `#ifdef TEXTURED\n    reflectedLight.directDiffuse = diffuseColor.rgb * light * flowTexture(1.0);\n#else\n${lit[0]}`,
            )
            .replace(lit[1], `${lit[1]}\n#endif`);
    };
}
