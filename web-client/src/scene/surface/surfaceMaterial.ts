// The materials of one surface: the programs and textures (colour tables, noise, a mask that hides nothing) are shared by all, the uniforms
// are the surface's own.
import {
    Color,
    CustomBlending,
    DataArrayTexture,
    DataTexture,
    DoubleSide,
    GLSL3,
    LinearFilter,
    NoBlending,
    OneFactor,
    OneMinusSrcAlphaFactor,
    RedFormat,
    RepeatWrapping,
    RGBAFormat,
    RGFormat,
    ShaderMaterial,
    SRGBColorSpace,
    UnsignedByteType,
    Vector2,
    Vector3,
    Vector4,
    ZeroFactor,
} from 'three';
import { type ColourMapName, colourTable, drawnRange, scaled, scaleOf, steadyRange, tableSize } from './colourMap.ts';
import { directions, noiseSize, smearedNoise } from './flowTexture.ts';
import { coarsestPower, nearestApart } from './patternShader.ts';
import { fragmentShader, mostClipPlanes, pickFragmentShader, vertexShader } from './surfaceShader.ts';
import type { SurfaceStyle } from './surfaceStyle.ts';
import { peelUniforms } from './transparency.ts';

export type FlowTexture = 'none' | 'standing' | 'flowing';

/** Selects the programs with each texture: a software renderer computes what no pixel takes. */
export const textureDefines = { none: {}, standing: { TEXTURED: 1 }, flowing: { TEXTURED: 1, FLOWING: 1 } } as const;

/** A number that nothing on a surface reaches. */
const far = 1e30;
const sources = ['constant', 'scalar', 's', 'age'] as const;
const backSides = ['same', 'shaded', 'tinted'] as const;
const patterns = ['none', 'timelines', 'streamlines', 'grid', 'checker'] as const;
const pieces = ['whole', 'timelines', 'seedlines', 'timeribbons', 'seedribbons', 'arrows'] as const;

/** Planes that cut nothing, as many as there may be. */
export function noPlanes(): Vector4[] {
    return Array.from({ length: mostClipPlanes }, () => new Vector4(0, 0, 0, 1));
}

/** Makes the uniforms of all surfaces together; the same objects in every material. */
export function sharedUniforms() {
    return {
        clip: { value: noPlanes() },
        depthRange: { value: new Vector2(0, 1) },
        respectPaint: { value: true },
        /** What can be seen through is drawn as screen doors. */
        doors: { value: false },
        pixelRatio: { value: 1 },
        flowed: { value: 0 },
        noise: { value: null as DataArrayTexture | null },
        waves: { value: null as DataArrayTexture | null },
        /** Scales the flow texture, see grainsPerLength(). */
        noiseScale: { value: 1 },
        noiseFrom: { value: new Vector3() },
        ...peelUniforms(),
    };
}
export type SharedUniforms = ReturnType<typeof sharedUniforms>;

function ownUniforms(textures: SurfaceTextures) {
    return {
        pickId: { value: 0 },
        source: { value: 1 },
        ageOf: { value: new Vector2(0, 1) },
        window: { value: new Vector4(-far, far, -far, far) },
        painting: { value: false },
        faded: { value: 0 },
        maskT: { value: new Vector2(0, 1) },
        mask: { value: textures.blank },
        opacity: { value: 1 },
        colours: { value: textures.colours('viridis') },
        constant: { value: new Color(1, 1, 1) },
        range: { value: new Vector2(0, 1) },
        inverted: { value: false },
        logarithmic: { value: false },
        root: { value: false },
        bands: { value: 0 },
        backSide: { value: 1 },
        silhouettes: { value: false },
        hatchAbove: { value: far },
        angleOpacity: { value: false },
        smoke: { value: 0 },
        stretchKnown: { value: false },
        areaPerSeed: { value: 1 },
        ageSpan: { value: 1 },
        fixedGrid: { value: false },
        lines: { value: 0 },
        pieces: { value: 0 },
        pieceNear: { value: 1 },
        pieceWidth: { value: 1 },
        pieceS: { value: new Vector4(0, 1, 0.5, 0) },
        pieceT: { value: new Vector4() },
        rakeCloses: { value: false },
        lineDensity: { value: 1 },
        byItself: { value: false },
        flowTime: { value: 0 },
        patternT: { value: new Vector2(0, 1) },
    };
}

/** Makes what programs of that texture look up. */
export function makeNoise(texture: FlowTexture, shared: SharedUniforms, textures: SurfaceTextures): void {
    if (texture === 'standing') shared.noise.value = textures.noise(false);
    if (texture === 'flowing') shared.waves.value = textures.noise(true);
}

/** What a style needs to know of the mesh. */
export interface MeshFacts {
    time: number;
    scalarRange: readonly [number, number];
    tRange: readonly [number, number];
    /** What t is counted from in the shaders. */
    tFrom: number;
    hasStretch: boolean;
    hasIntervals: boolean;
    hasFlow: boolean;
    hasUnits: boolean;
    hasUnresolved: boolean;
}

/** Returns the lines' offset in t as the shaders have it, counted from the first. */
function pieceT({ tRange: [low, high], tFrom }: MeshFacts): Vector4 {
    const power = coarsestPower(low, high);
    // Multiples stay the same ones without the whole turns of the largest.
    return new Vector4(low - tFrom, high - tFrom, power, tFrom % (4 * power));
}

export class SurfaceMaterials {
    /** It lets little light through. */
    isDense = true;
    readonly plain: ShaderMaterial;
    /** Discs at the vertices. */
    readonly splats: ShaderMaterial;
    readonly opaque: ShaderMaterial;
    readonly blended: ShaderMaterial;
    readonly peeled: ShaderMaterial;
    readonly pick: ShaderMaterial;
    /** What is drawn as the two ends of the colours. */
    range: [number, number] = [0, 1];
    ages: [number, number] = [0, 1];
    private texture: FlowTexture = 'none';
    private readonly own: ReturnType<typeof ownUniforms>;
    private readonly textures: SurfaceTextures;
    private readonly shared: SharedUniforms;

    constructor(textures: SurfaceTextures, shared: SharedUniforms) {
        this.textures = textures;
        this.shared = shared;
        this.own = ownUniforms(textures);
        const uniforms = { ...this.own, ...shared };
        const common = { glslVersion: GLSL3, vertexShader, uniforms, side: DoubleSide };
        this.plain = new ShaderMaterial({ ...common, fragmentShader, defines: { PLAIN: 1 } });
        this.splats = new ShaderMaterial({ ...common, fragmentShader, defines: { SPLATS: 1 } });
        this.opaque = new ShaderMaterial({ ...common, fragmentShader, defines: {} });
        this.blended = new ShaderMaterial({
            ...common,
            fragmentShader,
            defines: { BLENDED: 1 },
            transparent: true,
            depthWrite: false,
            // Colours add up; alpha becomes the product of what passes through (WeightedBlending).
            blending: CustomBlending,
            blendSrc: OneFactor,
            blendDst: OneFactor,
            blendSrcAlpha: ZeroFactor,
            blendDstAlpha: OneMinusSrcAlphaFactor,
        });
        this.peeled = new ShaderMaterial({ ...common, fragmentShader, defines: { PEELED: 1 }, blending: NoBlending });
        this.pick = new ShaderMaterial({ ...common, fragmentShader: pickFragmentShader, blending: NoBlending });
    }

    set pickId(id: number) {
        this.own.pickId.value = id;
    }

    setMask(mask: DataTexture | null, from: number, scale: number): void {
        this.own.mask.value = mask ?? this.textures.blank;
        this.own.maskT.value.set(from, scale);
    }

    apply(style: SurfaceStyle, facts: MeshFacts): void {
        const { own } = this;
        const { sWindow, ageWindow } = style;
        const ageSign = style.tIsRelease ? -1 : 1;
        const ageStart = style.tIsRelease ? facts.time : 0;
        const [first, last] = facts.tRange.map((t) => ageStart + ageSign * t) as [number, number];
        const ages: [number, number] = first <= last ? [first, last] : [last, first];
        this.ages = ages;
        own.source.value = sources.indexOf(style.source);
        own.ageOf.value.set(ageStart + ageSign * facts.tFrom, ageSign);
        own.window.value.set(...(sWindow ?? [-far, far]), ...(ageWindow ?? [-far, far]));
        own.painting.value = style.painting;
        own.faded.value = style.faded;
        own.opacity.value = style.opacity;
        own.colours.value = this.textures.colours(style.map);
        own.constant.value.set(style.colour);
        own.inverted.value = style.inverted;
        const scale = scaleOf(style);
        own.logarithmic.value = scale === 'log';
        own.root.value = scale === 'root';
        own.bands.value = style.bands;
        const seen = { constant: [0, 1], scalar: facts.scalarRange, s: [0, 1], age: ages }[style.source];
        const [least, greatest] = [seen[0] ?? 0, seen[1] ?? 1];
        // Of zero there is no logarithm.
        const rounded = style.source === 'scalar' && !style.logarithmic;
        const wanted = style.range ?? (rounded ? steadyRange(least, greatest) : [least, greatest]);
        this.range = drawnRange(wanted, scale, style.centre);
        const [low, high] = this.range;
        own.range.value.set(scaled(low, scale), scaled(high, scale));
        this.isDense = style.opacity >= 0.5 && style.smoke === 0;
        own.backSide.value = backSides.indexOf(style.backSide);
        own.silhouettes.value = style.silhouettes && !style.points;
        own.hatchAbove.value = facts.hasIntervals ? (style.hatchAbove ?? far) : far;
        own.angleOpacity.value = style.angleOpacity;
        own.smoke.value = style.smoke;
        own.fixedGrid.value = style.fixedGrid && facts.hasUnresolved;
        own.stretchKnown.value = facts.hasStretch;
        own.areaPerSeed.value = style.areaPerSeed;
        own.ageSpan.value = Math.max(1e-30, ages[1]);
        // What changes from pixel to pixel on cells does not on a disc.
        own.lines.value = style.points ? 0 : patterns.indexOf(style.lines);
        own.lineDensity.value = style.density;
        own.pieces.value =
            !style.points && facts.hasUnits && (facts.hasFlow || style.pieces !== 'arrows') ? pieces.indexOf(style.pieces) : 0;
        own.pieceNear.value = nearestApart(style.pieceEvery);
        own.pieceWidth.value = style.pieceWidth;
        own.pieceT.value.copy(pieceT(facts));
        own.rakeCloses.value = style.rakeCloses;
        this.setTexture(!style.texture || !facts.hasFlow ? 'none' : style.textureMoves === 'no' ? 'standing' : 'flowing');
        own.byItself.value = style.textureMoves === 'byItself';
        own.flowTime.value = style.textureMoves === 'withTime' ? facts.time - style.from : 0;
        own.patternT.value.set(style.tOrigin - facts.tFrom, ageSign);
    }

    /** Programs with it are made when it is first wanted. */
    private setTexture(texture: FlowTexture): void {
        if (texture === this.texture) return;
        this.texture = texture;
        makeNoise(texture, this.shared, this.textures);
        for (const material of [this.plain, this.splats, this.opaque, this.blended, this.peeled]) {
            const { TEXTURED: _textured, FLOWING: _flowing, ...others } = material.defines;
            material.defines = { ...others, ...textureDefines[texture] };
            material.needsUpdate = true;
        }
    }

    dispose(): void {
        for (const material of [this.plain, this.splats, this.opaque, this.blended, this.peeled, this.pick]) material.dispose();
    }
}

export class SurfaceTextures {
    readonly blank = new DataTexture(Uint8Array.of(255), 1, 1, RedFormat, UnsignedByteType);
    private readonly tables = new Map<ColourMapName, DataTexture>();
    private readonly noises = new Map<boolean, DataArrayTexture>();

    constructor() {
        this.blank.needsUpdate = true;
    }

    /** Made when it is first needed, which takes a tenth of a second. */
    noise(moving: boolean): DataArrayTexture {
        const known = this.noises.get(moving);
        if (known !== undefined) return known;
        const texture = new DataArrayTexture(smearedNoise(moving), noiseSize, noiseSize, directions + 1);
        texture.format = moving ? RGBAFormat : RGFormat;
        texture.minFilter = texture.magFilter = LinearFilter;
        texture.wrapS = texture.wrapT = RepeatWrapping;
        texture.needsUpdate = true;
        this.noises.set(moving, texture);
        return texture;
    }

    colours(name: ColourMapName): DataTexture {
        const known = this.tables.get(name);
        if (known !== undefined) return known;
        const texture = new DataTexture(colourTable(name), tableSize, 1, RGBAFormat, UnsignedByteType);
        texture.colorSpace = SRGBColorSpace;
        texture.minFilter = texture.magFilter = LinearFilter;
        texture.needsUpdate = true;
        this.tables.set(name, texture);
        return texture;
    }
}
