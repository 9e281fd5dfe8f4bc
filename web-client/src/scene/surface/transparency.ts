// What can be seen through, behind what is opaque: drawn aside before the picture, and laid over it by one triangle. While things move
// weights tell the order, whatever order surfaces and folds are drawn in (weighted blended, McGuire and Bavoil, JCGT 2013): half-float
// targets hold the weighted sum of colours with the product of what passes through, and the sum of weights. Where the order has to be
// exact, depth peeling (Everitt 2001) draws the surfaces once for each layer, of which every pixel keeps the nearest fragment behind the
// layer before; layers are laid one under the other, as colours of the screen, so that a layer before another lets through what it lets
// through of an opaque body, and what is behind the last one is blended by weights. Where nothing is transparent nothing of this is drawn
// or kept. Where even the weights take too long, surfaces are among the opaque things, as screen doors.
import {
    type Camera,
    Color,
    DepthTexture,
    FloatType,
    Group,
    HalfFloatType,
    type Mesh,
    NearestFilter,
    Scene,
    type ShaderMaterial,
    type Texture,
    UnsignedIntType,
    Vector2,
    Vector3,
    type WebGLRenderer,
    WebGLRenderTarget,
} from 'three';
import { drawDepth, type FullScreen, fullScreen, type Laid } from './renderPasses.ts';

/** The programs of something that can be seen through. */
export interface TransparentMaterials {
    /** Is drawn as if nothing could be seen through it. */
    opaque: ShaderMaterial;
    /** Little can. */
    isDense: boolean;
    blended: ShaderMaterial;
    peeled: ShaderMaterial;
}

export class Transparency {
    /** Belongs into the scene. */
    readonly object = new Group();
    /** Whether the next picture has everything in its exact order, which costs several times as much. */
    exact = false;
    private doors = false;
    private readonly scene = new Scene();
    private readonly materials = new Map<Mesh, TransparentMaterials>();
    private readonly blending = new WeightedBlending();
    private readonly blended: FullScreen;
    private readonly peeling: Peeling;
    private readonly depthRange: Vector2;
    private depth: WebGLRenderTarget | null = null;
    private centre = new Vector3();
    private radius = 1;

    /** @param depthRange set to what the weights need for each picture */
    constructor(depthRange: Vector2, peel: PeelUniforms) {
        this.depthRange = depthRange;
        this.blended = this.blending.composite('over', false);
        this.peeling = new Peeling(peel, this.blending);
        this.object.add(this.blended, this.peeling.composite);
        this.compose(null);
    }

    /** Returns whether there is anything that needs it. */
    get isNeeded(): boolean {
        return this.scene.children.some(({ visible }) => visible);
    }

    /** Weights tell near from far within the domain. */
    setBounds([x0, x1, y0, y1, z0, z1]: readonly [number, number, number, number, number, number]): void {
        this.centre = new Vector3(x0 + x1, y0 + y1, z0 + z1).multiplyScalar(0.5);
        this.radius = Math.hypot(x1 - x0, y1 - y0, z1 - z0) / 2;
    }

    show(mesh: Mesh, materials: TransparentMaterials): void {
        this.materials.set(mesh, materials);
        this.place(mesh, materials);
    }

    hide(mesh: Mesh): void {
        this.materials.delete(mesh);
        mesh.removeFromParent();
    }

    /** @param on as screen doors, in one pass */
    setDoors(on: boolean): void {
        if (on === this.doors) return;
        this.doors = on;
        for (const [mesh, materials] of this.materials) this.place(mesh, materials);
    }

    private place(mesh: Mesh, materials: TransparentMaterials): void {
        mesh.material = this.doors ? materials.opaque : materials.blended;
        (this.doors ? this.object : this.scene).add(mesh);
    }

    /** Before the picture is drawn. */
    prepare(renderer: WebGLRenderer, opaque: Scene, camera: Camera, into: WebGLRenderTarget | null): void {
        this.compose(null);
        if (!this.isNeeded) {
            this.release();
            return;
        }
        const size = into === null ? renderer.getDrawingBufferSize(new Vector2()) : new Vector2(into.width, into.height);
        const target = this.depthOf(size);
        const depth = target.depthTexture!;
        this.setDepthRange(camera);
        const before = { colour: renderer.getClearColor(new Color()), alpha: renderer.getClearAlpha(), auto: renderer.autoClear };
        renderer.setRenderTarget(target);
        drawDepth(renderer, opaque, camera);
        if (this.exact) this.peeling.draw(renderer, this.scene, camera, depth, size, (which) => this.use(which));
        else this.blending.draw(renderer, this.scene, camera, depth, size);
        renderer.autoClear = before.auto;
        renderer.setClearColor(before.colour, before.alpha);
        renderer.setRenderTarget(into);
        this.compose(this.exact ? this.peeling.composite : this.blended);
    }

    /** Into the depth of the target that is set, which stays otherwise: what lets little light through. */
    drawDense(renderer: WebGLRenderer, camera: Camera): void {
        const thin = this.scene.children.filter((mesh) => mesh.visible && this.materials.get(mesh as Mesh)?.isDense !== true);
        for (const mesh of thin) mesh.visible = false;
        this.use('opaque');
        drawDepth(renderer, this.scene, camera);
        this.use('blended');
        for (const mesh of thin) mesh.visible = true;
    }

    private compose(by: FullScreen | null): void {
        for (const composite of [this.blended, this.peeling.composite]) composite.visible = composite === by;
    }

    private use(which: 'blended' | 'peeled' | 'opaque'): void {
        for (const [mesh, materials] of this.materials) mesh.material = materials[which];
    }

    private setDepthRange(camera: Camera): void {
        const depth = -this.centre.clone().applyMatrix4(camera.matrixWorldInverse).z;
        const nearest = 'isPerspectiveCamera' in camera ? Math.max(0, depth - this.radius) : depth - this.radius;
        this.depthRange.set(nearest, depth + this.radius);
    }

    private depthOf(size: Vector2): WebGLRenderTarget {
        if (this.depth?.width === size.x && this.depth.height === size.y) return this.depth;
        this.release();
        const depthTexture = new DepthTexture(size.x, size.y, UnsignedIntType);
        const filter = { minFilter: NearestFilter, magFilter: NearestFilter };
        this.depth = new WebGLRenderTarget(size.x, size.y, { depthTexture, ...filter });
        return this.depth;
    }

    private release(): void {
        this.peeling.release();
        this.blending.release();
        this.depth?.depthTexture?.dispose();
        this.depth?.dispose();
        this.depth = null;
    }
}

/** The number of layers that are drawn in their order. */
const peeledLayers = 4;

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
        this.composite = fullScreen('over', { uniforms: { picture: this.result }, fragmentShader: layerShader });
        this.under.add(fullScreen('under', { uniforms: { picture: this.layer }, fragmentShader: layerShader }));
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

const layerShader = `
uniform sampler2D picture;
layout(location = 0) out vec4 drawn;

void main() {
    drawn = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
    if (drawn.a < 0.001) discard;
}`;

export class WeightedBlending {
    private target: WebGLRenderTarget | null = null;
    private readonly sum: { value: Texture | null } = { value: null };
    private readonly weights: { value: Texture | null } = { value: null };

    /** Lays the mean over or under a picture; encoded: as colours of the screen, where the target has them
     *  linear. */
    composite(laid: Laid, encoded: boolean): FullScreen {
        const uniforms = { sum: this.sum, weights: this.weights };
        return fullScreen(laid, { uniforms, fragmentShader: weightShader, defines: encoded ? { ENCODED: 1 } : {} });
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

const weightShader = `
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
