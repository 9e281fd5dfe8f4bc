// What passes share: one triangle over all pixels of a target, materials that draw depth alone, and the depth of a body, a little further
// from the eye than it is, so that what lies on it stays in sight.
import {
    BufferAttribute,
    BufferGeometry,
    type Camera,
    CustomBlending,
    GLSL3,
    Mesh,
    type MeshLambertMaterial,
    OneFactor,
    OneMinusDstAlphaFactor,
    OneMinusSrcAlphaFactor,
    type Scene,
    ShaderMaterial,
    type ShaderMaterialParameters,
    type WebGLRenderer,
} from 'three';

export type FullScreen = Mesh<BufferGeometry, ShaderMaterial>;

/**
 * `over`: laid over what is there; `under`: shines through what lets light pass of that; `added` to it.
 * Colours come multiplied by alpha.
 */
export type Laid = 'over' | 'under' | 'added';

export function fullScreen(
    laid: Laid,
    shader: Pick<ShaderMaterialParameters, 'uniforms' | 'fragmentShader' | 'defines'>,
): FullScreen {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.of(-1, -1, 0, 3, -1, 0, -1, 3, 0), 3));
    const blendSrc = laid === 'under' ? OneMinusDstAlphaFactor : OneFactor;
    const blendDst = laid === 'over' ? OneMinusSrcAlphaFactor : OneFactor;
    const material = new ShaderMaterial({
        ...shader,
        glslVersion: GLSL3,
        vertexShader: 'void main() { gl_Position = vec4(position, 1.0); }',
        transparent: true,
        depthTest: false,
        depthWrite: false,
        blending: CustomBlending,
        ...{ blendSrc, blendDst, blendSrcAlpha: blendSrc, blendDstAlpha: blendDst },
    });
    const mesh: FullScreen = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    // Below everything else that is drawn over the opaque things.
    mesh.renderOrder = -1000;
    return mesh;
}

/** Into the target that is set. @param layer of what; without it, of everything */
export function drawDepth(renderer: WebGLRenderer, scene: Scene, camera: Camera, layer = 0): void {
    const prepare = scene.onBeforeRender;
    scene.onBeforeRender = () => undefined;
    const { color } = renderer.state.buffers;
    color.setMask(false);
    color.setLocked(true);
    camera.layers.set(layer);
    renderer.render(scene, camera);
    camera.layers.set(0);
    color.setLocked(false);
    color.setMask(true);
    scene.onBeforeRender = prepare;
}

/** For what is opaque to the other passes, and lets through what is behind it between its pixels: in any order, and without noise that
 *  moves. Ordered 4 x 4, by Bayer; what is shifted is seen through the gaps of what is not. */
export const screenDoorGlsl = `
bool isThere(float opacity, ivec2 shift) {
    ivec2 at = (ivec2(gl_FragCoord.xy) + shift) & 3;
    int low = at.x ^ at.y;
    int order = ((low & 1) << 3) | ((at.y & 1) << 2) | (low & 2) | (at.y >> 1);
    return (float(order) + 0.5) / 16.0 < opacity;
}`;

/** A part of the domain's diagonal: as deep as the flat quads of a surface reach into what is round. */
export const bodyPush = 1 / 500;

/** Belongs to a vertex shader, to be called when gl_Position is set. */
export const pushBackGlsl = `
uniform float push;

void pushBack(vec4 inView) {
    vec3 away = isOrthographic ? vec3(0.0, 0.0, -1.0) : normalize(inView.xyz);
    vec4 further = projectionMatrix * vec4(inView.xyz + away * push, 1.0);
    gl_Position.z = further.z / further.w * gl_Position.w;
}`;

/** @param push in units of length */
export function pushBack(material: MeshLambertMaterial, push: { value: number }): void {
    material.onBeforeCompile = (shader) => {
        shader.uniforms['push'] = push;
        shader.vertexShader = shader.vertexShader
            .replace('void main() {', `${pushBackGlsl}\nvoid main() {`)
            .replace('#include <project_vertex>', '#include <project_vertex>\n\tpushBack(mvPosition);');
    };
}
