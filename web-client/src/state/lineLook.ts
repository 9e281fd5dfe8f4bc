// How a user wants streamlines to look: kept as surfaceLook.ts is.
import { changesFrom, readChanges } from './surfaceLook.ts';

export interface LineLook {
    /** In pixels. */
    width: number;
}

export const [thinnest, thickest] = [1, 8];

export const plainLines: LineLook = { width: 3 };

const checks: Record<keyof LineLook, (value: unknown) => boolean> = {
    width: (value) => typeof value === 'number' && value >= thinnest && value <= thickest,
};

/** Returns what differs from the usual, for a link or a bookmark. */
export function encodeLines(look: LineLook): Partial<LineLook> {
    return changesFrom(plainLines, look);
}

/** Never throws. */
export function decodeLines(value: unknown): LineLook {
    return readChanges(plainLines, checks, value);
}
