// From a place on the picture to a point in space: of what is seen there, which is a surface, the body, a
// rake or the disc of a round one. In the open there is no such point, because a picture has no depth there.
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint } from '../../scene/base/view.ts';

export interface Aim {
    point: Vec3;
    /** Null: on the body, or a rake. */
    surface: string | null;
}

export interface Sight {
    pick: (at: ScreenPoint) => { point: Vec3; surface: string | null } | null;
    /** The place of a rake under a canvas position. */
    rakeAt: (at: ScreenPoint) => Vec3 | null;
}

export const nothingThere = 'There is nothing under the pointer. Point at a surface, the body or a rake.';

/** Null where nothing can be seen. */
export function aim({ pick, rakeAt }: Sight, at: ScreenPoint): Aim | null {
    const hit = pick(at);
    if (hit !== null) return { point: hit.point, surface: hit.surface };
    const onRake = rakeAt(at);
    return onRake === null ? null : { point: onRake, surface: null };
}
