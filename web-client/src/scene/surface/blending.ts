// Transparency that does not depend on the order in which surfaces, or their folds, are drawn: weighted blended (McGuire and
// Bavoil, JCGT 2013). Transparent surfaces go to two half-float targets, behind what is opaque: the weighted sum of colours with
// the product of what passes through, and the sum of weights. One triangle then lays the mean over the picture. Where no surface
// is transparent nothing of this is drawn or kept.
import {
    BufferAttribute,
    BufferGeometry,
    type Camera,
    Color,
    CustomBlending,
    DepthTexture,
    GLSL3,
    HalfFloatType,
    Mesh,
    NearestFilter,
    OneFactor,
    OneMinusSrcAlphaFactor,
    Scene,
    ShaderMaterial,
    UnsignedIntType,
    Vector2,
    Vector3,
    WebGLRenderTarget,
    type WebGLRenderer,
} from 'three';

interface Targets {
    depth: WebGLRenderTarget;
    sums: WebGLRenderTarget;
}

export class Blending {
    /** Belongs into the scene. */
    readonly composite: Mesh<BufferGeometry, ShaderMaterial>;
    private readonly scene = new Scene();
    private readonly depthRange: Vector2;
    private targets: Targets | null = null;
    private centre = new Vector3();
    private radius = 1;

    /** @param depthRange set to what the weights need for each picture */
    constructor(depthRange: Vector2) {
        this.depthRange = depthRange;
        this.composite = compositeMesh();
    }

    /** Weights tell near from far within the domain. */
    setBounds([x0, x1, y0, y1, z0, z1]: readonly [number, number, number, number, number, number]): void {
        this.centre = new Vector3(x0 + x1, y0 + y1, z0 + z1).multiplyScalar(0.5);
        this.radius = Math.hypot(x1 - x0, y1 - y0, z1 - z0) / 2;
    }

    show(mesh: Mesh): void {
        this.scene.add(mesh);
    }

    hide(mesh: Mesh): void {
        this.scene.remove(mesh);
    }

    /** Before the picture is drawn: fills the targets, if there is anything transparent. */
    prepare(renderer: WebGLRenderer, opaque: Scene, camera: Camera, into: WebGLRenderTarget | null): void {
        const needed = this.scene.children.some(({ visible }) => visible);
        this.composite.visible = false;
        if (!needed) {
            this.release();
            return;
        }
        const size = into === null ? renderer.getDrawingBufferSize(new Vector2()) : new Vector2(into.width, into.height);
        const { depth, sums } = this.targetsOf(size);
        this.setDepthRange(camera);
        const before = { color: renderer.getClearColor(new Color()), alpha: renderer.getClearAlpha(), auto: renderer.autoClear };
        renderer.setRenderTarget(depth);
        drawDepth(renderer, opaque, camera);
        renderer.setRenderTarget(sums);
        renderer.autoClear = false;
        renderer.setClearColor(0, 1);
        renderer.clear(true, false, false);
        renderer.render(this.scene, camera);
        renderer.autoClear = before.auto;
        renderer.setClearColor(before.color, before.alpha);
        renderer.setRenderTarget(into);
        this.composite.visible = true;
    }

    private setDepthRange(camera: Camera): void {
        const depth = -this.centre.clone().applyMatrix4(camera.matrixWorldInverse).z;
        const nearest = 'isPerspectiveCamera' in camera ? Math.max(0, depth - this.radius) : depth - this.radius;
        this.depthRange.set(nearest, depth + this.radius);
    }

    private targetsOf(size: Vector2): Targets {
        const { width, height } = this.targets?.depth ?? { width: 0, height: 0 };
        if (this.targets !== null && width === size.x && height === size.y) return this.targets;
        this.release();
        const depthTexture = new DepthTexture(size.x, size.y, UnsignedIntType);
        const filter = { minFilter: NearestFilter, magFilter: NearestFilter };
        const depth = new WebGLRenderTarget(size.x, size.y, { depthTexture, ...filter });
        const sums = new WebGLRenderTarget(size.x, size.y, { count: 2, type: HalfFloatType, depthTexture, ...filter });
        const { uniforms } = this.composite.material;
        uniforms['sum']!.value = sums.textures[0];
        uniforms['weights']!.value = sums.textures[1];
        this.targets = { depth, sums };
        return this.targets;
    }

    private release(): void {
        this.targets?.sums.dispose();
        this.targets?.depth.dispose();
        this.targets?.depth.depthTexture?.dispose();
        this.targets = null;
    }
}

/** What is opaque hides what is behind it; its colours are of no interest here. */
function drawDepth(renderer: WebGLRenderer, opaque: Scene, camera: Camera): void {
    const prepare = opaque.onBeforeRender;
    opaque.onBeforeRender = () => undefined;
    const { color } = renderer.state.buffers;
    color.setMask(false);
    color.setLocked(true);
    renderer.render(opaque, camera);
    color.setLocked(false);
    color.setMask(true);
    opaque.onBeforeRender = prepare;
}

function compositeMesh(): Mesh<BufferGeometry, ShaderMaterial> {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.of(-1, -1, 0, 3, -1, 0, -1, 3, 0), 3));
    const material = new ShaderMaterial({
        glslVersion: GLSL3,
        uniforms: { sum: { value: null }, weights: { value: null } },
        vertexShader: 'void main() { gl_Position = vec4(position, 1.0); }',
        fragmentShader: compositeShader,
        transparent: true,
        depthTest: false,
        depthWrite: false,
        blending: CustomBlending,
        blendSrc: OneFactor,
        blendDst: OneMinusSrcAlphaFactor,
        blendSrcAlpha: OneFactor,
        blendDstAlpha: OneMinusSrcAlphaFactor,
    });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.visible = false;
    // Below everything else that is drawn over the opaque things.
    mesh.renderOrder = -1000;
    return mesh;
}

const compositeShader = `
uniform sampler2D sum;
uniform sampler2D weights;
layout(location = 0) out vec4 drawn;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 colors = texelFetch(sum, at, 0);
    float alpha = 1.0 - colors.a;
    if (alpha < 0.001) discard;
    vec3 mean = colors.rgb / max(texelFetch(weights, at, 0).r, 1e-4);
    drawn = vec4(linearToOutputTexel(vec4(mean, 1.0)).rgb * alpha, alpha);
}`;
