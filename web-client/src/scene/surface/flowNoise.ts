// Grain for the flow texture: white noise in a square that repeats, one grain a pixel.

export const noiseSize = 256;

export function flowNoise(): Uint8Array<ArrayBuffer> {
    const grains = new Uint8Array(noiseSize ** 2);
    let state = 12345;
    for (let i = 0; i < grains.length; ++i) {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        grains[i] = state >>> 24;
    }
    return grains;
}
