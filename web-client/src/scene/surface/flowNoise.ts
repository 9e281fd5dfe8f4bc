// Grain for the flow texture: noise that repeats, 64 grains across (s) and 16 along (t), smeared along t as line integral
// convolution would leave it (Cabral and Leedom 1993).

export const noiseSize = 128;
const smear = 8;

export function flowNoise(): Uint8Array<ArrayBuffer> {
    const grains = new Float32Array(noiseSize * noiseSize);
    let state = 12345;
    for (let row = 0; row < noiseSize; ++row) {
        for (let column = 0; column < noiseSize; column += 2) {
            state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
            grains.fill(state / 2 ** 32, row * noiseSize + column, row * noiseSize + column + 2);
        }
    }
    const smeared = grains.map((_, i) => {
        const [row, column] = [Math.floor(i / noiseSize), i % noiseSize];
        let sum = 0;
        for (let step = -smear; step <= smear; ++step) {
            const weight = 1 - Math.abs(step) / (smear + 1);
            sum += weight * grains[((row + step + noiseSize) % noiseSize) * noiseSize + column]!;
        }
        return sum;
    });
    const [low, high] = smeared.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]);
    return Uint8Array.from(smeared, (v) => (255 * (v - low)) / (high - low));
}
