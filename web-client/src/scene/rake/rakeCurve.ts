// A curve in space as a ribbon of constant width on the screen, with a dark edge so that it shows on any
// colour. Each piece is an instance of one quad, widened in the vertex shader: thousands of pieces are one
// draw call, and none is touched when only the camera moves.
import {
    Color,
    Float32BufferAttribute,
    Group,
    InstancedBufferGeometry,
    InstancedInterleavedBuffer,
    InterleavedBufferAttribute,
    Mesh,
    ShaderMaterial,
    Vector2,
} from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { isOrthographic, type View } from '../base/view.ts';
import { distance } from './rakeShape.ts';

// Lifted towards the eye, so that the surface that starts here does not hide half of it. What is behind the
// eye has no place on the screen and is cut off just before. Half a width further at both ends fills the gaps
// at bends.
const vertexShader = /* glsl */ `
uniform vec2 size;
uniform float width;
uniform float lift;
uniform bool parallelRays;
attribute vec3 from;
attribute vec3 to;
varying float across;
varying float along;

vec4 lifted(vec3 point) {
    vec4 seen = modelViewMatrix * vec4(point, 1.0);
    seen.xyz += (parallelRays ? vec3(0.0, 0.0, 1.0) : -normalize(seen.xyz)) * lift;
    return seen;
}

void main() {
    vec4 a = lifted(from);
    vec4 b = lifted(to);
    float near = -0.001 * lift;
    if (!parallelRays) {
        if (a.z > near && b.z < near) a = mix(a, b, (near - a.z) / (b.z - a.z));
        if (b.z > near && a.z < near) b = mix(b, a, (near - b.z) / (a.z - b.z));
    }
    vec4 clipA = projectionMatrix * a;
    vec4 clipB = projectionMatrix * b;
    vec2 direction = (clipB.xy / clipB.w - clipA.xy / clipA.w) * size;
    float px = length(direction);
    direction = px > 0.0 ? direction / px : vec2(1.0, 0.0);
    float end = position.x;
    vec2 offset = vec2(-direction.y, direction.x) * position.y + direction * (end * 2.0 - 1.0) * 0.5;
    vec4 clip = end < 0.5 ? clipA : clipB;
    clip.xy += offset * width / size * clip.w;
    gl_Position = clip;
    across = position.y;
    along = end * px * 0.5;
}
`;

const fragmentShader = /* glsl */ `
uniform vec3 colour;
uniform float opacity;
uniform float width;
uniform float dash;
uniform float halo;
varying float across;
varying float along;

void main() {
    if (dash > 0.0 && fract(along / dash) > 0.55) discard;
    float edge = (1.0 - abs(across)) * width * 0.5;
    vec3 inner = mix(colour, vec3(1.0), 1.0 - smoothstep(halo, halo + 0.8, edge - 1.0));
    float inside = smoothstep(0.5, 1.5, edge);
    float covered = smoothstep(0.0, 0.8, edge);
    gl_FragColor = vec4(mix(vec3(0.02, 0.03, 0.05), halo > 0.0 ? inner : colour, inside), opacity * covered);
    #include <colorspace_fragment>
}
`;

export interface CurveStyle {
    colour: string;
    widthPx: number;
    opacity: number;
    /** Length of a dash with its gap in pixels; 0: unbroken. */
    dashPx: number;
    /** The width of the white line on both sides, inside the dark edge; 0: none. */
    haloPx: number;
}

/** The opacity of the part behind something: it shows through, faint and dashed. */
const hiddenOpacity = 0.5;
const hiddenDashPx = 7;

export class RakeCurve {
    readonly object = new Group();
    private readonly geometry = new InstancedBufferGeometry();
    private readonly shown = createMaterial(true);
    private readonly hidden = createMaterial(false);
    private buffer: InstancedInterleavedBuffer | null = null;
    private style: CurveStyle = { colour: '#ffffff', widthPx: 4, opacity: 1, dashPx: 0, haloPx: 0 };

    constructor() {
        const corners = [0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0];
        this.geometry.setAttribute('position', new Float32BufferAttribute(corners, 3));
        this.geometry.setIndex([0, 1, 2, 2, 1, 3]);
        for (const [material, order] of [
            [this.hidden, 9],
            [this.shown, 10],
        ] as const) {
            const mesh = new Mesh(this.geometry, material);
            mesh.frustumCulled = false;
            mesh.renderOrder = order;
            this.object.add(mesh);
        }
    }

    setPoints(points: readonly Vec3[]): void {
        const pieces = Math.max(0, points.length - 1);
        this.geometry.instanceCount = pieces;
        this.object.visible = pieces > 0;
        if (pieces === 0) return;
        const buffer = this.roomFor(pieces);
        const { array } = buffer;
        for (let i = 0; i < pieces; ++i) {
            array.set(points[i]!, 6 * i);
            array.set(points[i + 1]!, 6 * i + 3);
        }
        buffer.needsUpdate = true;
    }

    setStyle(style: CurveStyle): void {
        this.style = style;
        for (const material of [this.shown, this.hidden]) {
            (material.uniforms['colour']!.value as Color).set(style.colour);
            material.uniforms['dash']!.value = style.dashPx;
            material.uniforms['halo']!.value = style.haloPx;
            material.uniforms['width']!.value = style.widthPx;
        }
        if (style.dashPx === 0) this.hidden.uniforms['dash']!.value = hiddenDashPx;
        this.shown.uniforms['opacity']!.value = style.opacity;
        this.hidden.uniforms['opacity']!.value = style.opacity * hiddenOpacity;
    }

    get colour(): string {
        return this.style.colour;
    }

    /** Called before every frame. */
    update(view: View, middle: Vec3): void {
        const parallel = isOrthographic(view.camera);
        // Two pixels, but no more than a little of the way to the eye.
        const lift = Math.min(4 * view.worldPerPx(middle), parallel ? Infinity : 0.02 * distance(view.eye, middle));
        for (const { uniforms } of [this.shown, this.hidden]) {
            (uniforms['size']!.value as Vector2).set(view.drawnSize.width, view.drawnSize.height);
            uniforms['parallelRays']!.value = parallel;
            uniforms['lift']!.value = lift;
        }
    }

    dispose(): void {
        this.geometry.dispose();
        this.shown.dispose();
        this.hidden.dispose();
    }

    /** Buffers of the GPU cannot grow: a larger one takes the place of a small one. */
    private roomFor(pieces: number): InstancedInterleavedBuffer {
        if (this.buffer !== null && this.buffer.array.length >= 6 * pieces) return this.buffer;
        this.buffer = new InstancedInterleavedBuffer(new Float32Array(6 * Math.ceil(pieces * 1.5)), 6);
        this.geometry.dispose();
        this.geometry.setAttribute('from', new InterleavedBufferAttribute(this.buffer, 3, 0));
        this.geometry.setAttribute('to', new InterleavedBufferAttribute(this.buffer, 3, 3));
        return this.buffer;
    }
}

function createMaterial(depthTest: boolean): ShaderMaterial {
    return new ShaderMaterial({
        vertexShader,
        fragmentShader,
        transparent: true,
        depthTest,
        depthWrite: false,
        uniforms: {
            colour: { value: new Color() },
            opacity: { value: 1 },
            width: { value: 4 },
            dash: { value: 0 },
            halo: { value: 0 },
            size: { value: new Vector2(1, 1) },
            lift: { value: 0 },
            parallelRays: { value: false },
        },
    });
}
