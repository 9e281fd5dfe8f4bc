// From a number to a colour: tables of 256 sRGB entries and a range. The same table fills the texture of the
// surface and the scalar bar, so that they cannot disagree.
import { coolToWarm } from './coolToWarm.ts';
import { infernoHex, plasmaHex } from './infernoPlasma.ts';
import { viridisHex } from './viridis.ts';

export const tableSize = 256;
export const colourMapNames = ['viridis', 'cividis', 'inferno', 'plasma', 'coolToWarm', 'grey', 'turbo'] as const;
export type ColourMapName = (typeof colourMapNames)[number];
export type Range = readonly [number, number];

type Rgb = [number, number, number];

/** Holds what a logarithmic range reaches down to where it would begin at 0 or below, as a part of its upper
 *  end. */
const leastLogarithmic = 1e-3;

const coloursOf: Record<ColourMapName, (i: number) => Rgb> = {
    viridis: (i) => fromHex(viridisHex, i),
    inferno: (i) => fromHex(infernoHex, i),
    plasma: (i) => fromHex(plasmaHex, i),
    cividis: (i) => polynomials(i, cividisCoefficients),
    turbo: (i) => polynomials(i, turboCoefficients),
    coolToWarm: (i) => coolToWarm(i / (tableSize - 1)),
    // Not to black and white: folds would drown in them.
    grey: (i) => [0, 1, 2].map(() => Math.round(40 + (205 * i) / (tableSize - 1))) as Rgb,
};

/** Cividis (Nunez, Anderton, Renslow, 2018) and Turbo (Mikhailov, Google, 2019), both as the polynomials of
 *  d3-scale-chromatic (ISC). */
const cividisCoefficients = [
    [-4.54, -35.34, 2381.73, -6402.7, 7024.72, -2710.57],
    [32.49, 170.73, 52.82, -131.46, 176.58, -67.37],
    [81.24, 442.36, -2482.43, 6167.24, -6614.94, 2475.67],
];
const turboCoefficients = [
    [34.61, 1172.33, -10793.56, 33300.12, -38394.49, 14825.05],
    [23.31, 557.33, 1225.33, -3574.96, 1073.77, 707.56],
    [27.2, 3211.1, -15327.97, 27814, -22569.18, 6838.66],
];

/** 256 x RGBA, 8 bits each, sRGB. */
export function colourTable(name: ColourMapName = 'viridis', inverted = false): Uint8Array<ArrayBuffer> {
    const table = new Uint8Array(tableSize * 4);
    for (let i = 0; i < tableSize; ++i) {
        const from = inverted ? tableSize - 1 - i : i;
        table.set([...coloursOf[name](from), 255], 4 * i);
    }
    return table;
}

function fromHex(hex: string, i: number): Rgb {
    const value = Number.parseInt(hex.slice(6 * i, 6 * i + 6), 16);
    return [value >> 16, (value >> 8) & 255, value & 255];
}

function polynomials(i: number, coefficients: readonly (readonly number[])[]): Rgb {
    const x = i / (tableSize - 1);
    const value = (of: readonly number[]): number => of.reduceRight((sum, factor) => sum * x + factor, 0);
    return coefficients.map((of) => Math.max(0, Math.min(255, Math.round(value(of))))) as Rgb;
}

/** The range that is drawn: made symmetric, or fit for logarithms, and never empty. */
export function drawnRange([low, high]: Range, logarithmic: boolean, centre: number | null): [number, number] {
    if (!Number.isFinite(low) || !Number.isFinite(high)) return logarithmic ? [0.1, 1] : [0, 1];
    if (logarithmic) {
        const top = high > 0 ? high : 1;
        const bottom = low > 0 && low < top ? low : top * leastLogarithmic;
        return [bottom, top];
    }
    if (centre !== null) {
        const half = Math.max(Math.abs(high - centre), Math.abs(low - centre)) || 1;
        return [centre - half, centre + half];
    }
    return high > low ? [low, high] : [low, low + (Math.abs(low) || 1)];
}

/** Position 0 .. 1 of a value in a range; values outside stick to the ends, and those without a logarithm to
 *  the lower one. */
export function fractionOf(value: number, [low, high]: Range, logarithmic = false): number {
    if (!(high > low)) return 0;
    const scaled = (each: number): number => (logarithmic ? Math.log(each) : each);
    if (logarithmic && !(value > 0)) return 0;
    return Math.min(1, Math.max(0, (scaled(value) - scaled(low)) / (scaled(high) - scaled(low))));
}
