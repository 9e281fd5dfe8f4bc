// The solid body in the picture: a little further away in depth than it is, cut where surfaces are, with the flow along it as a texture,
// that of surfaces (flowTexture.ts), in the material that the scene lights. Its programs light vertices, not pixels: what that saves, the
// texture takes.
import {
    BufferAttribute,
    BufferGeometry,
    DoubleSide,
    Group,
    type Material,
    Mesh,
    MeshLambertMaterial,
    Plane,
    Vector3,
} from 'three';
import type { BodyMesh } from '../../mesh/meshChange.ts';
import type { Vec3 } from '../../protocol/messages.ts';
import { shadedLayer } from './contactShade.ts';
import { flowTextureGlsl, flowVertexGlsl } from './flowTexture.ts';
import { pushBack } from './renderPasses.ts';
import type { SurfaceLayer } from './surfaceLayer.ts';
import { type FlowTexture, makeNoise, type SharedUniforms, textureDefines } from './surfaceMaterial.ts';

type Planes = readonly (readonly [number, number, number, number])[];

export interface BodyVertex {
    point: Vec3;
    normal: Vec3;
    /** The velocity off it, where its texture is shown. */
    flow: Vec3 | null;
}

export class DrawnBody {
    readonly object = new Group();
    private readonly surfaces: Pick<SurfaceLayer, 'shared' | 'textures' | 'bodyPush'>;
    private readonly flowTime = { value: 0 };
    private mesh: ReturnType<typeof createObstacleMesh> | null = null;
    private planes: Planes = [];
    /** It may come before the body does. */
    private flow: Float32Array | null = null;
    private moving = false;
    /** The texture that its programs have. */
    private texture: FlowTexture = 'none';

    constructor(surfaces: Pick<SurfaceLayer, 'shared' | 'textures' | 'bodyPush'>) {
        this.surfaces = surfaces;
    }

    get geometry(): BufferGeometry | null {
        return this.mesh?.geometry ?? null;
    }

    /** Returns whether the flow along it is seen. */
    get textured(): boolean {
        return this.mesh?.geometry.hasAttribute('flow') === true;
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
        this.mesh = createObstacleMesh(body);
        this.mesh.layers.enable(shadedLayer);
        pushBack(this.mesh.material, this.surfaces.bodyPush);
        giveTexture(this.mesh.material, this.surfaces.shared, this.flowTime);
        clipMaterial(this.mesh.material, this.planes);
        this.object.add(this.mesh);
        this.applyFlow();
    }

    /** With the flow along it: what comes next may be another body of as many vertices. */
    remove(): void {
        this.clear();
        this.flow = null;
    }

    private clear(): void {
        this.texture = 'none';
        if (this.mesh === null) return;
        this.object.remove(this.mesh);
        this.mesh.geometry.dispose();
        this.mesh.material.dispose();
        this.mesh = null;
    }

    setClip(planes: Planes): void {
        this.planes = planes;
        if (this.mesh !== null) clipMaterial(this.mesh.material, planes);
    }

    /** xyz of the velocity off it, by vertices; null: its texture is not wanted. */
    setFlow(flow: Float32Array | null): void {
        this.flow = flow;
        this.applyFlow();
    }

    /** For how much simulation time the flow has gone; null: no clock moves it. */
    setTime(time: number | null): void {
        this.flowTime.value = time ?? 0;
        this.moving = time !== null;
        this.showTexture();
    }

    private applyFlow(): void {
        if (this.mesh === null) return;
        const { geometry } = this.mesh;
        const known = geometry.attributes['flow'] as BufferAttribute | undefined;
        // That of another body, whose own is on its way.
        const fits = this.flow?.length === geometry.attributes['position']!.array.length;
        if (this.flow !== null && fits) {
            if (known === undefined) geometry.setAttribute('flow', new BufferAttribute(this.flow, 3));
            else known.copyArray(this.flow).needsUpdate = true;
        } else geometry.deleteAttribute('flow');
        this.showTexture();
    }

    private showTexture(): void {
        const texture = !this.textured ? 'none' : this.moving ? 'flowing' : 'standing';
        if (this.mesh === null || texture === this.texture) return;
        this.texture = texture;
        makeNoise(texture, this.surfaces.shared, this.surfaces.textures);
        showTexture(this.mesh.material, texture);
    }
}

/** @param planes (n, w): nothing is left where n . point > w */
function clipMaterial(material: Material, planes: readonly (readonly [number, number, number, number])[]): void {
    const cutting = planes.filter(([x, y, z]) => x !== 0 || y !== 0 || z !== 0);
    material.clippingPlanes = cutting.map(([x, y, z, w]) => new Plane(new Vector3(-x, -y, -z), w));
    material.needsUpdate = true;
}

function createObstacleMesh({ positions, normals, indices }: BodyMesh): Mesh<BufferGeometry, MeshLambertMaterial> {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    return new Mesh(geometry, new MeshLambertMaterial({ color: 0xb4bcc9, side: DoubleSide }));
}

const vertexGlsl = `
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
#ifdef TEXTURED
    vec3 toViewer = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-mvPosition.xyz);
    float facing = dot(transformedNormal, toViewer);
    light = lightOn(facing < 0.0 ? -transformedNormal : transformedNormal);
    placeInFlow(position, normal, flow);
    // Seen edge-on, grains are finer than pixels.
    alongFlow.w *= min(1.0, 4.0 * abs(facing));
#endif`;

const fragmentGlsl = `
#ifdef TEXTURED
in vec3 light;
uniform float lineDensity;
${flowTextureGlsl}
#endif`;

/** In the place of the includes between which it begins and ends. */
const lit = ['#include <lights_lambert_fragment>', '#include <lights_fragment_end>'] as const;

/** @param time for how much simulation time the flow has gone  */
function giveTexture(material: MeshLambertMaterial, shared: SharedUniforms, time: { value: number }): void {
    const before = material.onBeforeCompile.bind(material);
    const { noiseScale, noiseFrom, noise, waves, flowed } = shared;
    const own = { lineDensity: { value: 1 }, byItself: { value: false }, flowTime: time };
    material.onBeforeCompile = (shader, renderer) => {
        before(shader, renderer);
        Object.assign(shader.uniforms, own, { noiseScale, noiseFrom, noise, waves, flowed });
        shader.vertexShader = shader.vertexShader
            .replace('void main() {', `${vertexGlsl}\nvoid main() {`)
            .replace('#include <project_vertex>', `#include <project_vertex>${vertexMain}`);
        shader.fragmentShader = shader.fragmentShader
            .replace('void main() {', `${fragmentGlsl}\nvoid main() {`)
            .replace(
                lit[0],
                `#ifdef TEXTURED\n    reflectedLight.directDiffuse = diffuse * light * flowTexture(1.0);\n#else\n${lit[0]}`,
            )
            .replace(lit[1], `${lit[1]}\n#endif`);
    };
}

/** Programs with it are made when it is first wanted. */
function showTexture(material: MeshLambertMaterial, texture: FlowTexture): void {
    material.defines = textureDefines[texture];
    material.needsUpdate = true;
}
