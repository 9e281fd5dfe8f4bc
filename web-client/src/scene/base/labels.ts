// Words over the picture: DOM text, sharp at any size and readable by assistive tools. Elements are used
// again from frame to frame, because text is costly to lay out.
import type { ScreenPoint } from './view.ts';

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
