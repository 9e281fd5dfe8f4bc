// From a scalar to a colour: a table of 256 sRGB entries and a range. The same table fills the
// texture of the surface and the scalar bar, so that they cannot disagree.
import { viridisHex } from './viridis.ts';

export const tableSize = 256;

/** 256 x RGBA, 8 bits each, sRGB. */
export function colorTable(): Uint8Array<ArrayBuffer> {
    const table = new Uint8Array(tableSize * 4);
    for (let i = 0; i < tableSize; ++i) {
        for (let channel = 0; channel < 3; ++channel) {
            const at = i * 6 + channel * 2;
            table[i * 4 + channel] = Number.parseInt(viridisHex.slice(at, at + 2), 16);
        }
        table[i * 4 + 3] = 255;
    }
    return table;
}

/** Position 0..1 of a value in a range; values outside stick to the ends. */
export function fractionOf(value: number, range: readonly [number, number]): number {
    const [low, high] = range;
    if (!(high > low)) return 0;
    return Math.min(1, Math.max(0, (value - low) / (high - low)));
}
