// Transparency in its exact order: depth peeling (Everitt 2001). The transparent surfaces are drawn once for
// each layer, of which every pixel keeps the nearest fragment behind the layer before; the layers are laid
// one under the other, as colours of the screen, so that a layer before another lets through what it lets
// through of an opaque body. What is behind the last layer is blended by weights.
import {
    type Camera,
    DepthTexture,
    FloatType,
    HalfFloatType,
    NearestFilter,
    Scene,
    type Texture,
    type Vector2,
    WebGLRenderTarget,
    type WebGLRenderer,
} from 'three';
import { type FullScreen, fullScreen } from './fullScreen.ts';
import type { WeightedBlending } from './weightedBlending.ts';

/** Is the number of layers that are drawn in their order. */
export const peeledLayers = 4;

/** For the materials of what is peeled. */
export function peelUniforms() {
    return {
        /** The depth of the layer before; null: there is none. */
        nearer: { value: null as DepthTexture | null },
        peeling: { value: false },
        opaqueDepth: { value: null as DepthTexture | null },
    };
}
export type PeelUniforms = ReturnType<typeof peelUniforms>;

/** Which program draws the transparent surfaces. */
export type UseMaterials = (which: 'blended' | 'peeled') => void;

interface Targets {
    size: Vector2;
    /** In turn: while one is drawn, the other says where the layer before is. */
    layers: readonly [WebGLRenderTarget, WebGLRenderTarget];
    sum: WebGLRenderTarget;
}

export class Peeling {
    /** Belongs into the scene. */
    readonly composite: FullScreen;
    private readonly result: { value: Texture | null } = { value: null };
    private readonly layer: { value: Texture | null } = { value: null };
    private readonly under = new Scene();
    private readonly rest = new Scene();
    private readonly uniforms: PeelUniforms;
    private readonly blending: WeightedBlending;
    private targets: Targets | null = null;

    constructor(uniforms: PeelUniforms, blending: WeightedBlending) {
        this.uniforms = uniforms;
        this.blending = blending;
        this.composite = fullScreen('over', { uniforms: { picture: this.result }, fragmentShader });
        this.under.add(fullScreen('under', { uniforms: { picture: this.layer }, fragmentShader }));
        this.rest.add(blending.composite('under', true));
    }

    /** Leaves what `composite` lays over the picture. */
    draw(
        renderer: WebGLRenderer,
        transparent: Scene,
        camera: Camera,
        opaqueDepth: DepthTexture,
        size: Vector2,
        use: UseMaterials,
    ): void {
        const { nearer, peeling } = this.uniforms;
        const { layers, sum } = this.targetsOf(size);
        this.uniforms.opaqueDepth.value = opaqueDepth;
        renderer.setClearColor(0, 0);
        renderer.setRenderTarget(sum);
        renderer.clear(true, false, false);
        use('peeled');
        for (let i = 0; i < peeledLayers; ++i) {
            const [drawn, before] = i % 2 === 0 ? layers : ([layers[1], layers[0]] as const);
            peeling.value = i > 0;
            nearer.value = i > 0 ? before.depthTexture : null;
            renderer.autoClear = true;
            renderer.setRenderTarget(drawn);
            renderer.render(transparent, camera);
            this.layer.value = drawn.texture;
            this.layUnder(renderer, this.under, camera, sum);
        }
        peeling.value = true;
        nearer.value = layers[(peeledLayers - 1) % 2]!.depthTexture;
        use('blended');
        this.blending.draw(renderer, transparent, camera, opaqueDepth, size);
        this.layUnder(renderer, this.rest, camera, sum);
        peeling.value = false;
        nearer.value = null;
        this.uniforms.opaqueDepth.value = null;
    }

    release(): void {
        if (this.targets === null) return;
        for (const layer of this.targets.layers) {
            layer.depthTexture?.dispose();
            layer.dispose();
        }
        this.targets.sum.dispose();
        this.targets = null;
    }

    private layUnder(renderer: WebGLRenderer, picture: Scene, camera: Camera, sum: WebGLRenderTarget): void {
        renderer.autoClear = false;
        renderer.setRenderTarget(sum);
        renderer.render(picture, camera);
    }

    private targetsOf(size: Vector2): Targets {
        if (this.targets !== null && this.targets.size.equals(size)) return this.targets;
        this.release();
        const kind = { type: HalfFloatType, minFilter: NearestFilter, magFilter: NearestFilter } as const;
        const layer = (): WebGLRenderTarget => {
            // Floats: a fragment must find its own depth again to the last bit.
            const depthTexture = new DepthTexture(size.x, size.y, FloatType);
            return new WebGLRenderTarget(size.x, size.y, { ...kind, depthTexture });
        };
        const sum = new WebGLRenderTarget(size.x, size.y, { ...kind, depthBuffer: false });
        this.targets = { size: size.clone(), layers: [layer(), layer()], sum };
        this.result.value = sum.texture;
        return this.targets;
    }
}

const fragmentShader = `
uniform sampler2D picture;
layout(location = 0) out vec4 drawn;

void main() {
    drawn = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
    if (drawn.a < 0.001) discard;
}`;
