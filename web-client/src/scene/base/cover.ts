// Knows what lies over the picture at its lower right: the scalar bar. Numbers of the axes that would be
// under it are left out.
import type { ScreenPoint, ScreenSize } from './view.ts';

const marginPx = 12;

/** From the lower right of the picture. */
export interface Cover extends ScreenSize {
    right: number;
    bottom: number;
}

type Edges = Pick<DOMRect, 'right' | 'bottom' | 'width' | 'height'>;

/** Null: it is not there. Where it stands beside the picture, as on a phone, it lies over a figure all the
 *  same: in its corner. */
export function coverOf(picture: Edges, over: Edges): Cover | null {
    const { width, height } = over;
    if (width === 0 || height === 0) return null;
    const right = Math.max(marginPx, picture.right - over.right);
    return { right, bottom: Math.max(marginPx, picture.bottom - over.bottom), width, height };
}

/** The upper left of it in a picture of this size. */
export function placeOf({ right, bottom, width, height }: Cover, size: ScreenSize): ScreenPoint {
    return { x: size.width - right - width, y: size.height - bottom - height };
}

/** Returns whether words of which the middle is there would touch it. @param half  of their size */
export function isCovered(words: ScreenPoint, half: ScreenSize, cover: Cover, size: ScreenSize): boolean {
    const { x, y } = placeOf(cover, size);
    const beside = words.x + half.width < x || words.x - half.width > x + cover.width;
    return !beside && words.y + half.height > y && words.y - half.height < y + cover.height;
}
