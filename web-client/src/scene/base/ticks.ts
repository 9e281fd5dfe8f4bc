// Where to put the numbers of an axis: round steps of 1, 2 or 5 times a power of ten.

export interface Tick {
    value: number;
    label: string;
}

/** Ticks inside [low, high], about `wanted` of them, all with the same number of decimals. */
export function niceTicks(low: number, high: number, wanted: number): Tick[] {
    if (!Number.isFinite(low) || !Number.isFinite(high) || !(high > low)) return [];
    const step = niceStep((high - low) / Math.max(1, wanted));
    const first = Math.ceil(low / step - 1e-9);
    const last = Math.floor(high / step + 1e-9);
    const ticks: Tick[] = [];
    for (let i = first; i <= last; ++i) ticks.push({ value: i * step, label: label(i * step, step) });
    return ticks;
}

/** The number of the form 1, 2 or 5 times 10^n nearest above or at `rough` within rounding. */
export function niceStep(rough: number): number {
    const power = 10 ** Math.floor(Math.log10(rough));
    const mantissa = rough / power;
    if (mantissa <= 1.000001) return power;
    if (mantissa <= 2.000001) return 2 * power;
    if (mantissa <= 5.000001) return 5 * power;
    return 10 * power;
}

function label(value: number, step: number): string {
    const size = Math.max(Math.abs(value), step);
    if (size >= 1e6 || step < 1e-4) return value === 0 ? '0' : value.toExponential(1);
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const text = value.toFixed(decimals);
    return Number(text) === 0 ? (0).toFixed(decimals) : text.replace('-', '\u2212');
}

/** A number for people: four significant digits, no trailing noise. */
export function shortNumber(value: number): string {
    if (!Number.isFinite(value)) return '–';
    const size = Math.abs(value);
    if (size !== 0 && (size >= 1e6 || size < 1e-3)) return value.toExponential(3);
    return String(Number(value.toPrecision(4))).replace('-', '\u2212');
}
