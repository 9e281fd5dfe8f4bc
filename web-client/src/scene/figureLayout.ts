// Lays a figure out: in pixels of CSS, like a page of its shape, so that text, lines and handles have their
// share of it and can be read, however small the figure or the page is.
import type { Cover } from './base/cover.ts';
import type { ScreenSize } from './base/view.ts';

/** In pixels of CSS: a number of an axis, 12 of them high, has a sixtieth to a thirtieth of the height of a
 *  figure. */
const [lowest, tallest] = [360, 720];
/** Less where it is narrow, so that the scalar bar, 288 wide, has room. */
const narrowest = 360;
/** Pixels of the figure for one of CSS, at least, so that such a number has nine. */
const leastRatio = 0.75;
/** Limits the bar to parts of the width and of the height; more would hide what it is about. */
const barAtMost = { width: 0.95, height: 0.4 };

export interface FigureLayout extends ScreenSize {
    /** Pixels of the figure for one of CSS. */
    pixelRatio: number;
}

/** @param pageHeight of the picture on the page: where it can be, a figure is as tall */
export function layoutOf({ width, height }: ScreenSize, pageHeight: number): FigureLayout {
    const asTall = height / Math.min(tallest, Math.max(lowest, pageHeight));
    const pixelRatio = Math.max(leastRatio, Math.min(asTall, width / narrowest));
    return { width: width / pixelRatio, height: height / pixelRatio, pixelRatio };
}

/** The bar's place in it, which is that on the page as far as it can be; null: there is no room. */
export function barIn({ width, height }: ScreenSize, bar: Cover): Cover | null {
    if (bar.width > barAtMost.width * width || bar.height > barAtMost.height * height) return null;
    return {
        ...bar,
        right: Math.min(bar.right, (width - bar.width) / 2),
        bottom: Math.min(bar.bottom, (height - bar.height) / 2),
    };
}
