// Planes through the data, each a rectangle with a raster of values that are coloured in the shader: unlit, so that a colour is that of the
// bar. Where there is no value nothing is drawn, and the picture behind is seen.
import {
    BufferAttribute,
    BufferGeometry,
    DataTexture,
    DoubleSide,
    Group,
    LinearFilter,
    Mesh,
    NearestFilter,
    RedIntegerFormat,
    ShaderMaterial,
    SRGBColorSpace,
    UnsignedShortType,
    Vector2,
} from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { noSliceValue, sliceCodes, type SliceRaster } from '../../protocol/sliceFile.ts';
import type { Layer, ScreenPoint, SeenPoint, View } from '../base/view.ts';
import { cross, dot, minus, plus, times } from '../rake/rakeShape.ts';
import { shadedLayer } from '../surface/contactShade.ts';
import { screenDoorGlsl } from '../surface/renderPasses.ts';
import { type ColourMapName, colourTable, tableSize } from '../surface/colourMap.ts';

/** How a slice is coloured. */
export interface SliceColours {
    map: ColourMapName;
    /** Values of the ends of the map. */
    range: [number, number];
    /** Lines of equal values, between which the range is divided evenly; 0: none. */
    contours: number;
    /** Above 0. */
    opacity: number;
}

interface Drawn {
    mesh: Mesh<BufferGeometry, ShaderMaterial>;
    raster: SliceRaster;
    colours: SliceColours | null;
}

const vertexShader = `
varying vec2 at;

void main() {
    at = uv;
    #include <begin_vertex>
    #include <project_vertex>
}`;

const fragmentShader = `
precision highp usampler2D;
uniform usampler2D codes;
uniform sampler2D table;
uniform vec2 size;
uniform vec2 scale; // from a code to a place in the table
uniform float contours;
uniform float opacity;
varying vec2 at;
${screenDoorGlsl}

uint codeAt(ivec2 place) {
    return texelFetch(codes, clamp(place, ivec2(0), ivec2(size) - 1), 0).r;
}

void main() {
    if (!isThere(opacity, ivec2(1, 2))) discard;
    vec2 place = at * size;
    // Bodies and the domain end where the nearest sample says.
    if (codeAt(ivec2(place)) == ${noSliceValue}u) discard;
    vec2 from = floor(place - 0.5);
    vec2 part = place - 0.5 - from;
    float sum = 0.0;
    float weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        vec2 corner = vec2(k & 1, k >> 1);
        uint code = codeAt(ivec2(from + corner));
        vec2 share = mix(1.0 - part, part, corner);
        float weight = code == ${noSliceValue}u ? 0.0 : share.x * share.y;
        sum += weight * float(code);
        weights += weight;
    }
    float t = scale.x * sum / max(weights, 1e-6) + scale.y;
    vec3 colour = texture(table, vec2((clamp(t, 0.0, 1.0) * ${tableSize - 1}.0 + 0.5) / ${tableSize}.0, 0.5)).rgb;
    if (contours > 0.0) {
        float level = t * contours;
        // In the middle between: where a field is about 0 all over, a line of 0 would be noise.
        float line = abs(fract(level) - 0.5) / max(fwidth(level), 1e-6);
        if (t > 0.0 && t < 1.0) colour *= mix(0.25, 1.0, smoothstep(0.4, 1.1, line));
    }
    gl_FragColor = vec4(colour, 1.0);
    #include <colorspace_fragment>
}`;

export class SliceLayer implements Layer {
    readonly object = new Group();
    private readonly drawn = new Map<string, Drawn>();

    update(): void {}

    /** @param colours null: there are no values, and nothing is seen */
    set(id: string, raster: SliceRaster, colours: SliceColours | null): void {
        let slice = this.drawn.get(id);
        if (slice === undefined) {
            slice = { mesh: createSlice(), raster, colours: null };
            this.drawn.set(id, slice);
            this.object.add(slice.mesh);
            place(slice.mesh, raster);
        } else if (slice.raster !== raster) place(slice.mesh, raster);
        colour(slice, raster, colours);
        [slice.raster, slice.colours] = [raster, colours];
    }

    /** Where it has values. */
    pick(view: View, at: ScreenPoint): (SeenPoint & { slice: string }) | null {
        let nearest: (SeenPoint & { slice: string }) | null = null;
        for (const [slice, { mesh, raster }] of this.drawn) {
            const point = mesh.visible ? meeting(raster, view.sightLine(at)) : null;
            if (point === null) continue;
            const distance = view.distanceTo(point);
            if (distance < (nearest?.distance ?? Infinity)) nearest = { slice, point, distance };
        }
        return nearest;
    }

    remove(id: string): void {
        const slice = this.drawn.get(id);
        if (slice === undefined) return;
        this.drawn.delete(id);
        this.object.remove(slice.mesh);
        slice.mesh.geometry.dispose();
        for (const name of ['codes', 'table']) (slice.mesh.material.uniforms[name]!.value as DataTexture).dispose();
        slice.mesh.material.dispose();
    }
}

/** Where a line of sight meets what is drawn of a raster. */
function meeting({ corner, across, up, columns, rows, codes }: SliceRaster, [eye, further]: [Vec3, Vec3]): Vec3 | null {
    const normal = cross(across, up);
    const sight = minus(further, eye);
    const part = dot(normal, minus(corner, eye)) / dot(normal, sight);
    if (!(part >= 0)) return null;
    const point = plus(eye, times(sight, part));
    const place = (side: Vec3, count: number): number => Math.floor((count * dot(minus(point, corner), side)) / dot(side, side));
    const [column, row] = [place(across, columns), place(up, rows)];
    const inside = column >= 0 && column < columns && row >= 0 && row < rows;
    return inside && codes[row * columns + column] !== noSliceValue ? point : null;
}

function createSlice(): Drawn['mesh'] {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(12), 3));
    geometry.setAttribute('uv', new BufferAttribute(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const table = new DataTexture(colourTable(), tableSize, 1);
    table.colorSpace = SRGBColorSpace;
    table.magFilter = table.minFilter = LinearFilter;
    table.needsUpdate = true;
    const material = new ShaderMaterial({
        vertexShader,
        fragmentShader,
        side: DoubleSide,
        // Behind the arrows that lie on it.
        ...{ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 },
        uniforms: {
            codes: { value: codesTexture(new Uint16Array(1), 1, 1) },
            table: { value: table },
            size: { value: new Vector2(1, 1) },
            scale: { value: new Vector2(0, 0) },
            contours: { value: 0 },
            opacity: { value: 1 },
        },
    });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.layers.enable(shadedLayer);
    return mesh;
}

function codesTexture(codes: Uint16Array<ArrayBuffer>, columns: number, rows: number): DataTexture {
    const texture = new DataTexture(codes, columns, rows, RedIntegerFormat, UnsignedShortType);
    texture.internalFormat = 'R16UI';
    texture.magFilter = texture.minFilter = NearestFilter;
    texture.unpackAlignment = 2;
    texture.needsUpdate = true;
    return texture;
}

/** Takes the rectangle and the values of a raster. */
function place({ geometry, material }: Drawn['mesh'], raster: SliceRaster): void {
    const { corner, across, up, columns, rows, codes } = raster;
    const position = geometry.attributes['position'] as BufferAttribute;
    [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
    ].forEach(([s = 0, t = 0], i) => {
        position.setXYZ(i, ...([0, 1, 2].map((k) => corner[k]! + s * across[k]! + t * up[k]!) as [number, number, number]));
    });
    position.needsUpdate = true;
    const { codes: held, size } = material.uniforms as Record<string, { value: unknown }>;
    (held!.value as DataTexture).dispose();
    held!.value = codesTexture(codes, columns, rows);
    (size!.value as Vector2).set(columns, rows);
}

function colour({ mesh, colours: before }: Drawn, { range: [low, high] }: SliceRaster, colours: SliceColours | null): void {
    mesh.visible = colours !== null;
    if (colours === null) return;
    const { table, scale, contours, opacity } = mesh.material.uniforms as Record<string, { value: unknown }>;
    if (colours.map !== (before?.map ?? 'viridis')) {
        const texture = table!.value as DataTexture;
        texture.image.data!.set(colourTable(colours.map));
        texture.needsUpdate = true;
    }
    const [from, to] = colours.range;
    const length = to > from ? to - from : 1;
    (scale!.value as Vector2).set((high - low) / sliceCodes / length, (low - from) / length);
    contours!.value = colours.contours;
    opacity!.value = colours.opacity;
}
