// The edges of the domain as lines of a width that is the same on every screen: what of a pixel a line covers is worked out, so
// that it looks as bold in a picture of few pixels, as while things move, as in one of many, and is smooth by itself. They are the
// ground of the picture: nothing of them lies over what is in the domain. Those nearest to the eye, which would cross it, are pale.
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
import type { View } from '../base/view.ts';
import { type Bounds, boxEdges, centreOf, edgesBeforeBox } from './domainAxes.ts';

const widthPx = 1.1;
const paleOpacity = 0.3;

const vertexShader = /* glsl */ `
uniform vec2 size;
uniform float halfWidth;
uniform bool parallelRays;
uniform float nearest;
attribute vec3 from;
attribute vec3 to;
attribute float strength;
varying float across;
varying float shown;

void main() {
    vec4 a = modelViewMatrix * vec4(from, 1.0);
    vec4 b = modelViewMatrix * vec4(to, 1.0);
    // What is behind the eye has no place on the screen.
    if (!parallelRays) {
        if (a.z > -nearest && b.z < -nearest) a = mix(a, b, (-nearest - a.z) / (b.z - a.z));
        if (b.z > -nearest && a.z < -nearest) b = mix(b, a, (-nearest - b.z) / (a.z - b.z));
    }
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
    shown = strength;
}
`;

const fragmentShader = /* glsl */ `
uniform vec3 colour;
uniform float width;
uniform float pixelRatio;
varying float across;
varying float shown;

/** How much of a pixel lies to one side of an edge that is so many pixels away from its middle. */
float beyond(float distance) {
    return clamp(distance + 0.5, 0.0, 1.0);
}

void main() {
    float covered = beyond((0.5 * width - across) * pixelRatio) - beyond((-0.5 * width - across) * pixelRatio);
    gl_FragColor = vec4(colour, 1.0);
    #include <colorspace_fragment>
    float alpha = covered * shown;
    gl_FragColor = vec4(gl_FragColor.rgb * alpha, alpha);
}
`;

export class BoxLines {
    readonly object: Mesh<InstancedBufferGeometry, ShaderMaterial>;
    private readonly bounds: Bounds;
    private readonly strength: InstancedBufferAttribute;

    constructor(bounds: Bounds, colour: Color) {
        this.bounds = bounds;
        const ends = boxEdges(bounds);
        const geometry = new InstancedBufferGeometry();
        geometry.setAttribute('position', new Float32BufferAttribute([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0], 3));
        geometry.setIndex([0, 1, 2, 2, 1, 3]);
        const every = (from: number): Float32Array =>
            Float32Array.from({ length: 36 }, (_, i) => ends[6 * Math.floor(i / 3) + from + (i % 3)]!);
        geometry.setAttribute('from', new InstancedBufferAttribute(every(0), 3));
        geometry.setAttribute('to', new InstancedBufferAttribute(every(3), 3));
        this.strength = new InstancedBufferAttribute(new Float32Array(12).fill(1), 1);
        geometry.setAttribute('strength', this.strength);
        geometry.instanceCount = 12;
        this.object = new Mesh(geometry, materialOf(colour));
        this.object.position.set(...centreOf(bounds));
        this.object.frustumCulled = false;
        // Before everything else, which then covers it.
        this.object.renderOrder = -2000;
    }

    setColour(colour: Color): void {
        this.object.material.uniforms['colour']!.value = colour;
    }

    update(view: View): void {
        const { uniforms } = this.object.material;
        (uniforms['size']!.value as Vector2).set(view.drawnSize.width, view.drawnSize.height);
        uniforms['pixelRatio']!.value = view.pixelRatio;
        // Half a pixel more on both sides, of those that it covers a part of.
        uniforms['halfWidth']!.value = widthPx / 2 + 0.5 / view.pixelRatio;
        uniforms['parallelRays']!.value = view.isParallel;
        uniforms['nearest']!.value = view.camera.near;
        edgesBeforeBox(this.bounds, view.outside).forEach((before, i) => (this.strength.array[i] = before ? paleOpacity : 1));
        this.strength.needsUpdate = true;
    }

    dispose(): void {
        this.object.geometry.dispose();
        this.object.material.dispose();
    }
}

function materialOf(colour: Color): ShaderMaterial {
    return new ShaderMaterial({
        vertexShader,
        fragmentShader,
        // Among what is opaque, because what can be seen through comes after that. Colours come multiplied by alpha.
        transparent: false,
        blending: CustomBlending,
        blendEquation: AddEquation,
        ...{
            blendSrc: OneFactor,
            blendDst: OneMinusSrcAlphaFactor,
            blendSrcAlpha: OneFactor,
            blendDstAlpha: OneMinusSrcAlphaFactor,
        },
        depthTest: false,
        depthWrite: false,
        uniforms: {
            colour: { value: colour },
            size: { value: new Vector2(1, 1) },
            width: { value: widthPx },
            halfWidth: { value: widthPx },
            pixelRatio: { value: 1 },
            parallelRays: { value: false },
            nearest: { value: 0 },
        },
    });
}
