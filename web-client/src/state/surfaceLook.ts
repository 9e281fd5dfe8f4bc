// How a user wants a surface to look: plain values, kept by this page alone, and by links and
// bookmarks. What comes back from those may be of strangers or of older versions; whatever is wrong in it
// becomes the usual.
import type { SurfaceRecord, ValueRange } from '../protocol/messages.ts';

export const colourMaps = ['viridis', 'cividis', 'inferno', 'plasma', 'coolToWarm', 'grey', 'turbo'] as const;
export type ColourMap = (typeof colourMaps)[number];
const lineKinds = ['none', 'timelines', 'streamlines', 'grid', 'checker'] as const;
export type LineKind = (typeof lineKinds)[number];
const pieceKinds = ['whole', 'timelines', 'seedlines', 'timeribbons', 'seedribbons', 'arrows'] as const;
export type PieceKind = (typeof pieceKinds)[number];
const backSides = ['shaded', 'same', 'tinted'] as const;
export type BackSide = (typeof backSides)[number];

/** Colours over what there is on the surface, or over what there is in all the data: the same at all times
 *  and on all surfaces. */
const rangesOf = ['surface', 'data'] as const;
export type RangeOf = (typeof rangesOf)[number];

type Pair = readonly [number, number];

export interface SurfaceLook {
    /** 'constant', 'speed', 'age', 's', what the server derives ('deformation', 'approximated', 'error', 'interval_error',
     *  'vorticity', 'q_criterion'), or 'field:' and the name of a field of the dataset. */
    colourBy: string;
    /** #rrggbb where `colourBy` is 'constant'; null: as the rake. */
    colour: string | null;
    map: ColourMap;
    invert: boolean;
    log: boolean;
    /** Colours follow the root of the values' size. */
    root: boolean;
    /** Of one colour each; 0: none. */
    bands: number;
    /** Locked; null: as `rangeOf` says. */
    range: Pair | null;
    rangeOf: RangeOf;
    /** The colours are symmetric round this value. */
    centre: number | null;
    backSide: BackSide;
    /** Discs at its vertices instead of its cells. */
    points: boolean;
    opacity: number;
    /** Thicker where it is seen edge-on, as a layer is. */
    angleOpacity: boolean;
    /** 0 .. 1: thinner the more it has been stretched and the older it is. */
    smoke: number;
    silhouettes: boolean;
    /** Marks where interpolating between stored times may put the surface off by more than the separation. */
    hatched: boolean;
    lines: LineKind;
    /** What is left of the surface: all, or lines, ribbons or arrows on it. */
    pieces: PieceKind;
    /** Lengths: from one to the next, and of ribbons and arrows' heads; null: as the dataset is large. */
    pieceEvery: number | null;
    pieceWidth: number | null;
    density: number;
    texture: boolean;
    animated: boolean;
    /** What of s and of the age is shown. */
    sWindow: Pair | null;
    ageWindow: Pair | null;
    /** Each names the part of the surface it lies on, by s and t. */
    hiddenParts: readonly Pair[];
    /** Smooth borders where it is torn. */
    trimmed: boolean;
    /** Cells are curved in pictures that stand still. */
    curved: boolean;
    /** Only what the brush has revealed is shown; the rest has opacity `faded`. */
    painting: boolean;
    faded: number;
}

export const usualLook: SurfaceLook = {
    colourBy: 'speed',
    colour: null,
    map: 'viridis',
    invert: false,
    log: false,
    root: false,
    bands: 0,
    range: null,
    rangeOf: 'surface',
    centre: null,
    backSide: 'shaded',
    points: false,
    opacity: 1,
    angleOpacity: false,
    smoke: 0,
    silhouettes: false,
    hatched: true,
    lines: 'none',
    pieces: 'whole',
    pieceEvery: null,
    pieceWidth: null,
    density: 1,
    texture: false,
    animated: false,
    sWindow: null,
    ageWindow: null,
    hiddenParts: [],
    trimmed: true,
    curved: false,
    painting: false,
    faded: 0,
};

const longestName = 200;
/** The number of hidden parts that links and bookmarks keep. */
export const maxHiddenParts = 64;

const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);
export const isFlag = (value: unknown): boolean => typeof value === 'boolean';
export const isName = (value: unknown): boolean => typeof value === 'string' && value !== '' && value.length <= longestName;
const isPart = (value: unknown): boolean => isNumber(value) && value >= 0 && value <= 1;
const isPair = (value: unknown): value is [number, number] => Array.isArray(value) && value.length === 2 && value.every(isNumber);
const isLength = (value: unknown): boolean => value === null || (isNumber(value) && value > 0);
export const isSpan = (value: unknown): boolean => value === null || (isPair(value) && value[0] <= value[1]);
export const isOneOf =
    (values: readonly string[]) =>
    (value: unknown): boolean =>
        values.includes(value as string);

const checks: Record<keyof SurfaceLook, (value: unknown) => boolean> = {
    colourBy: isName,
    colour: (value) => value === null || (typeof value === 'string' && /^#[0-9a-f]{6}$/i.test(value)),
    map: isOneOf(colourMaps),
    invert: isFlag,
    log: isFlag,
    root: isFlag,
    bands: (value) => value === 0 || (isNumber(value) && Number.isInteger(value) && value >= 2 && value <= 32),
    range: isSpan,
    rangeOf: isOneOf(rangesOf),
    centre: (value) => value === null || isNumber(value),
    backSide: isOneOf(backSides),
    points: isFlag,
    opacity: isPart,
    angleOpacity: isFlag,
    smoke: isPart,
    silhouettes: isFlag,
    hatched: isFlag,
    lines: isOneOf(lineKinds),
    pieces: isOneOf(pieceKinds),
    pieceEvery: isLength,
    pieceWidth: isLength,
    density: (value) => isNumber(value) && value >= 0.125 && value <= 8,
    texture: isFlag,
    animated: isFlag,
    sWindow: isSpan,
    ageWindow: isSpan,
    hiddenParts: (value) => Array.isArray(value) && value.length <= maxHiddenParts && value.every(isPair),
    trimmed: isFlag,
    curved: isFlag,
    painting: isFlag,
    faded: isPart,
};

/** Returns what differs from the usual, for a link or a bookmark. */
export function encodeLook(look: SurfaceLook): Partial<SurfaceLook> {
    return changesFrom(usualLook, { ...look, hiddenParts: look.hiddenParts.slice(0, maxHiddenParts) });
}

export function changesFrom<Look extends object>(usual: Look, look: Look): Partial<Look> {
    const differs = (name: keyof Look): boolean => JSON.stringify(look[name]) !== JSON.stringify(usual[name]);
    return Object.fromEntries(Object.entries(look).filter(([name]) => differs(name as keyof Look))) as Partial<Look>;
}

/** Never throws. */
export function decodeLook(value: unknown): SurfaceLook {
    return readChanges(usualLook, checks, value);
}

export function readChanges<Look extends object>(
    usual: Look,
    isRight: Record<keyof Look, (value: unknown) => boolean>,
    value: unknown,
): Look {
    if (typeof value !== 'object' || value === null) return usual;
    const given = Object.entries(value).filter(
        ([name, each]) => Object.hasOwn(isRight, name) && isRight[name as keyof Look](each),
    );
    return { ...usual, ...Object.fromEntries(given) };
}

/** What colours stand for where no user has said it. Is the range of one field, on some surfaces. */
export interface AutomaticRange extends Omit<ValueRange, 'attribute'> {
    surfaces: number;
}

/** By meaningOf(). */
export type AutomaticRanges = ReadonlyMap<string, AutomaticRange>;

/** Surfaces whose colours mean the same have the same name here. Across a patch age is not what it is
 *  elsewhere. */
export function meaningOf({ colourBy }: SurfaceLook, { kind }: Pick<SurfaceRecord, 'kind'>): string {
    return colourBy === 'age' && kind === 'time' ? 'patch' : colourBy;
}
