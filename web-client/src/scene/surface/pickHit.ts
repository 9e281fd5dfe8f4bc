// What picking finds under the pointer, and how it is asked.
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint } from '../base/view.ts';

export interface PickHit {
    /** Null: the body. */
    surface: string | null;
    point: Vec3;
    s: number;
    t: number;
    /** What the surface is coloured by. */
    scalar: number;
    /** From the eye; without perspective, from the plane of the camera. */
    distance: number;
}

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
