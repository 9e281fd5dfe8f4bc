// How much of a surface has which value: parts of its area, in bins that are equally wide on the scale of the colours.
import type { WeighedValues } from '../../scene/surface/weighedValues.ts';
import { type ColourScale, scaled } from '../../scene/surface/colourMap.ts';

export interface Histogram {
    /** What the first and the last bin end at. */
    span: readonly [number, number];
    /** Of the area that has values, all together at most 1. */
    parts: readonly number[];
}

/** Null: there are no values; of a logarithm, none above zero. */
export function spanOfValues({ values }: WeighedValues, scale: ColourScale): [number, number] | null {
    let [low, high] = [Infinity, -Infinity];
    for (const value of values) {
        if (scale === 'log' && !(value > 0)) continue;
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    return low <= high ? [low, high] : null;
}

export function histogramOf(
    { values, weights }: WeighedValues,
    [low, high]: readonly [number, number],
    scale: ColourScale,
    bins: number,
): Histogram {
    const [from, to] = [scaled(low, scale), scaled(high, scale)];
    const parts = new Array<number>(bins).fill(0);
    const all = weights.reduce((sum, each) => sum + each, 0);
    values.forEach((value, i) => {
        const at = to > from ? (scaled(value, scale) - from) / (to - from) : 0;
        // Also of what has no logarithm.
        if (!(at >= 0) || at > 1) return;
        parts[Math.min(bins - 1, Math.floor(at * bins))]! += weights[i]! / all;
    });
    return { span: [low, high], parts };
}
