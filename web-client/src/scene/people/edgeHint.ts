// Where at the edge of the picture something is to be announced that lies outside it: on the way there from
// the middle, the shortest turn for what is behind the camera.
import { Vector3 } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint, View } from '../base/view.ts';

/** Says how far from the edges, in CSS pixels. */
export interface Insets {
    left: number;
    right: number;
    top: number;
    bottom: number;
}

export interface EdgeHint {
    at: ScreenPoint;
    /** Says how far along what the insets leave, from the left and from the top: words held there by the same
     *  share of theirs lie in it. */
    share: ScreenPoint;
    /** On the screen, to the right and down; of length 1. */
    towards: ScreenPoint;
}

/** Null for what is in the picture. REQUIRES: the middle of the picture lies between the insets. */
export function edgeHint(view: View, point: Vec3, { left, right, top, bottom }: Insets): EdgeHint | null {
    const { width, height } = view.size;
    const middle = { x: width / 2, y: height / 2 };
    const seen = view.project(point);
    if (seen !== null && seen.x >= 0 && seen.x <= width && seen.y >= 0 && seen.y <= height) return null;
    const towards = seen === null ? turnTo(view, point) : unit(seen.x - middle.x, seen.y - middle.y);
    const reach = Math.min(
        (middle.x - (towards.x < 0 ? left : right)) / Math.max(Math.abs(towards.x), 1e-9),
        (middle.y - (towards.y < 0 ? top : bottom)) / Math.max(Math.abs(towards.y), 1e-9),
    );
    const at = { x: middle.x + reach * towards.x, y: middle.y + reach * towards.y };
    const share = { x: (at.x - left) / (width - left - right), y: (at.y - top) / (height - top - bottom) };
    return { at, share, towards };
}

/** Behind the camera nothing is projected: which way to turn says where it is beside the line of sight. */
function turnTo(view: View, point: Vec3): ScreenPoint {
    const { x, y } = new Vector3(...point).applyMatrix4(view.camera.matrixWorldInverse);
    return unit(x, -y);
}

/** Exactly behind, any turn is as short: downwards. */
function unit(x: number, y: number): ScreenPoint {
    const length = Math.hypot(x, y);
    return length > 1e-9 ? { x: x / length, y: y / length } : { x: 0, y: 1 };
}

/** The arrow of eight that points there best. */
export function arrowTowards({ x, y }: ScreenPoint): string {
    const eighth = Math.round((Math.atan2(y, x) * 4) / Math.PI);
    return '→↘↓↙←↖↑↗'[(eighth + 8) % 8]!;
}
