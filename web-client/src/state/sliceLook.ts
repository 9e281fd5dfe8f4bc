// How a user wants slices to look: kept as surfaceLook.ts is.
import { changesFrom, isFlag, readChanges } from './surfaceLook.ts';

export interface SliceLook {
    /** Lines of equal values, between which the range of colours is divided evenly; 0: none. */
    contours: number;
    /** Arrows show the flow in the plane. */
    arrows: boolean;
}

export const mostContours = 40;

export const plainSlices: SliceLook = { contours: 0, arrows: false };

const checks: Record<keyof SliceLook, (value: unknown) => boolean> = {
    contours: (value) => Number.isInteger(value) && (value as number) >= 0 && (value as number) <= mostContours,
    arrows: isFlag,
};

/** Returns what differs from the usual, for a link or a bookmark. */
export function encodeSlices(look: SliceLook): Partial<SliceLook> {
    return changesFrom(plainSlices, look);
}

/** Never throws. */
export function decodeSlices(value: unknown): SliceLook {
    return readChanges(plainSlices, checks, value);
}
