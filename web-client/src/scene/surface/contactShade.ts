// Shade where things are near each other, so that one sees whether a sheet touches a body. Looks at depth
// alone: on a plane the depths of two pixels on opposite sides of a third have that of the third for their
// mean, with perspective as without. Where both together are nearer than that, less light gets in. Each
// picture looks at a few pairs of pixels, and the next one of the same mean (sampledPicture.ts) at others. Of four pixels beside each other
// each looks at pairs of its own, and has the mean of all four, so that the first picture has no dots.
import {
    type Camera,
    Color,
    CustomBlending,
    DepthTexture,
    NearestFilter,
    NoBlending,
    Scene,
    SrcColorFactor,
    type Texture,
    UnsignedIntType,
    Vector2,
    Vector4,
    type WebGLRenderer,
    WebGLRenderTarget,
    ZeroFactor,
} from 'three';
import { drawDepth, fullScreen } from './renderPasses.ts';

/** The layer of what is shaded, and shades: neither rakes nor words. */
export const shadedLayer = 1;
/** How far it reaches, in pixels of CSS: less than the margin of tiles, and the same in figures of all
 *  sizes. */
export const furthestPx = 20;
const nearestPx = 2;
/** For each picture of a mean: more in figures, which may take longer. */
export const pairs = { page: 4, figure: 8 };

/**
 * Which picture of how many, of a mean; how large the whole picture is; and where in it the part begins that
 * is drawn, in pixels from its upper left.
 */
export interface ShadePart {
    sample: number;
    samples: number;
    /** Looked at for each pixel. */
    pairs: number;
    pixelRatio: number;
    x: number;
    y: number;
    width: number;
    height: number;
}

/** From a pixel to one of each pair, in pixels of CSS: each at another angle, and nearer ones as often as
 *  those far away. */
export function pairOffsets({
    sample,
    samples,
    pairs: count,
}: Pick<ShadePart, 'sample' | 'samples' | 'pairs'>): [number, number][] {
    const all = count * samples;
    return Array.from({ length: count }, (_, i) => {
        const at = i * samples + sample;
        const angle = (Math.PI * ((at * 7) % all)) / all;
        const reach = nearestPx + (furthestPx - nearestPx) * ((at + 0.5) / all);
        return [reach * Math.cos(angle), reach * Math.sin(angle)];
    });
}

export class ContactShade {
    /** Belongs into the scene. */
    readonly object;
    /** Null: the next picture has none. */
    part: ShadePart | null = null;
    private readonly depth: { value: Texture | null } = { value: null };
    private readonly offsets = { value: Array.from({ length: pairs.figure }, () => new Vector2()) };
    private readonly pairs = { value: 0 };
    private readonly inside = { value: new Vector4() };
    private readonly perspective = { value: true };
    /** The camera's depths of the near and the far plane. */
    private readonly planes = { value: new Vector2() };
    private readonly pixelsPerUnit = { value: 1 };
    private readonly found: { value: Texture | null } = { value: null };
    private readonly finding = new Scene();
    private targets: { depth: WebGLRenderTarget; found: WebGLRenderTarget } | null = null;

    constructor() {
        const { depth, offsets, pairs: count, inside, perspective, planes, pixelsPerUnit, found } = this;
        const uniforms = { depth, offsets, pairs: count, inside, perspective, planes, pixelsPerUnit, found };
        const finding = fullScreen('over', { uniforms, fragmentShader: findShader });
        finding.material.blending = NoBlending;
        this.finding.add(finding);
        this.object = fullScreen('over', { uniforms, fragmentShader: laidShader });
        const material = this.object.material;
        material.blending = CustomBlending;
        [material.blendSrc, material.blendDst] = [ZeroFactor, SrcColorFactor];
        [material.blendSrcAlpha, material.blendDstAlpha] = [ZeroFactor, SrcColorFactor];
        // Over what can be seen through, and below words and handles.
        this.object.renderOrder = -999;
        this.object.visible = false;
    }

    /** Before the picture is drawn. @param drawDense adds to the depth what lets little light through */
    prepare(renderer: WebGLRenderer, opaque: Scene, camera: Camera, into: WebGLRenderTarget | null, drawDense: () => void): void {
        const { part } = this;
        this.object.visible = false;
        if (part === null || into !== null) return;
        const size = renderer.getDrawingBufferSize(new Vector2());
        const before = { colour: renderer.getClearColor(new Color()), alpha: renderer.getClearAlpha(), auto: renderer.autoClear };
        const targets = this.targetsOf(size);
        renderer.setRenderTarget(targets.depth);
        renderer.autoClear = true;
        drawDepth(renderer, opaque, camera, shadedLayer);
        renderer.autoClear = false;
        drawDense();
        this.sample(camera, size, part);
        renderer.setRenderTarget(targets.found);
        renderer.render(this.finding, camera);
        renderer.autoClear = before.auto;
        renderer.setClearColor(before.colour, before.alpha);
        renderer.setRenderTarget(null);
        this.object.visible = true;
    }

    release(): void {
        this.targets?.depth.depthTexture?.dispose();
        this.targets?.depth.dispose();
        this.targets?.found.dispose();
        this.targets = null;
    }

    private sample(camera: Camera, size: Vector2, { sample, samples, pairs: count, pixelRatio, ...part }: ShadePart): void {
        const { near, far } = camera as Camera & { near: number; far: number };
        this.perspective.value = 'isPerspectiveCamera' in camera;
        this.planes.value.set(near, far);
        // At distance 1 with perspective, anywhere without.
        this.pixelsPerUnit.value = (camera.projectionMatrix.elements[5] * size.y) / 2;
        this.pairs.value = count;
        pairOffsets({ sample, samples, pairs: count }).forEach(([x, y], i) =>
            this.offsets.value[i]!.set(x, y).multiplyScalar(pixelRatio),
        );
        const low = size.y + part.y - part.height;
        this.inside.value.set(-part.x, low, part.width - part.x, low + part.height);
    }

    private targetsOf({ x, y }: Vector2): { depth: WebGLRenderTarget; found: WebGLRenderTarget } {
        if (this.targets?.depth.width === x && this.targets.depth.height === y) return this.targets;
        this.release();
        const filter = { minFilter: NearestFilter, magFilter: NearestFilter };
        const depthTexture = new DepthTexture(x, y, UnsignedIntType);
        const depth = new WebGLRenderTarget(x, y, { depthTexture, ...filter });
        const found = new WebGLRenderTarget(x, y, { depthBuffer: false, ...filter });
        this.depth.value = depthTexture;
        this.found.value = found.texture;
        return (this.targets = { depth, found });
    }
}

const depths = `
uniform highp sampler2D depth;
uniform vec4 inside;
uniform bool perspective;
uniform vec2 planes;
uniform float pixelsPerUnit;
layout(location = 0) out vec4 left;

/** How much nearer to the eye a pixel's width is, as a difference of depths. */
float scaleAt(float here) {
    float range = planes.y - planes.x;
    float distance = planes.x * planes.y / (planes.y - here * range);
    return perspective ? distance * range / (planes.x * planes.y) * pixelsPerUnit : range * pixelsPerUnit;
}`;

const findShader = `${depths}
uniform vec2 offsets[${pairs.figure}];
uniform int pairs;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float here = texelFetch(depth, at, 0).r;
    left = vec4(1.0);
    if (here >= 1.0) return;
    float scale = scaleAt(here);
    // Of four pixels beside each other each looks at other pairs: steps of the shade fall between them.
    ivec2 own = (at - ivec2(inside.xy)) & 1;
    float turn = (float(own.x + 2 * own.y) - 1.5) * 0.5 / float(pairs);
    mat2 turned = (1.0 + 0.5 * turn) * mat2(cos(turn), sin(turn), -sin(turn), cos(turn));
    float shade = 0.0;
    for (int i = 0; i < pairs; ++i) {
        ivec2 away = ivec2(round(turned * offsets[i]));
        vec4 places = vec4(at + away, at - away);
        if (any(lessThan(places, inside.xyxy)) || any(greaterThanEqual(places, inside.zwzw))) continue;
        vec2 depths = vec2(texelFetch(depth, at + away, 0).r, texelFetch(depth, at - away, 0).r);
        // In widths of the pair: how far both come towards the eye.
        vec2 nearer = max((here - depths) * scale / max(1.0, length(vec2(away))), -1.5);
        float both = 0.5 * (nearer.x + nearer.y) - 0.03;
        // What is far before it does not touch it.
        shade += clamp(1.4 * both, 0.0, 1.0) * (1.0 - smoothstep(1.0, 2.2, max(nearer.x, nearer.y)));
    }
    left = vec4(vec3(1.0 - 0.75 * min(1.0, 1.5 * shade / float(pairs))), 1.0);
}`;

const laidShader = `${depths}
uniform sampler2D found;
// In widths of a pixel: what is that much nearer or further beside it is another thing.
const float steepest = 4.0;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float here = texelFetch(depth, at, 0).r;
    if (here >= 1.0) discard;
    float scale = scaleAt(here);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 beside = at + ivec2(i & 1, i >> 1);
        if (any(greaterThanEqual(vec2(beside), inside.zw))) continue;
        if (abs(texelFetch(depth, beside, 0).r - here) * scale > steepest) continue;
        sum += vec2(texelFetch(found, beside, 0).r, 1.0);
    }
    left = vec4(vec3(sum.x / sum.y), 1.0);
}`;
