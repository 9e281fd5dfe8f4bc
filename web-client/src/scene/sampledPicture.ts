// Antialiasing whatever the graphics are: a picture is drawn several times, each time moved by another part
// of a pixel, and the mean of all is shown. What is thinner than a pixel, and every edge, has its share of
// the pixel then, also of what can be seen through and of lines. Means are of light, not of the numbers that
// stand for it on a screen.
import {
    type Camera,
    Color,
    FramebufferTexture,
    HalfFloatType,
    NearestFilter,
    Scene,
    type Texture,
    Vector2,
    type WebGLRenderer,
    WebGLRenderTarget,
} from 'three';
import { fullScreen } from './surface/renderPasses.ts';

/** Where in a pixel it is looked at, from its middle, in pixels: no two in one row or one column, and the
 *  mean is the middle. */
export function samplePlaces(samples: 4 | 8): readonly (readonly [number, number])[] {
    return samples === 4 ? four : eight;
}

const four = [
    [-0.125, -0.375],
    [0.125, 0.375],
    [0.375, -0.125],
    [-0.375, 0.125],
] as const;
const eight = [
    [0.0625, -0.1875],
    [-0.0625, 0.1875],
    [0.3125, 0.0625],
    [-0.3125, -0.0625],
    [-0.1875, -0.3125],
    [0.1875, 0.3125],
    [-0.4375, 0.4375],
    [0.4375, -0.4375],
] as const;

interface Buffers {
    /** One picture, as it is on the screen. */
    drawn: FramebufferTexture;
    /** The sum of all; their number is in alpha. */
    sum: WebGLRenderTarget;
}

export class SampledPicture {
    /** Pictures that the mean is of. */
    count = 0;
    private readonly renderer: WebGLRenderer;
    private readonly picture: { value: Texture | null } = { value: null };
    private readonly sum: { value: Texture | null } = { value: null };
    private readonly encoded = { value: false };
    private readonly adding = new Scene();
    private readonly showing = new Scene();
    private buffers: Buffers | null = null;

    constructor(renderer: WebGLRenderer) {
        this.renderer = renderer;
        const { picture, sum, encoded } = this;
        this.adding.add(fullScreen('added', { uniforms: { picture, encoded }, fragmentShader: addShader }));
        this.showing.add(fullScreen('over', { uniforms: { sum, encoded }, fragmentShader: showShader }));
    }

    /**
     * Begins another picture. @param encoded its means are of the numbers on the screen: as programs mix a
     * picture without ground and what they lay it on
     */
    begin(encoded = false): void {
        this.count = 0;
        this.encoded.value = encoded;
    }

    /** Adds what is in the drawing buffer. */
    add(camera: Camera): void {
        const { renderer } = this;
        const { drawn, sum } = this.buffersOf(renderer.getDrawingBufferSize(new Vector2()));
        renderer.copyFramebufferToTexture(drawn);
        this.drawInto(sum, this.adding, camera, this.count === 0);
        ++this.count;
    }

    /** Draws the mean. REQUIRES: count > 0 */
    show(camera: Camera): void {
        this.drawInto(null, this.showing, camera, false);
    }

    release(): void {
        this.count = 0;
        this.buffers?.drawn.dispose();
        this.buffers?.sum.dispose();
        this.buffers = null;
    }

    private drawInto(target: WebGLRenderTarget | null, scene: Scene, camera: Camera, clear: boolean): void {
        const { renderer } = this;
        const { autoClear } = renderer;
        renderer.autoClear = false;
        renderer.setRenderTarget(target);
        if (clear) {
            const before = { colour: renderer.getClearColor(new Color()), alpha: renderer.getClearAlpha() };
            renderer.setClearColor(0, 0);
            renderer.clear(true, false, false);
            renderer.setClearColor(before.colour, before.alpha);
        }
        renderer.render(scene, camera);
        renderer.setRenderTarget(null);
        renderer.autoClear = autoClear;
    }

    private buffersOf({ x, y }: Vector2): Buffers {
        if (this.buffers?.sum.width === x && this.buffers.sum.height === y) return this.buffers;
        const { count } = this;
        this.release();
        this.count = count;
        const drawn = new FramebufferTexture(x, y);
        const filter = { minFilter: NearestFilter, magFilter: NearestFilter };
        const sum = new WebGLRenderTarget(x, y, { type: HalfFloatType, depthBuffer: false, ...filter });
        this.picture.value = drawn;
        this.sum.value = sum.texture;
        return (this.buffers = { drawn, sum });
    }
}

const addShader = `
uniform sampler2D picture;
uniform bool encoded;
layout(location = 0) out vec4 light;

void main() {
    vec4 drawn = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
    light = vec4(encoded ? drawn.rgb : sRGBTransferEOTF(drawn).rgb, 1.0);
}`;

const showShader = `
uniform sampler2D sum;
uniform bool encoded;
layout(location = 0) out vec4 drawn;

void main() {
    vec4 light = texelFetch(sum, ivec2(gl_FragCoord.xy), 0);
    vec4 mean = vec4(light.rgb / max(light.a, 1.0), 1.0);
    drawn = encoded ? mean : sRGBTransferOETF(mean);
}`;
