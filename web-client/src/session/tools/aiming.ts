// From a place on the picture to a point in space: on the surface or body there, or else at a depth that makes sense.
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint, View } from '../../scene/base/view.ts';

export interface Aim {
    point: Vec3;
    /** Null: on the body, or in the open. */
    surface: string | null;
    /** Something is there. */
    hit: boolean;
}

export interface Sight {
    view: () => Pick<View, 'pointAtDepth'>;
    pick: (at: ScreenPoint) => { point: Vec3; surface: string | null } | null;
}

/** @param anchor in the open, the point is as far away as this one */
export function aim({ view, pick }: Sight, at: ScreenPoint, anchor: Vec3): Aim {
    const hit = pick(at);
    if (hit !== null) return { point: hit.point, surface: hit.surface, hit: true };
    return { point: view().pointAtDepth(at, anchor), surface: null, hit: false };
}
