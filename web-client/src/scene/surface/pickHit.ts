// What picking finds under the pointer, and how it is asked.
import type { ScreenPoint, SeenPoint } from '../base/view.ts';

export interface PickHit extends SeenPoint {
    /** Null: the body, or what else is no surface, which has no s, t and scalar. */
    surface: string | null;
    s: number;
    t: number;
    /** What the surface is coloured by. */
    scalar: number;
}

export const noSurface = { surface: null, s: NaN, t: NaN, scalar: NaN };

export interface PickOptions {
    /** Also what the painter has hidden. */
    throughPaint?: boolean;
}

/** All hits of a square, by rows from its top left; null where there is nothing. */
export interface PickGrid {
    /** Canvas position of the centre of the first. */
    corner: ScreenPoint;
    size: number;
    hits: (PickHit | null)[];
}
