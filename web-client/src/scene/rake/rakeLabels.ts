// Words beside rakes: who holds one, what a dragged handle is held to.
import { beside, Labels } from '../base/labels.ts';
import type { ScreenPoint } from '../base/view.ts';

export interface RakeLabel {
    at: ScreenPoint;
    words: string;
    colour: string;
}

/** Clear of the handle and of the finger on it. */
const clearancePx = { x: 18, y: 34 };

export class RakeLabels {
    private readonly labels: Labels;

    constructor(layer: HTMLElement) {
        this.labels = new Labels(layer);
    }

    show(labels: readonly RakeLabel[]): void {
        this.labels.begin();
        for (const { at, words, colour } of labels) {
            const place = { x: at.x + clearancePx.x, y: at.y - clearancePx.y };
            this.labels.place(place, words, 'rake-label', beside).style.borderLeftColor = colour;
        }
        this.labels.end();
    }
}
