// The flow texture of bodies: that of surfaces (flowTextureShader.ts), in the material that the scene lights.
// Its programs light vertices, not pixels: what that saves, the texture takes.
import type { MeshLambertMaterial } from 'three';
import { flowTextureGlsl, flowVertexGlsl } from './flowTextureShader.ts';
import { type FlowTexture, type SharedUniforms, textureDefines } from './surfaceMaterial.ts';

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
export function giveTexture(material: MeshLambertMaterial, shared: SharedUniforms, time: { value: number }): void {
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
export function showTexture(material: MeshLambertMaterial, texture: FlowTexture): void {
    material.defines = textureDefines[texture];
    material.needsUpdate = true;
}
