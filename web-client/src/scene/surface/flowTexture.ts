// Flow texture: noise in space, smeared along the part of the velocity that is tangential to the surface, as
// Laramee et al. 2004 and 2006 advect it in the picture. In space, so that it stays on the surface while the
// view turns, and is the same in every tile of a figure.

/** Larger grains along a side of what repeats, and numbers: a grain is as wide as four, or two, so that none
 *  is a stair. */
const noiseGrains = 48;
/**
 * Noise smeared in advance, once in each of many directions, all of the same noise, so that neighbours among them hardly differ
 * (line integral convolution, Cabral and Leedom 1993, over so short a way that it is straight). A pixel then needs one look-up,
 * whatever the direction.
 */
export const noiseSize = 4 * noiseGrains;
/** Over half a turn; one more is the first one the other way round. The widest gap is 3.6 degrees. */
export const directions = 64;
/** Larger grains that a wave is long. It is as long where grains are smaller, so that one wave moves both. */
const waveGrains = 5;
/** Grains that are smeared together. */
const smearedGrains = 14;
/** Is that of the light: what is further from the middle than half is cut off. */
const standardDeviation = 0.3;
/** Numbers that are repeated round the noise, so that what is next to a place never wraps round. */
const margin = 2 * smearedGrains + 2;
const paddedSize = noiseSize + 2 * margin;

/**
 * Returns a direction in the plane, as the shader counts them: evenly in x / (|x| + |y|), which needs no arc
 * tangent. Returns a vector of any length; y is not negative.
 */
function directionOf(layer: number): [number, number] {
    const x = 1 - (2 * layer) / directions;
    return [x, 1 - Math.abs(x)];
}

/** Direction after direction: of each place the larger grain and the smaller one; each under both waves where
 *  it is to move. */
export function smearedNoise(moving: boolean): Uint8Array<ArrayBuffer> {
    const grains = [4, 2].map((width) => ({ width, noise: paddedNoise(width) }));
    const waves = moving ? (['cos', 'sin'] as const) : (['none'] as const);
    const channels = 2 * waves.length;
    const bytes = new Uint8Array(channels * noiseSize ** 2 * (directions + 1));
    const sum = new Float32Array(noiseSize ** 2);
    for (let layer = 0; layer <= directions; ++layer) {
        for (const [size, { width, noise }] of grains.entries()) {
            for (const [i, wave] of waves.entries()) {
                smear(sum, noise, kernelOf(directionOf(layer), width, wave));
                put(bytes, channels * sum.length * layer + waves.length * size + i, channels, sum);
            }
        }
    }
    return bytes;
}

/** How far away in the padded noise, and with what weight. */
type Tap = readonly [offset: number, weight: number];

/** @param grain  so many numbers are a grain */
function kernelOf([x, y]: [number, number], grain: number, wave: 'none' | 'cos' | 'sin'): Tap[] {
    const flat = Math.abs(x) >= y;
    const slope = flat ? y / x : x / y;
    // Along the nearer axis by whole numbers, a grain at most; across it is shared by the two numbers it lies
    // between.
    const step = Math.round(grain / Math.hypot(1, slope));
    const length = (step * Math.hypot(1, slope)) / grain;
    const reach = Math.floor(smearedGrains / 2 / length);
    const sign = flat && x < 0 ? -1 : 1;
    return Array.from({ length: 2 * reach + 1 }, (_, i) => i - reach).flatMap((k): Tap[] => {
        const along = sign * k * length;
        const angle = (2 * Math.PI * along * grain) / (4 * waveGrains);
        const fading = 0.5 + 0.5 * Math.cos((2 * Math.PI * along) / smearedGrains);
        const weight = fading * (wave === 'none' ? 1 : wave === 'cos' ? Math.cos(angle) : Math.sin(angle));
        const across = Math.floor(k * step * slope);
        const part = k * step * slope - across;
        const at = (side: number): number => (flat ? k * step + paddedSize * side : side + paddedSize * k * step);
        return [
            [at(across), (1 - part) * weight],
            [at(across + 1), part * weight],
        ];
    });
}

/** Four taps at a time, which is as fast as it gets. */
function smear(sum: Float32Array, noise: Float32Array, taps: readonly Tap[]): void {
    const none: Tap = [0, 0];
    sum.fill(0);
    for (let t = 0; t < taps.length; t += 4) {
        const [[a, p], [b, q], [c, r], [d, s]] = [0, 1, 2, 3].map((i) => taps[t + i] ?? none) as [Tap, Tap, Tap, Tap];
        for (let row = 0; row < noiseSize; ++row) {
            const from = paddedSize * (row + margin) + margin;
            const to = noiseSize * row;
            for (let i = 0; i < noiseSize; ++i) {
                const at = from + i;
                sum[to + i]! += p * noise[at + a]! + q * noise[at + b]! + r * noise[at + c]! + s * noise[at + d]!;
            }
        }
    }
}

function put(bytes: Uint8Array, at: number, stride: number, sum: Float32Array): void {
    let power = 0;
    for (const value of sum) power += value * value;
    const scale = (255 * standardDeviation) / Math.sqrt(power / sum.length);
    for (let i = 0; i < sum.length; ++i) bytes[at + stride * i] = Math.min(255, Math.max(0, 127.5 + scale * sum[i]!));
}

/** White, of mean 0, linear between its grains. @param grain  so many numbers */
function paddedNoise(grain: number): Float32Array {
    const size = noiseSize / grain;
    let state = 12345 + size;
    const white = Float32Array.from({ length: size ** 2 }, () => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return state / 2 ** 32 - 0.5;
    });
    const at = (row: number, column: number): number => white[(row % size) * size + (column % size)]!;
    return Float32Array.from({ length: paddedSize ** 2 }, (_, i) => {
        const y = (Math.floor(i / paddedSize) - margin + noiseSize) / grain;
        const x = ((i % paddedSize) - margin + noiseSize) / grain;
        const [row, column] = [Math.floor(y), Math.floor(x)];
        const [v, u] = [y - row, x - column];
        const lower = (1 - u) * at(row, column) + u * at(row, column + 1);
        return (1 - v) * lower + v * ((1 - u) * at(row + 1, column) + u * at(row + 1, column + 1));
    });
}

/**
 * How often its own length a wave wanders before the next takes over, at least; at most twice as often.
 * Over a longer way differences in speed would take a wave apart. Where the flow is half as fast it may take
 * twice as long, so slow places move too; where one time becomes the other, both waves have gone a whole
 * number of lengths, and there is no seam.
 */
const lengths = 8;
/** Pixels of a grain across the flow, at usual density; up to twice as much. */
const grainPx = 3;

/** Returns what a shared uniform says of the picture: larger grains in a unit of length at usual density,
 *  where 1 / gl_FragCoord.w is 1. */
export function grainsPerLength(projection: readonly number[], heightPx: number, pixelRatio: number): number {
    return (projection[5]! * heightPx) / (2 * grainPx * pixelRatio);
}

/** For the vertices: what the texture needs to know of the flow. */
export const flowVertexGlsl = `
// Where the noise begins: far from the origin of the data, coordinates have too few digits left.
uniform vec3 noiseFrom;
// In the frame of the noise: the place, the normal, the velocity along the surface, and how much of the
// texture is shown.
out vec3 noisePlace;
out vec3 noiseNormal;
out vec4 alongFlow;

// No plane of a grid lies along an axis of the noise.
const mat3 aslant = mat3(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6);

void placeInFlow(vec3 at, vec3 normalHere, vec3 velocity) {
    noisePlace = aslant * (at - noiseFrom);
    noiseNormal = aslant * normalHere;
    vec3 tangential = velocity - dot(velocity, normalHere) * normalHere;
    float whole = length(velocity);
    // Where the flow goes through the surface rather than along it there is no direction to show (Laramee et
    // al. 2004).
    alongFlow = vec4(aslant * tangential, whole > 0.0 ? smoothstep(0.1, 0.3, length(tangential) / whole) : 0.0);
}`;

export const flowTextureGlsl = `
in vec3 noisePlace;
in vec3 noiseNormal;
in vec4 alongFlow;
uniform float noiseScale;
#ifndef FLOWING
uniform sampler2DArray noise;
#else
uniform sampler2DArray waves;
// For how much simulation time it has flown: in data of several times, and where a field stands still.
uniform float flowTime;
uniform bool byItself;
uniform float flowed;

/** A parabola between its zeros: sin(2 pi x) and cos(2 pi x) within 6 %. */
vec4 onCircle(vec2 x) {
    vec4 y = 2.0 * fract(vec4(x, x + 0.25)).xzyw - 1.0;
    return 4.0 * y * (abs(y) - 1.0);
}

/**
 * The weights along the way are a wave, which wanders with the flow (Cabral and Leedom's animation). Two of
 * them take turns, each fading out before differences in speed have taken it apart.
 * @param grain under waves: of the larger size, and of the smaller @param often lengths of a wave in a unit
 * of time
 */
vec2 moved(vec4 grain, float often) {
    // The power of two below it, and how many times that it is.
    int bits = floatBitsToInt(often);
    float most = intBitsToFloat(bits & 0x7f800000) * ${(1 / lengths).toFixed(6)};
    float times = intBitsToFloat((bits & 0x007fffff) | 0x3f800000) * ${lengths}.0;
    vec2 passed = fract((byItself ? flowed : flowTime) * most + vec2(0.0, 0.5));
    float first = 1.0 - abs(2.0 * passed.x - 1.0);
    vec4 wave = onCircle(passed * times);
    vec2 weights = mix(wave.zw, wave.xy, first).yx * vec2(1.0, -1.0);
    return vec2(dot(grain.xy, weights), dot(grain.zw, weights));
}
#endif

/** Returns what is left of the colour. No branches: a software renderer takes both ways. */
float flowTexture(float facing) {
    // Of the three planes of the axes that which the surface lies in most.
    vec3 towards = abs(noiseNormal);
    bool first = towards.x > max(towards.y, towards.z);
    bool second = towards.y > towards.z;
    vec2 way = first ? alongFlow.yz : second ? alongFlow.zx : alongFlow.xy;
    vec2 at = first ? noisePlace.yz : second ? noisePlace.zx : noisePlace.xy;
    // Directions go half way round only.
    float side = way.y < 0.0 ? -1.0 : 1.0;
    float layer = ${directions / 2}.0 - ${directions / 2}.0 * side * way.x / (abs(way.x) + abs(way.y));
    // Of the grains wanted, the power of two below, and how many times that.
    int wanted = floatBitsToInt(noiseScale * lineDensity * gl_FragCoord.w);
    float density = intBitsToFloat(wanted & 0x7f800000);
    float finer = smoothstep(1.25, 1.6, intBitsToFloat((wanted & 0x007fffff) | 0x3f800000));
    vec3 place = vec3(at * density * ${(1 / noiseGrains).toFixed(8)}, layer);
#ifndef FLOWING
    vec2 grain = textureLod(noise, place, 0.0).rg - 0.5;
#else
    vec4 wave = textureLod(waves, place, 0.0) - 0.5;
    wave.yw *= side;
    vec2 grain = moved(wave, length(way) * density * ${(1 / waveGrains).toFixed(8)});
#endif
    // Seen edge-on, grains are finer than pixels.
    float shown = alongFlow.w * min(1.0, 4.0 * facing);
    return mix(1.0, 0.8 + 0.9 * mix(grain.x, grain.y, finer), shown);
}`;
