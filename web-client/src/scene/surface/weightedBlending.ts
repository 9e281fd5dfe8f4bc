// Transparency that does not depend on the order in which surfaces, or their folds, are drawn: weighted
// blended (McGuire and Bavoil, JCGT 2013). Transparent surfaces go to two half-float targets: the weighted
// sum of colours with the product of what passes through, and the sum of weights. Where one is before the
// other the weights only guess; peeling.ts knows.
import {
    type Camera,
    type DepthTexture,
    HalfFloatType,
    NearestFilter,
    type Scene,
    type Texture,
    type Vector2,
    WebGLRenderTarget,
    type WebGLRenderer,
} from 'three';
import { type FullScreen, fullScreen, type Laid } from './fullScreen.ts';

export class WeightedBlending {
    private target: WebGLRenderTarget | null = null;
    private readonly sum: { value: Texture | null } = { value: null };
    private readonly weights: { value: Texture | null } = { value: null };

    /** Lays the mean over or under a picture; encoded: as colours of the screen, where the target has them
     *  linear. */
    composite(laid: Laid, encoded: boolean): FullScreen {
        const uniforms = { sum: this.sum, weights: this.weights };
        return fullScreen(laid, { uniforms, fragmentShader, defines: encoded ? { ENCODED: 1 } : {} });
    }

    /** Fills the targets with what is before the depth. REQUIRES: materials that are `blended`. */
    draw(renderer: WebGLRenderer, transparent: Scene, camera: Camera, depth: DepthTexture, size: Vector2): void {
        const target = this.targetOf(depth, size);
        renderer.setRenderTarget(target);
        renderer.autoClear = false;
        renderer.setClearColor(0, 1);
        renderer.clear(true, false, false);
        renderer.render(transparent, camera);
    }

    release(): void {
        this.target?.dispose();
        this.target = null;
    }

    private targetOf(depthTexture: DepthTexture, { x, y }: Vector2): WebGLRenderTarget {
        if (this.target?.depthTexture === depthTexture) return this.target;
        this.release();
        const filter = { minFilter: NearestFilter, magFilter: NearestFilter };
        this.target = new WebGLRenderTarget(x, y, { count: 2, type: HalfFloatType, depthTexture, ...filter });
        this.sum.value = this.target.textures[0] ?? null;
        this.weights.value = this.target.textures[1] ?? null;
        return this.target;
    }
}

const fragmentShader = `
uniform sampler2D sum;
uniform sampler2D weights;
layout(location = 0) out vec4 drawn;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 colours = texelFetch(sum, at, 0);
    float alpha = 1.0 - colours.a;
    if (alpha < 0.001) discard;
    vec4 mean = vec4(colours.rgb / max(texelFetch(weights, at, 0).r, 1e-4), 1.0);
#ifdef ENCODED
    drawn = vec4(sRGBTransferOETF(mean).rgb * alpha, alpha);
#else
    drawn = vec4(linearToOutputTexel(mean).rgb * alpha, alpha);
#endif
}`;
