// Lines through space with a width in pixels, coloured by values along them in the shader. Each looks like a thin tube: its middle has the
// colour of the bar, its sides are darker, so that lines before each other are told apart on any ground and in print.
import {
    DataTexture,
    DoubleSide,
    Float32BufferAttribute,
    Group,
    InstancedBufferGeometry,
    InstancedInterleavedBuffer,
    InterleavedBufferAttribute,
    LinearFilter,
    Mesh,
    ShaderMaterial,
    SRGBColorSpace,
    Vector2,
} from 'three';
import type { LinesFile } from '../../protocol/linesFile.ts';
import { beforeEyeShader } from '../base/beforeEye.ts';
import type { Layer, View } from '../base/view.ts';
import { type ColourMapName, colourTable, tableSize } from '../surface/colourMap.ts';
import { screenDoorGlsl } from '../surface/renderPasses.ts';

/** How lines are coloured. */
export interface LineColours {
    map: ColourMapName;
    /** Values of the ends of the map. */
    range: readonly [number, number];
    opacity: number;
}

interface Drawn {
    mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
    lines: LinesFile;
    map: ColourMapName;
}

/** Beyond all values: between the end of a line and the beginning of the next nothing is drawn; where there is no value, grey. */
const between = 3e38;
const unknown = 1e38;

const vertexShader = /* glsl */ `
${beforeEyeShader}
uniform vec2 size;
uniform float halfWidth;
attribute vec4 from;
attribute vec4 to;
varying vec2 place; // along and across, in half widths from the beginning
varying float reach; // how long it is, in half widths
varying vec2 values;
varying float weight; // of the place on the screen: what is nearer takes more of a line

void main() {
    if (max(from.w, to.w) > 2e38) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
        return;
    }
    vec4 a = modelViewMatrix * vec4(from.xyz, 1.0);
    vec4 b = modelViewMatrix * vec4(to.xyz, 1.0);
    keepBeforeEye(a, b);
    // A little nearer than they are: lines that lie in a slice or on a body are seen whole.
    a.xyz *= parallelRays ? vec3(1.0, 1.0, 0.998) : vec3(0.998);
    b.xyz *= parallelRays ? vec3(1.0, 1.0, 0.998) : vec3(0.998);
    vec4 clipA = projectionMatrix * a;
    vec4 clipB = projectionMatrix * b;
    vec2 direction = (clipB.xy / clipB.w - clipA.xy / clipA.w) * size * 0.5;
    float px = length(direction);
    direction = px > 1e-4 ? direction / px : vec2(1.0, 0.0);
    vec4 clip = position.x < 0.5 ? clipA : clipB;
    float end = position.x * 2.0 - 1.0;
    clip.xy += 2.0 * (vec2(-direction.y, direction.x) * position.y + direction * end) * halfWidth / size * clip.w;
    gl_Position = clip;
    reach = px / halfWidth;
    // Pixels of the screen are what a line is wide in, whatever lies nearer.
    place = vec2(position.x < 0.5 ? -1.0 : reach + 1.0, position.y) * clip.w;
    values = vec2(from.w, to.w);
    weight = clip.w;
}
`;

const fragmentShader = /* glsl */ `
uniform sampler2D table;
uniform vec2 scale; // from a value to a place in the table
uniform float opacity;
varying vec2 place;
varying float reach;
varying float weight;
varying vec2 values;
${screenDoorGlsl}

void main() {
    if (!isThere(opacity, ivec2(2, 1))) discard;
    vec2 here = place / weight;
    float along = clamp(here.x, 0.0, reach);
    // Round ends close what is open between two pieces at an angle.
    if (length(vec2(here.x - along, here.y)) > 1.0) discard;
    vec3 colour = vec3(0.5);
    if (max(abs(values.x), abs(values.y)) < ${(unknown / 2).toExponential()}) {
        float t = scale.x * mix(values.x, values.y, reach > 0.0 ? along / reach : 0.0) + scale.y;
        colour = texture2D(table, vec2((clamp(t, 0.0, 1.0) * ${tableSize - 1}.0 + 0.5) / ${tableSize}.0, 0.5)).rgb;
    }
    gl_FragColor = vec4(colour * mix(0.35, 1.0, sqrt(max(0.0, 1.0 - here.y * here.y))), 1.0);
    #include <colorspace_fragment>
}
`;

export class LineLayer implements Layer {
    readonly object = new Group();
    private readonly drawn = new Map<string, Drawn>();
    private width = 3;

    /** In pixels of CSS. */
    setWidth(width: number): void {
        this.width = width;
    }

    set(id: string, lines: LinesFile, { map, range: [low, high], opacity }: LineColours): void {
        let held = this.drawn.get(id);
        if (held === undefined) {
            held = { mesh: new Mesh(geometryOf(lines), createMaterial(map)), lines, map };
            held.mesh.frustumCulled = false;
            this.drawn.set(id, held);
            this.object.add(held.mesh);
        } else if (held.lines !== lines) {
            held.mesh.geometry.dispose();
            held.mesh.geometry = geometryOf(lines);
        }
        const { mesh } = held;
        mesh.position.set(...lines.origin);
        mesh.visible = lines.points.length > 0;
        const { table, scale, opacity: seen } = mesh.material.uniforms as Record<string, { value: unknown }>;
        const texture = table!.value as DataTexture;
        if (held.map !== map) {
            texture.image.data!.set(colourTable(map));
            texture.needsUpdate = true;
        }
        const length = high > low ? high - low : 1;
        (scale!.value as Vector2).set(1 / length, -low / length);
        seen!.value = opacity;
        [held.lines, held.map] = [lines, map];
    }

    remove(id: string): void {
        const held = this.drawn.get(id);
        if (held === undefined) return;
        this.drawn.delete(id);
        this.object.remove(held.mesh);
        held.mesh.geometry.dispose();
        (held.mesh.material.uniforms['table']!.value as DataTexture).dispose();
        held.mesh.material.dispose();
    }

    update(view: View): void {
        for (const { mesh } of this.drawn.values()) {
            const { uniforms } = mesh.material;
            (uniforms['size']!.value as Vector2).set(view.drawnSize.width, view.drawnSize.height);
            uniforms['halfWidth']!.value = this.width / 2;
            uniforms['parallelRays']!.value = view.isParallel;
            uniforms['nearest']!.value = view.camera.near;
        }
    }
}

/** All points one after the other, each a pair with the next, and between two lines one that ends the pair. */
function geometryOf({ offsets, points, values }: LinesFile): InstancedBufferGeometry {
    const lines = offsets.length - 1;
    const packed = new Float32Array(4 * (values.length + lines));
    let to = 0;
    for (let line = 0; line < lines; ++line) {
        for (let i = offsets[line]!; i < offsets[line + 1]!; ++i) {
            packed.set(points.subarray(3 * i, 3 * i + 3), to);
            packed[to + 3] = Number.isFinite(values[i]) ? values[i]! : unknown;
            to += 4;
        }
        packed[to + 3] = between;
        to += 4;
    }
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    const buffer = new InstancedInterleavedBuffer(packed, 4);
    geometry.setAttribute('from', new InterleavedBufferAttribute(buffer, 4, 0));
    geometry.setAttribute('to', new InterleavedBufferAttribute(buffer, 4, 4));
    geometry.instanceCount = Math.max(0, to / 4 - 1);
    return geometry;
}

function createMaterial(map: ColourMapName): ShaderMaterial {
    const table = new DataTexture(colourTable(map), tableSize, 1);
    table.colorSpace = SRGBColorSpace;
    table.magFilter = table.minFilter = LinearFilter;
    table.needsUpdate = true;
    return new ShaderMaterial({
        vertexShader,
        fragmentShader,
        // Which way a piece faces says where it goes.
        side: DoubleSide,
        uniforms: {
            size: { value: new Vector2(1, 1) },
            halfWidth: { value: 1.5 },
            parallelRays: { value: false },
            nearest: { value: 0 },
            table: { value: table },
            scale: { value: new Vector2(1, 0) },
            opacity: { value: 1 },
        },
    });
}
