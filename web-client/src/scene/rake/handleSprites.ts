// The handles of a rake as points of constant size on the screen, which show through what is before them,
// paler: a handle that cannot be seen cannot be dragged, and one behind a body must not look as if it were in
// front. The shader draws what each is for.
import {
    BufferGeometry,
    Color,
    DynamicDrawUsage,
    Float32BufferAttribute,
    GreaterDepth,
    Group,
    LessEqualDepth,
    Points,
    ShaderMaterial,
} from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { isOrthographic, type View } from '../base/view.ts';
import type { Handle } from './rakeHandles.ts';
import { distance } from './rakeShape.ts';

/** What a handle looks like. */
const marks = { point: 0, middle: 1, rotate: 2, tilt: 3, dot: 4 } as const;
export type Mark = keyof typeof marks;

export interface HandleSprite {
    at: Vec3;
    mark: Mark;
    radiusPx: number;
    /** Under the pointer, or with the focus. */
    highlighted: boolean;
    /** Another than the rake's. */
    colour?: string;
}

/** The opacity of what is behind something. */
const hiddenOpacity = 0.42;
/** Nearer to the eye by so much, so that what a handle stands on does not hide half of it. */
const liftPx = 14;

const vertexShader = /* glsl */ `
uniform float pixelRatio;
uniform float lift;
uniform bool parallelRays;
attribute vec3 tint;
varying vec3 colour;
attribute float mark;
attribute float radius;
attribute float highlighted;
varying float kind;
varying float px;
varying float lit;

void main() {
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    seen.xyz += (parallelRays ? vec3(0.0, 0.0, 1.0) : -normalize(seen.xyz)) * lift;
    gl_Position = projectionMatrix * seen;
    colour = tint;
    kind = mark;
    lit = highlighted;
    px = radius * (1.0 + 0.22 * highlighted);
    gl_PointSize = 2.0 * (px + 2.0) * pixelRatio;
}
`;

// Discs, rings and strokes by their distance in pixels: sharp at any size. What moves the whole is dark with
// a sign (a cross, most of a circle with an arrow's head, a ring seen aslant), what moves a point has the
// rake's colour.
const fragmentShader = /* glsl */ `
uniform float opacity;
varying vec3 colour;
varying float kind;
varying float px;
varying float lit;

float within(float inside) {
    return clamp(inside + 0.5, 0.0, 1.0);
}

float bar(vec2 at, vec2 halves) {
    vec2 beyond = abs(at) - halves;
    return within(-max(beyond.x, beyond.y));
}

void main() {
    vec2 at = (gl_PointCoord - 0.5) * 2.0 * (px + 2.0);
    float r = length(at);
    vec3 dark = vec3(0.02, 0.03, 0.05);
    vec3 light = mix(vec3(1.0), vec3(1.0, 0.93, 0.55), lit);
    float ring = kind > 3.5 ? 0.0 : max(1.5, px * 0.17) + lit;
    vec3 shade = mix(light, dark, within(r - px));
    bool plain = kind < 0.5 || kind > 3.5;
    vec3 core = plain ? colour : mix(dark, colour, 0.25);
    shade = mix(shade, core, within(px - ring - r));
    float arm = px * 0.42;
    if (kind > 0.5 && kind < 1.5) {
        float mark = max(bar(at, vec2(arm, 1.1)), bar(at, vec2(1.1, arm)));
        shade = mix(shade, vec3(1.0), mark);
    } else if (kind > 1.5 && kind < 2.5) {
        float arc = within(1.1 - abs(r - arm)) * (at.x > 0.0 && at.y < 0.0 ? 0.0 : 1.0);
        vec2 tip = at - vec2(0.0, -arm);
        float head = within(min(2.6 - abs(tip.y) - tip.x * 0.9, tip.x + 0.6));
        shade = mix(shade, vec3(1.0), max(arc, head));
    } else if (kind > 2.5 && kind < 3.5) {
        float flat_ring = abs(length(at * vec2(1.0, 2.2)) - arm * 1.1);
        shade = mix(shade, vec3(1.0), max(within(1.3 - flat_ring * 0.7), bar(at, vec2(1.0, arm * 1.2))));
    }
    float covered = within(px + 1.5 - r);
    if (covered <= 0.0) discard;
    gl_FragColor = vec4(shade, covered * opacity);
    #include <colorspace_fragment>
}
`;

export class HandleSprites {
    readonly object = new Group();
    private readonly geometry = new BufferGeometry();
    private readonly materials = [createMaterial(false), createMaterial(true)];
    private readonly tint = new Color();
    private capacity = 0;

    constructor(renderOrder: number) {
        for (const material of this.materials) {
            const points = new Points(this.geometry, material);
            points.frustumCulled = false;
            points.renderOrder = renderOrder;
            points.onBeforeRender = (renderer) => {
                material.uniforms['pixelRatio']!.value = renderer.getPixelRatio();
            };
            this.object.add(points);
        }
    }

    set(sprites: readonly HandleSprite[], colour: string): void {
        const { geometry, tint } = this;
        this.reserve(sprites.length);
        geometry.setDrawRange(0, sprites.length);
        this.object.visible = sprites.length > 0;
        if (sprites.length === 0) return;
        const [position, tints, mark, radius, highlighted] = names.map((name) => geometry.getAttribute(name));
        sprites.forEach((sprite, i) => {
            position!.setXYZ(i, ...sprite.at);
            tint.set(sprite.colour ?? colour);
            tints!.setXYZ(i, tint.r, tint.g, tint.b);
            mark!.setX(i, marks[sprite.mark]);
            radius!.setX(i, sprite.radiusPx);
            highlighted!.setX(i, sprite.highlighted ? 1 : 0);
        });
        for (const attribute of [position, tints, mark, radius, highlighted]) attribute!.needsUpdate = true;
    }

    /** Called before every frame. @param middle  a place among them */
    update(view: View, middle: Vec3): void {
        const parallel = isOrthographic(view.camera);
        const lift = Math.min(liftPx * view.worldPerPx(middle), parallel ? Infinity : 0.02 * distance(view.eye, middle));
        for (const { uniforms } of this.materials) {
            uniforms['lift']!.value = lift;
            uniforms['parallelRays']!.value = parallel;
        }
    }

    dispose(): void {
        this.geometry.dispose();
        for (const material of this.materials) material.dispose();
    }

    private reserve(count: number): void {
        if (count <= this.capacity) return;
        this.capacity = Math.ceil(count * 1.5);
        this.geometry.dispose();
        names.forEach((name, i) => {
            const size = i < 2 ? 3 : 1;
            const attribute = new Float32BufferAttribute(new Float32Array(this.capacity * size), size);
            attribute.setUsage(DynamicDrawUsage);
            this.geometry.setAttribute(name, attribute);
        });
    }
}

const names = ['position', 'tint', 'mark', 'radius', 'highlighted'] as const;

function createMaterial(inFront: boolean): ShaderMaterial {
    return new ShaderMaterial({
        vertexShader,
        fragmentShader,
        transparent: true,
        depthFunc: inFront ? LessEqualDepth : GreaterDepth,
        depthWrite: false,
        uniforms: {
            opacity: { value: inFront ? 1 : hiddenOpacity },
            pixelRatio: { value: 1 },
            lift: { value: 0 },
            parallelRays: { value: false },
        },
    });
}

export function markOf(handle: Handle, circle: boolean): Mark {
    if (handle === 'middle' || handle === 'rotate') return handle;
    return circle && handle === 2 ? 'tilt' : 'point';
}
