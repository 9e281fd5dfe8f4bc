// One triangle over all pixels of a target, for passes that work on pictures instead of on surfaces.
import {
    BufferAttribute,
    BufferGeometry,
    CustomBlending,
    GLSL3,
    Mesh,
    OneFactor,
    OneMinusDstAlphaFactor,
    OneMinusSrcAlphaFactor,
    ShaderMaterial,
    type ShaderMaterialParameters,
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
