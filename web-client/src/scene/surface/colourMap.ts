// From a number to a colour: tables of 256 sRGB entries and a range, and the numbers of the scalar bar. The same table fills the texture of
// the surface and the bar, so that they cannot disagree.
import { niceStep, niceTicks, shortNumber, type Tick, type Ticks } from '../base/numbers.ts';

/**
 * The viridis colour map of matplotlib (Smith, van der Walt; CC0): 256 sRGB colours, six hex digits each, from slow to fast.
 * Perceptually uniform, readable with the common colour vision deficiencies.
 */
const viridisHex =
    '44015444025645045745055946075a46085c460a5d460b5e470d60470e61471063471164471365481467481668' +
    '48176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677482878482979' +
    '472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882443983443a83443b84' +
    '433d84433e85423f854240864241864142874144874045884046883f47883f48893e49893e4a893e4c8a3d4d8a' +
    '3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c38598c375a8c375b8d365c8d365d8d' +
    '355e8d355f8d34608d34618d33628d33638d32648e32658e31668e31678e31688e30698e306a8e2f6b8e2f6c8e' +
    '2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e2b748e2b758e2a768e2a778e2a788e29798e297a8e' +
    '297b8e287c8e287d8e277e8e277f8e27808e26818e26828e26828e25838e25848e25858e24868e24878e23888e' +
    '23898e238a8d228b8d228c8d228d8d218e8d218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b' +
    '1f978b1f988b1f998a1f9a8a1e9b8a1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a486' +
    '21a58521a68522a78522a88423a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d' +
    '2eb37c2fb47c31b57b32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf70' +
    '46c06f48c16e4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f' +
    '65cb5e67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d549' +
    '89d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32addc30' +
    'b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11cd2e21bd5e21a' +
    'd8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61ef6e620f8e621fbe723' +
    'fde725';

/** Inferno and plasma of matplotlib (Smith, van der Walt; CC0), as tabulated in d3-scale-chromatic. Both grow brighter all the way. */
const infernoHex =
    '00000401000501010601010802010a02020c02020e03021004031204031405041706041907051b08051d09061f' +
    '0a07220b07240c08260d08290e092b10092d110a30120a32140b34150b37160b39180c3c190c3e1b0c411c0c43' +
    '1e0c451f0c48210c4a230c4c240c4f260c51280b53290b552b0b572d0b592f0a5b310a5c320a5e340a5f360961' +
    '3809623909633b09643d09653e0966400a67420a68440a68450a69470b6a490b6a4a0c6b4c0c6b4d0d6c4f0d6c' +
    '510e6c520e6d540f6d550f6d57106e59106e5a116e5c126e5d126e5f136e61136e62146e64156e65156e67166e' +
    '69166e6a176e6c186e6d186e6f196e71196e721a6e741a6e751b6e771c6d781c6d7a1d6d7c1d6d7d1e6d7f1e6c' +
    '801f6c82206c84206b85216b87216b88226a8a226a8c23698d23698f2469902568922568932667952667972766' +
    '9827669a28659b29649d29649f2a63a02a63a22b62a32c61a52c60a62d60a82e5fa92e5eab2f5ead305dae305c' +
    'b0315bb1325ab3325ab43359b63458b73557b93556ba3655bc3754bd3853bf3952c03a51c13a50c33b4fc43c4e' +
    'c63d4dc73e4cc83f4bca404acb4149cc4248ce4347cf4446d04545d24644d34743d44842d54a41d74b3fd84c3e' +
    'd94d3dda4e3cdb503bdd513ade5238df5337e05536e15635e25734e35933e45a31e55c30e65d2fe75e2ee8602d' +
    'e9612bea632aeb6429eb6628ec6726ed6925ee6a24ef6c23ef6e21f06f20f1711ff1731df2741cf3761bf37819' +
    'f47918f57b17f57d15f67e14f68013f78212f78410f8850ff8870ef8890cf98b0bf98c0af98e09fa9008fa9207' +
    'fa9407fb9606fb9706fb9906fb9b06fb9d07fc9f07fca108fca309fca50afca60cfca80dfcaa0ffcac11fcae12' +
    'fcb014fcb216fcb418fbb61afbb81dfbba1ffbbc21fbbe23fac026fac228fac42afac62df9c72ff9c932f9cb35' +
    'f8cd37f8cf3af7d13df7d340f6d543f6d746f5d949f5db4cf4dd4ff4df53f4e156f3e35af3e55df2e661f2e865' +
    'f2ea69f1ec6df1ed71f1ef75f1f179f2f27df2f482f3f586f3f68af4f88ef5f992f6fa96f8fb9af9fc9dfafda1' +
    'fcffa4';

const plasmaHex =
    '0d088710078813078916078a19068c1b068d1d068e20068f2206902406912605912805922a05932c05942e0595' +
    '2f059631059733059735049837049938049a3a049a3c049b3e049c3f049c41049d43039e44039e46039f48039f' +
    '4903a04b03a14c02a14e02a25002a25102a35302a35502a45601a45801a45901a55b01a55c01a65e01a66001a6' +
    '6100a76300a76400a76600a76700a86900a86a00a86c00a86e00a86f00a87100a87201a87401a87501a87701a8' +
    '7801a87a02a87b02a87d03a87e03a88004a88104a78305a78405a78606a68707a68808a68a09a58b0aa58d0ba5' +
    '8e0ca48f0da4910ea3920fa39410a29511a19613a19814a099159f9a169f9c179e9d189d9e199da01a9ca11b9b' +
    'a21d9aa31e9aa51f99a62098a72197a82296aa2395ab2494ac2694ad2793ae2892b02991b12a90b22b8fb32c8e' +
    'b42e8db52f8cb6308bb7318ab83289ba3388bb3488bc3587bd3786be3885bf3984c03a83c13b82c23c81c33d80' +
    'c43e7fc5407ec6417dc7427cc8437bc9447aca457acb4679cc4778cc4977cd4a76ce4b75cf4c74d04d73d14e72' +
    'd24f71d35171d45270d5536fd5546ed6556dd7566cd8576bd9586ada5a6ada5b69db5c68dc5d67dd5e66de5f65' +
    'de6164df6263e06363e16462e26561e26660e3685fe4695ee56a5de56b5de66c5ce76e5be76f5ae87059e97158' +
    'e97257ea7457eb7556eb7655ec7754ed7953ed7a52ee7b51ef7c51ef7e50f07f4ff0804ef1814df1834cf2844b' +
    'f3854bf3874af48849f48948f58b47f58c46f68d45f68f44f79044f79143f79342f89441f89540f9973ff9983e' +
    'f99a3efa9b3dfa9c3cfa9e3bfb9f3afba139fba238fca338fca537fca636fca835fca934fdab33fdac33fdae32' +
    'fdaf31fdb130fdb22ffdb42ffdb52efeb72dfeb82cfeba2cfebb2bfebd2afebe2afec029fdc229fdc328fdc527' +
    'fdc627fdc827fdca26fdcb26fccd25fcce25fcd025fcd225fbd324fbd524fbd724fad824fada24f9dc24f9dd25' +
    'f8df25f8e125f7e225f7e425f6e626f6e826f5e926f5eb27f4ed27f3ee27f3f027f2f227f1f426f1f525f0f724' +
    'f0f921';

type Triple = [number, number, number];

const ends: readonly [Triple, Triple] = [
    [59, 76, 192],
    [180, 4, 38],
];
const leastMiddle = 88;
/** Reference white of sRGB, D65. */
const white: Triple = [0.9505, 1, 1.089];

/**
 * Interpolates in Msh, which is CIELAB in polar coordinates, so that both ends are equally far from the middle (Moreland,
 * Diverging Color Maps for Scientific Visualization, ISVC 2009; his colours of both ends). sRGB, 0 .. 255 each, at 0 .. 1 of
 * the way.
 */
function coolToWarm(at: number): Triple {
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

export const tableSize = 256;
export const colourMapNames = ['viridis', 'cividis', 'inferno', 'plasma', 'coolToWarm', 'grey', 'turbo'] as const;
export type ColourMapName = (typeof colourMapNames)[number];
export type Range = readonly [number, number];

/** How colours follow values: evenly; by the square root of their size, with their sign, so that what is small is told apart; or by the
 *  logarithm. */
export type ColourScale = 'even' | 'root' | 'log';

export function scaleOf({ logarithmic, root }: { logarithmic: boolean; root: boolean }): ColourScale {
    return logarithmic ? 'log' : root ? 'root' : 'even';
}

/** What colours are even in. */
export function scaled(value: number, scale: ColourScale): number {
    if (scale === 'even') return value;
    return scale === 'log' ? Math.log(value) : Math.sign(value) * Math.sqrt(Math.abs(value));
}

/** More could not be told from none. */
export const mostBands = 32;

export function isBands(value: unknown): boolean {
    return value === 0 || (Number.isInteger(value) && (value as number) >= 2 && (value as number) <= mostBands);
}

/** The place in the map of what lies at a place, 0 .. 1, in the range: the same all over a band, from the first colour to the last. The
 *  shader has the same. @param bands  0: none */
export function banded(fraction: number, bands: number): number {
    return bands < 2 ? fraction : Math.min(Math.floor(fraction * bands), bands - 1) / (bands - 1);
}

type Rgb = [number, number, number];

/** What a logarithmic range reaches down to where it would begin at 0 or below, as a part of its upper
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

/** 256 x RGBA, 8 bits each, sRGB. @param bands  of one colour each; 0: none */
export function colourTable(name: ColourMapName = 'viridis', inverted = false, bands = 0): Uint8Array<ArrayBuffer> {
    const table = new Uint8Array(tableSize * 4);
    for (let i = 0; i < tableSize; ++i) {
        const seen = bands < 2 ? i : Math.round(banded((i + 0.5) / tableSize, bands) * (tableSize - 1));
        const from = inverted ? tableSize - 1 - seen : seen;
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
export function drawnRange([low, high]: Range, scale: ColourScale, centre: number | null): [number, number] {
    const logarithmic = scale === 'log';
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
export function fractionOf(value: number, [low, high]: Range, scale: ColourScale = 'even'): number {
    if (!(high > low)) return 0;
    if (scale === 'log' && !(value > 0)) return 0;
    const [at, from, to] = [value, low, high].map((each) => scaled(each, scale)) as [number, number, number];
    return Math.min(1, Math.max(0, (at - from) / (to - from)));
}

/** The value at a place in a range: fractionOf the other way round. */
export function valueAt(fraction: number, [low, high]: Range, scale: ColourScale): number {
    const [from, to] = [scaled(low, scale), scaled(high, scale)];
    const at = from + fraction * (to - from);
    if (scale === 'even') return at;
    return scale === 'log' ? Math.exp(at) : Math.sign(at) * at * at;
}

const parts = 10;

/**
 * Ends for the colours of a surface: its own least and greatest value, rounded outward. They depend on nothing but those, so
 * that every user sees the same colours, and small changes, as while it plays, leave them as they are.
 */
export function steadyRange(least: number, greatest: number): [number, number] {
    const step = niceStep((greatest - least) / parts);
    if (!(step > 0) || !Number.isFinite(step)) return [least, greatest];
    // As decimals: 3 * 0.1 is a little more than 0.3.
    const at = (steps: number): number => Number((steps * step).toPrecision(12));
    return [at(Math.floor(least / step + 1e-9)), at(Math.ceil(greatest / step - 1e-9))];
}

const steps: readonly (readonly number[])[] = [[1, 2, 5], [1, 3], [1]];

/** Round numbers, evenly or by powers of ten. */
export function colourTicks(low: number, high: number, scale: ColourScale, wanted: number): Ticks {
    if (scale === 'root') return spreadTicks(low, high, wanted);
    if (scale === 'even') return niceTicks(low, high, wanted);
    if (!(low > 0) || !(high > low)) return { ticks: [], shared: '' };
    const [first, last] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
    // Less than a power of ten: as if it were even.
    if (high / low < 5) return niceTicks(low, high, wanted);
    const apart = Math.max(1, Math.ceil((last - first) / wanted));
    const ticksOf = (factors: readonly number[]): Tick[] => {
        const ticks: Tick[] = [];
        for (let power = first; power <= last; power += apart) {
            for (const factor of factors) {
                const value = Number(`${factor}e${power}`);
                if (value >= low * 0.9999 && value <= high * 1.0001) ticks.push({ value, label: shortNumber(value) });
            }
        }
        return ticks;
    };
    return { ticks: steps.map(ticksOf).find((ticks) => ticks.length <= wanted + 1) ?? ticksOf([1]), shared: '' };
}

/** Round numbers, of which those near zero, where a root spreads most, stay and others go where they would be too near. */
function spreadTicks(low: number, high: number, wanted: number): Ticks {
    const { ticks, shared } = niceTicks(low, high, 2 * wanted);
    const kept: Tick[] = [];
    const apart = (a: Tick, b: Tick): number =>
        Math.abs(fractionOf(a.value, [low, high], 'root') - fractionOf(b.value, [low, high], 'root'));
    for (const tick of [...ticks].sort((a, b) => Math.abs(a.value) - Math.abs(b.value))) {
        if (kept.every((each) => apart(each, tick) > 0.8 / wanted)) kept.push(tick);
    }
    return { ticks: kept.sort((a, b) => a.value - b.value), shared };
}
