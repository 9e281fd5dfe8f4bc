// Noise for the flow texture, smeared in advance (line integral convolution, Cabral and Leedom 1993, over so
// short a way that it is straight): once in each of many directions, all of the same noise, so that
// neighbours among them hardly differ. A pixel then needs one look-up, whatever the direction. It finds two
// sizes of grain, one half of the other, between which the texture can change over. What moves is the noise
// under two waves a quarter of a length apart, of which each other wave along the flow is a sum.

/** Larger grains along a side of what repeats, and numbers: a grain is as wide as four, or two, so that none
 *  is a stair. */
export const noiseGrains = 48;
export const noiseSize = 4 * noiseGrains;
/** Over half a turn; one more is the first one the other way round. The widest gap is 3.6 degrees. */
export const directions = 64;
/** Larger grains that a wave is long. It is as long where grains are smaller, so that one wave moves both. */
export const waveGrains = 5;
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
export function directionOf(layer: number): [number, number] {
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

/** Says how far away in the padded noise, and with what weight. */
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
