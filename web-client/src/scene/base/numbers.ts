// Numbers as the page writes them, the round ones of an axis, and the tolerance at the end of a range. What has a place in a range, as a
// coordinate or a time, is written as finely as the range and the step ask for, however large it is; what is a size of its own, as a speed,
// with four digits.

const minus = '\u2212';
/** Limits what is written without an exponent. */
const plainBelow = 1e6;
const leastPlain = 1e-3;
/** A number of more digits than these was computed, not typed. */
const typedDigits = 12;
/** Labels beside each other with more digits than this say what they share once. */
const maxDigits = 6;

/** A size of its own: four digits, and all of those before the point up to a million. */
export function shortNumber(value: number): string {
    if (!Number.isFinite(value)) return '–';
    const size = Math.abs(value);
    if (size !== 0 && (size >= plainBelow || size < leastPlain)) return signed(exponential(value, 3));
    const whole = size < 1 ? 1 : Math.floor(Math.log10(size)) + 1;
    return signed(String(Number(value.toPrecision(Math.max(4, whole)))));
}

/** Returns what a place in a range is written to: a thousandth of the range, or the step in it where that is
 *  finer. */
export function resolutionOf(low: number, high: number, step = Number.POSITIVE_INFINITY): number {
    return Math.min((high - low) / 1000, step);
}

/** The least difference of numbers that rise; infinite for fewer than two. */
export function finestStep(values: readonly number[]): number {
    let least = Number.POSITIVE_INFINITY;
    for (let i = 1; i < values.length; ++i) {
        const step = values[i]! - values[i - 1]!;
        if (step > 0 && step < least) least = step;
    }
    return least;
}

/** A place in a range, for reading. @param resolution of the range; without one, all digits are written */
export function placeNumber(value: number, resolution: number): string {
    if (!Number.isFinite(value)) return '–';
    return signed(rounded(value, resolution));
}

/** A value of a field: four digits, and as many more as the field's range asks for. An end of the range that
 *  is null is unknown. */
export function valueNumber(value: number, [low, high]: readonly (number | null)[] = []): string {
    const range = (high ?? Number.NaN) - (low ?? Number.NaN);
    if (!Number.isFinite(value) || value === 0 || !(range > 0)) return shortNumber(value);
    return placeNumber(value, Math.min(range / 1000, 10 ** (Math.floor(Math.log10(Math.abs(value))) - 3)));
}

/** Several places in the same range, as a span or a point. */
export function placeNumbers(values: readonly number[], resolution: number): string[] {
    return values.map((value) => placeNumber(value, resolution));
}

/**
 * For a field that one types into: what was typed stays as it was typed, what was computed is rounded a
 * hundred times as finely as for reading. Without a number, empty.
 */
export function fieldNumber(value: number, resolution: number): string {
    if (!Number.isFinite(value)) return '';
    const digits = String(value).replace(/e.*$/, '').replace(/[-.]/g, '').replace(/^0+/, '').length;
    if (digits > typedDigits) return rounded(value, resolution / 100);
    const size = Math.abs(value);
    return size !== 0 && size < leastPlain ? exponential(value, typedDigits) : String(value);
}

/** How labels along a line are written: what they share is said once. */
export interface LabelForm {
    /** Reads like `×1e-6 +0.1`: a label times this and this more is the number. Empty: labels are the
     *  numbers. */
    shared: string;
    label: (value: number) => string;
}

/** For labels that are multiples of `step` in [low, high]. */
export function labelForm(low: number, high: number, step: number): LabelForm {
    const furthest = Math.max(Math.abs(low), Math.abs(high));
    const range = high - low;
    let offset = 0;
    if (digitsOf(furthest, step) > maxDigits && furthest > 4 * range) {
        // What all of the range begins with.
        const power = 10 ** Math.ceil(Math.log10(range) - 1e-9);
        offset = Math.floor(low / power + 1e-9) * power;
    }
    const left = offset === 0 ? furthest : high - offset;
    const exponent = digitsOf(left, step) > maxDigits || left < leastPlain ? 3 * Math.floor(Math.log10(left) / 3 + 1e-9) : 0;
    const unit = Number(`1e${exponent}`);
    const decimals = decimalsOf(step / unit);
    const shared = [
        exponent === 0 ? '' : `×1e${signed(String(exponent))}`,
        offset === 0 ? '' : `${offset < 0 ? minus : '+'}${withoutSign(rounded(offset, range))}`,
    ];
    return {
        shared: shared.filter((each) => each !== '').join(' '),
        label: (value) => {
            const text = ((value - offset) / unit).toFixed(decimals);
            return Number(text) === 0 ? (0).toFixed(decimals) : signed(text);
        },
    };
}

/** Decimals with which multiples of a step are written. */
function decimalsOf(step: number): number {
    return Math.min(100, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
}

function digitsOf(size: number, step: number): number {
    const decimals = decimalsOf(step);
    const whole = size < 1 ? 1 : Math.floor(Math.log10(size) + 1e-9) + 1;
    return whole + decimals;
}

function rounded(value: number, resolution: number): string {
    if (!(resolution > 0) || !Number.isFinite(resolution)) return plain(Number(value.toPrecision(typedDigits)));
    const digitsAfter = -Math.floor(Math.log10(resolution) + 1e-9);
    const size = Math.abs(value);
    if (size < resolution / 2) return '0';
    const digits = Math.min(15, Math.max(0, Math.floor(Math.log10(size)) + digitsAfter));
    if (size < leastPlain || size >= 1e15) return exponential(value, digits);
    return digitsAfter > 0 ? plain(Number(value.toFixed(Math.min(100, digitsAfter)))) : plain(Math.round(value));
}

/** No exponent for what JavaScript writes without one, and none with a plus. */
function plain(value: number): string {
    const size = Math.abs(value);
    return size !== 0 && (size < leastPlain || size >= 1e15) ? exponential(value, typedDigits) : String(value);
}

function exponential(value: number, digits: number): string {
    const [mantissa = '', exponent = ''] = value.toExponential(Math.min(100, digits)).split('e');
    return `${Number(mantissa)}e${exponent.replace('+', '')}`;
}

function signed(text: string): string {
    return text.replaceAll('-', minus);
}

function withoutSign(text: string): string {
    const size = Math.abs(Number(text));
    // Round thousands read better by their power.
    return size >= plainBelow ? exponential(size, typedDigits) : text.replace(/^-/, '');
}

export interface Tick {
    value: number;
    label: string;
}

export interface Ticks {
    ticks: readonly Tick[];
    /** What all labels share, said once: `×1e−6`, `+5.423e6`. Empty: nothing. */
    shared: string;
}

/**
 * Round steps of 1, 2 or 5 times a power of ten. Ticks inside [low, high], about `wanted` of them, all with the same number of
 * decimals.
 */
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

/**
 * core/base/rounding.hpp gives the reason, and is the same for the server. Returns how far beyond an end of a range a number
 * still means that end.
 */
export function rounding(low: number, high: number): number {
    const roundings = 2 ** -22 * Math.max(Math.abs(low), Math.abs(high));
    return high > low ? Math.min(roundings, 1e-5 * (high - low)) : roundings;
}
