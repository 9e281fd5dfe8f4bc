// Where to put the numbers of an axis: round steps of 1, 2 or 5 times a power of ten.
import { labelForm } from './numbers.ts';

export interface Tick {
    value: number;
    label: string;
}

export interface Ticks {
    ticks: readonly Tick[];
    /** Holds what all labels share, said once: `×1e−6`, `+5.423e6`. Empty: nothing. */
    shared: string;
}

/** Ticks inside [low, high], about `wanted` of them, all with the same number of decimals. */
export function niceTicks(low: number, high: number, wanted: number): Ticks {
    if (!Number.isFinite(low) || !Number.isFinite(high) || !(high > low)) return { ticks: [], shared: '' };
    const step = niceStep((high - low) / Math.max(1, wanted));
    const { shared, label } = labelForm(low, high, step);
    const first = Math.ceil(low / step - 1e-9);
    const last = Math.floor(high / step + 1e-9);
    const ticks: Tick[] = [];
    for (let i = first; i <= last; ++i) ticks.push({ value: i * step, label: label(i * step) });
    return { ticks, shared };
}

/** The number of the form 1, 2 or 5 times 10^n nearest above or at `rough` within rounding. */
export function niceStep(rough: number): number {
    const exponent = Math.floor(Math.log10(rough));
    const mantissa = rough / 10 ** exponent;
    const digit = [1, 2, 5].find((each) => mantissa <= each * 1.000001) ?? 10;
    // As it would be typed: powers of ten below one are no exact numbers.
    return Number(`${digit}e${exponent}`);
}
