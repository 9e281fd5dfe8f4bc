// Words over the picture: DOM text, sharp at any size and readable by assistive tools, in elements that are used again from frame to frame,
// because text is costly to lay out; and the part of the picture at its lower right that the scalar bar covers, where the numbers of axes
// are left out.
import type { ScreenPoint, ScreenSize } from './view.ts';

/** The middle of the words is there, or their beginning. */
const centred: ScreenPoint = { x: 0.5, y: 0.5 };
export const beside: ScreenPoint = { x: 0, y: 0 };

export class Labels {
    private readonly layer: HTMLElement;
    private readonly pool: HTMLElement[] = [];
    private used = 0;

    /** @param layer lies over the canvas */
    constructor(layer: HTMLElement) {
        this.layer = layer;
    }

    /** All are placed again. */
    begin(): void {
        this.used = 0;
    }

    /** @param anchor what of the words is at the canvas position `at`: a share of their width and height */
    place(at: ScreenPoint, text: string, className: string, anchor: ScreenPoint = centred): HTMLElement {
        const label = this.next();
        if (label.textContent !== text) label.textContent = text;
        if (label.className !== className) label.className = className;
        const [x, y] = [at.x.toFixed(1), at.y.toFixed(1)];
        const [left, up] = [(-100 * anchor.x).toFixed(1), (-100 * anchor.y).toFixed(1)];
        label.style.transform = `translate(${left}%, ${up}%) translate(${x}px, ${y}px)`;
        label.hidden = false;
        return label;
    }

    end(): void {
        for (const label of this.pool.slice(this.used)) {
            label.hidden = true;
            label.textContent = '';
        }
    }

    dispose(): void {
        for (const label of this.pool) label.remove();
    }

    private next(): HTMLElement {
        const existing = this.pool[this.used++];
        if (existing !== undefined) return existing;
        const label = document.createElement('span');
        this.pool.push(label);
        this.layer.append(label);
        return label;
    }
}

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
