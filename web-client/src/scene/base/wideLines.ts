// Straight lines of a width that is the same on every screen: what of a pixel a line covers is worked out, so
// that it looks as bold in a picture of few pixels, as while things move, as in one of many, and is smooth by
// itself.
import {
    AddEquation,
    type Color,
    CustomBlending,
    Float32BufferAttribute,
    InstancedBufferAttribute,
    InstancedBufferGeometry,
    Mesh,
    OneFactor,
    OneMinusSrcAlphaFactor,
    ShaderMaterial,
    Vector2,
} from 'three';
import { beforeEyeShader } from './beforeEye.ts';
import type { View } from './view.ts';

const vertexShader = /* glsl */ `
${beforeEyeShader}
uniform vec2 size;
uniform float halfWidth;
attribute vec3 from;
attribute vec3 to;
attribute vec4 tint;
varying float across;
varying vec4 shown;

void main() {
    vec4 a = modelViewMatrix * vec4(from, 1.0);
    vec4 b = modelViewMatrix * vec4(to, 1.0);
    keepBeforeEye(a, b);
    vec4 clipA = projectionMatrix * a;
    vec4 clipB = projectionMatrix * b;
    vec2 direction = (clipB.xy / clipB.w - clipA.xy / clipA.w) * size;
    float px = length(direction);
    direction = px > 0.0 ? direction / px : vec2(1.0, 0.0);
    vec4 clip = position.x < 0.5 ? clipA : clipB;
    vec2 offset = vec2(-direction.y, direction.x) * position.y + direction * (position.x * 2.0 - 1.0) * 0.3;
    // Sizes are twice as large as what they are in these coordinates.
    clip.xy += 2.0 * offset * halfWidth / size * clip.w;
    gl_Position = clip;
    across = position.y * halfWidth;
    shown = tint;
}
`;

const fragmentShader = /* glsl */ `
uniform float width;
uniform float pixelRatio;
varying float across;
varying vec4 shown;

/** Returns how much of a pixel lies to one side of an edge that is so many pixels away from its middle. */
float beyond(float distance) {
    return clamp(distance + 0.5, 0.0, 1.0);
}

void main() {
    float covered = beyond((0.5 * width - across) * pixelRatio) - beyond((-0.5 * width - across) * pixelRatio);
    gl_FragColor = vec4(shown.rgb, 1.0);
    #include <colorspace_fragment>
    float alpha = covered * shown.a;
    gl_FragColor = vec4(gl_FragColor.rgb * alpha, alpha);
}
`;

export interface WideLinesOptions {
    /** In pixels of CSS. */
    width: number;
    /** Whether what is before them hides them. */
    hidden: boolean;
    /** Drawn among what is opaque, and so before all that can be seen through. */
    early?: boolean;
}

export class WideLines {
    readonly object: Mesh<InstancedBufferGeometry, ShaderMaterial>;
    private readonly width: number;

    constructor({ width, hidden, early = false }: WideLinesOptions) {
        this.width = width;
        this.object = new Mesh(linesOf([], []), materialOf(width, hidden, early));
        this.object.frustumCulled = false;
        this.object.visible = false;
    }

    /** @param ends xyz of both ends, line by line  @param tints red, green, blue and opacity of each */
    set(ends: ArrayLike<number>, tints: readonly number[]): void {
        this.object.geometry.dispose();
        this.object.geometry = linesOf(ends, tints);
        this.object.visible = ends.length > 0;
    }

    tint(tints: readonly number[]): void {
        const attribute = this.object.geometry.getAttribute('tint') as InstancedBufferAttribute;
        attribute.array.set(tints);
        attribute.needsUpdate = true;
    }

    update(view: View): void {
        const { uniforms } = this.object.material;
        (uniforms['size']!.value as Vector2).set(view.drawnSize.width, view.drawnSize.height);
        uniforms['pixelRatio']!.value = view.pixelRatio;
        // Half a pixel more on both sides, of those that it covers a part of.
        uniforms['halfWidth']!.value = this.width / 2 + 0.5 / view.pixelRatio;
        uniforms['parallelRays']!.value = view.isParallel;
        uniforms['nearest']!.value = view.camera.near;
    }

    dispose(): void {
        this.object.geometry.dispose();
        this.object.material.dispose();
    }
}

/** Returns a colour as `tint` takes it. */
export function tintOf({ r, g, b }: Color, opacity = 1): [number, number, number, number] {
    return [r, g, b, opacity];
}

function linesOf(ends: ArrayLike<number>, tints: readonly number[]): InstancedBufferGeometry {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    const count = ends.length / 6;
    const every = (from: number): Float32Array =>
        Float32Array.from({ length: 3 * count }, (_, i) => ends[6 * Math.floor(i / 3) + from + (i % 3)]!);
    geometry.setAttribute('from', new InstancedBufferAttribute(every(0), 3));
    geometry.setAttribute('to', new InstancedBufferAttribute(every(3), 3));
    geometry.setAttribute('tint', new InstancedBufferAttribute(Float32Array.from(tints), 4));
    geometry.instanceCount = count;
    return geometry;
}

function materialOf(width: number, hidden: boolean, early: boolean): ShaderMaterial {
    return new ShaderMaterial({
        vertexShader,
        fragmentShader,
        // Colours come multiplied by alpha.
        transparent: !early,
        blending: CustomBlending,
        blendEquation: AddEquation,
        ...{
            blendSrc: OneFactor,
            blendDst: OneMinusSrcAlphaFactor,
            blendSrcAlpha: OneFactor,
            blendDstAlpha: OneMinusSrcAlphaFactor,
        },
        depthTest: hidden,
        depthWrite: false,
        uniforms: {
            size: { value: new Vector2(1, 1) },
            width: { value: width },
            halfWidth: { value: width },
            pixelRatio: { value: 1 },
            parallelRays: { value: false },
            nearest: { value: 0 },
        },
    });
}
