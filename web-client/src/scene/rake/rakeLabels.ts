// Words beside rakes: who holds one, what a dragged handle is held to. DOM text over the canvas, like the numbers of the axes.
import type { ScreenPoint } from '../view.ts';

export interface RakeLabel {
    at: ScreenPoint;
    words: string;
    color: string;
}

/** Clear of the handle and of the finger on it. */
const clearancePx = { x: 18, y: 34 };

export class RakeLabels {
    private readonly layer: HTMLElement;
    private readonly pool: HTMLElement[] = [];

    constructor(layer: HTMLElement) {
        this.layer = layer;
    }

    show(labels: readonly RakeLabel[]): void {
        labels.forEach((label, i) => this.place(this.pool[i] ?? this.create(), label));
        for (const unused of this.pool.slice(labels.length)) if (!unused.hidden) unused.hidden = true;
    }

    private place(element: HTMLElement, { at, words, color }: RakeLabel): void {
        // Text is costly to lay out: only what has changed is set.
        if (element.textContent !== words) element.textContent = words;
        if (element.dataset['color'] !== color) {
            element.dataset['color'] = color;
            element.style.borderLeftColor = color;
        }
        element.hidden = false;
        const [x, y] = [Math.round(at.x + clearancePx.x), Math.round(at.y - clearancePx.y)];
        element.style.transform = `translate(${x}px, ${y}px)`;
    }

    private create(): HTMLElement {
        const element = document.createElement('span');
        element.className = 'rake-label';
        this.layer.append(element);
        this.pool.push(element);
        return element;
    }
}
