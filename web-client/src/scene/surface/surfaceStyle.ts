// How one surface is to be drawn, with everything resolved that the shader cannot know.
import type { ColourMapName } from './colourMap.ts';

/** Where the number behind the colour comes from; 'scalar': from the server, the others are made from s and
 *  t. */
export type ColourSource = 'constant' | 'scalar' | 's' | 'age';
export type LinePattern = 'none' | 'timelines' | 'streamlines' | 'grid' | 'checker';
/** All of a surface, or what is left of it. */
export type Pieces = 'whole' | 'timelines' | 'seedlines' | 'timeribbons' | 'seedribbons' | 'arrows';
export type BackSide = 'shaded' | 'same' | 'tinted';

export interface SurfaceStyle {
    source: ColourSource;
    /** Name of the attribute where `source` is 'scalar'. */
    scalar: string;
    /** #rrggbb */
    colour: string;
    map: ColourMapName;
    inverted: boolean;
    logarithmic: boolean;
    /** By the square root of the values' size; without effect where it is logarithmic. */
    root: boolean;
    /** Of one colour each; 0: none. */
    bands: number;
    /** Null: from the least to the greatest that there is. */
    range: readonly [number, number] | null;
    /** Whose range that is, for people. */
    rangeOf: 'surface' | 'surfaces' | 'data' | 'locked' | 'film';
    /** The least and the greatest value that lie below and above the range, for people; null: none does. */
    beyond: readonly [number | null, number | null];
    /** The range is made symmetric round this value. */
    centre: number | null;
    backSide: BackSide;
    /** Age is what has passed since t (streak surfaces), or t itself. */
    tIsRelease: boolean;
    /** Where stripes begin. */
    tOrigin: number;
    /** Discs at the vertices instead of the cells; nothing is seen through them. */
    points: boolean;
    opacity: number;
    angleOpacity: boolean;
    /** 0 .. 1: how much stretching and age thin the surface out. */
    smoke: number;
    /** Nothing was refined: smoke hides what the grid cannot resolve. */
    fixedGrid: boolean;
    /** Area that the rake sweeps per unit of s and t as it releases; the measure of stretching where that is
     *  not sent. */
    areaPerSeed: number;
    silhouettes: boolean;
    /** Hatched where the error between stored times is larger, or not known; null: nowhere. */
    hatchAbove: number | null;
    lines: LinePattern;
    pieces: Pieces;
    /** Lengths: from one piece to the next, and of ribbons and of arrows' heads. */
    pieceEvery: number;
    pieceWidth: number;
    /** Beside the last column lies the first. */
    rakeCloses: boolean;
    /** Stripes and texture: 1 as usual, 2 twice as many. */
    density: number;
    texture: boolean;
    /** Whether it moves: with the time that is shown, since `from`; or by itself, in a field that stands
     *  still. */
    textureMoves: 'no' | 'withTime' | 'byItself';
    /** When the surface begins. */
    from: number;
    sWindow: readonly [number, number] | null;
    ageWindow: readonly [number, number] | null;
    painting: boolean;
    /** Opacity of what is not revealed by painting. */
    faded: number;
}

export const plainStyle: SurfaceStyle = {
    source: 'scalar',
    scalar: 'speed',
    colour: '#7fb2d9',
    map: 'viridis',
    inverted: false,
    logarithmic: false,
    root: false,
    bands: 0,
    range: null,
    rangeOf: 'surface',
    beyond: [null, null],
    centre: null,
    backSide: 'shaded',
    tIsRelease: false,
    tOrigin: 0,
    points: false,
    opacity: 1,
    angleOpacity: false,
    smoke: 0,
    fixedGrid: false,
    areaPerSeed: 1,
    silhouettes: false,
    hatchAbove: null,
    lines: 'none',
    pieces: 'whole',
    pieceEvery: 1,
    pieceWidth: 1,
    rakeCloses: false,
    density: 1,
    texture: false,
    textureMoves: 'no',
    from: 0,
    sWindow: null,
    ageWindow: null,
    painting: false,
    faded: 0,
};

/** Returns whether something behind the surface may be seen through it. */
export function isTransparent({ opacity, angleOpacity, smoke, painting, faded }: SurfaceStyle): boolean {
    return opacity < 1 || angleOpacity || smoke > 0 || (painting && faded > 0);
}

/** Returns whether only colour, light and the flow texture make the picture, which is drawn more quickly
 *  then. */
export function isPlain({ silhouettes, lines, pieces, sWindow, ageWindow, painting }: SurfaceStyle): boolean {
    return !silhouettes && lines === 'none' && pieces === 'whole' && sWindow === null && ageWindow === null && !painting;
}
