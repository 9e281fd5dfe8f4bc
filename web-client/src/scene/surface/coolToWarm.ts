// From blue over light grey to red: for quantities with a sign, or round a value. Interpolates in Msh, which
// is CIELAB in polar coordinates, so that both ends are equally far from the middle. Source: Moreland,
// Diverging Color Maps for Scientific Visualization, ISVC 2009; his colours of both ends.

type Triple = [number, number, number];

const ends: readonly [Triple, Triple] = [
    [59, 76, 192],
    [180, 4, 38],
];
const leastMiddle = 88;
/** Reference white of sRGB, D65. */
const white: Triple = [0.9505, 1, 1.089];

/** sRGB, 0 .. 255 each, at 0 .. 1 of the way. */
export function coolToWarm(at: number): Triple {
    let [low, high] = [toMsh(ends[0]), toMsh(ends[1])];
    const middle = Math.max(low[0], high[0], leastMiddle);
    let fraction: number;
    if (at < 0.5) {
        high = [middle, 0, hueToWhite(low, middle)];
        fraction = 2 * at;
    } else {
        low = [middle, 0, hueToWhite(high, middle)];
        fraction = 2 * at - 1;
    }
    return fromMsh([0, 1, 2].map((i) => low[i]! + fraction * (high[i]! - low[i]!)) as Triple);
}

/** White has no hue: which one it is approached with, so that the way there bends as little as it can. */
function hueToWhite([m, s, h]: Triple, middle: number): number {
    if (m >= middle) return h;
    const spin = (s * Math.sqrt(middle * middle - m * m)) / (m * Math.sin(s));
    return h > -Math.PI / 3 ? h + spin : h - spin;
}

function toMsh(rgb: Triple): Triple {
    const [r, g, b] = rgb.map((c) => linear(c / 255)) as Triple;
    const xyz = [
        0.4124 * r + 0.3576 * g + 0.1805 * b,
        0.2126 * r + 0.7152 * g + 0.0722 * b,
        0.0193 * r + 0.1192 * g + 0.9505 * b,
    ];
    const [x, y, z] = xyz.map((c, i) => labCurve(c / white[i]!)) as Triple;
    const [L, A, B] = [116 * y - 16, 500 * (x - y), 200 * (y - z)];
    const m = Math.hypot(L, A, B);
    return [m, Math.acos(L / m), Math.atan2(B, A)];
}

function fromMsh([m, s, h]: Triple): Triple {
    const [L, A, B] = [m * Math.cos(s), m * Math.sin(s) * Math.cos(h), m * Math.sin(s) * Math.sin(h)];
    const y = (L + 16) / 116;
    const [X, Y, Z] = [y + A / 500, y, y - B / 200].map((c, i) => white[i]! * labCurveBack(c)) as Triple;
    const rgb = [3.2406 * X - 1.5372 * Y - 0.4986 * Z, -0.9689 * X + 1.8758 * Y + 0.0415 * Z, 0.0557 * X - 0.204 * Y + 1.057 * Z];
    return rgb.map((c) => Math.round(255 * Math.min(1, Math.max(0, encoded(c))))) as Triple;
}

function labCurve(v: number): number {
    return v > 0.008856 ? Math.cbrt(v) : 7.787 * v + 16 / 116;
}

function labCurveBack(v: number): number {
    return v > 0.2069 ? v ** 3 : (v - 16 / 116) / 7.787;
}

function linear(c: number): number {
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
}

function encoded(c: number): number {
    return c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055;
}
