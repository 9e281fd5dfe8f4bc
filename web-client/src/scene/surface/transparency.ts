// Draws what can be seen through, behind what is opaque: aside before the picture, and laid over it by one
// triangle. Weights tell the order while things move (weightedBlending.ts), layers where it has to be exact
// (peeling.ts). Where nothing is transparent nothing of this is drawn or kept.
import {
    type Camera,
    Color,
    DepthTexture,
    Group,
    type Mesh,
    NearestFilter,
    Scene,
    type ShaderMaterial,
    UnsignedIntType,
    Vector2,
    Vector3,
    WebGLRenderTarget,
    type WebGLRenderer,
} from 'three';
import { drawDepth } from './depthOnly.ts';
import type { FullScreen } from './fullScreen.ts';
import { Peeling, type PeelUniforms } from './peeling.ts';
import { WeightedBlending } from './weightedBlending.ts';

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
    /** Says whether the next picture has everything in its exact order, which costs several times as much. */
    exact = false;
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
        mesh.material = materials.blended;
        this.scene.add(mesh);
    }

    hide(mesh: Mesh): void {
        this.materials.delete(mesh);
        this.scene.remove(mesh);
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
