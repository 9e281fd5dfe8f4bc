// How a user wants the body to look: kept as surfaceLook.ts is.
import { changesFrom, colourMaps, type ColourMap, isFlag, isName, isOneOf, isSpan, readChanges } from './surfaceLook.ts';

export interface BodyLook {
    /** The flow along it is shown. */
    texture: boolean;
    /** As of a surface; 'constant': grey. */
    colourBy: string;
    /** Null: as the values ask for. */
    map: ColourMap | null;
    invert: boolean;
    /** Locked; null: from the least to the greatest on the body. */
    range: readonly [number, number] | null;
    /** Lines of equal values. */
    contours: boolean;
    /** Those that are other than usual (bodyPatches.ts). */
    patches: readonly string[];
}

const maxPatches = 300;

export const plainBody: BodyLook = {
    texture: false,
    colourBy: 'constant',
    map: null,
    invert: false,
    range: null,
    contours: false,
    patches: [],
};

const checks: Record<keyof BodyLook, (value: unknown) => boolean> = {
    texture: isFlag,
    colourBy: isName,
    map: (value) => value === null || isOneOf(colourMaps)(value),
    invert: isFlag,
    range: isSpan,
    contours: isFlag,
    patches: (value) => Array.isArray(value) && value.length <= maxPatches && value.every(isName),
};

/** Returns what differs from the usual, for a link or a bookmark. */
export function encodeBody(look: BodyLook): Partial<BodyLook> {
    return changesFrom(plainBody, look);
}

/** Never throws. */
export function decodeBody(value: unknown): BodyLook {
    return readChanges(plainBody, checks, value);
}
