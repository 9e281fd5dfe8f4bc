// A bar of a round length at the lower left of the picture: how large things are where no numbers of the axes are seen. With perspective it
// is true at the point that the view turns about.
import { Object3D } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { beside, Labels } from '../base/labels.ts';
import { niceStep, shortNumber } from '../base/numbers.ts';
import type { Layer, View } from '../base/view.ts';

/** A round length of at least this many pixels of CSS has at most 2.5 times as many. */
const leastPx = 48;
const at = { x: 14, bottom: 14 };
const thickPx = 3;

/** The shortest of 1, 2 and 5 times a power of ten that is long enough. */
export function scaleOf(worldPerPx: number): { length: number; px: number } | null {
    if (!Number.isFinite(worldPerPx) || !(worldPerPx > 0)) return null;
    const length = niceStep(leastPx * worldPerPx);
    return { length, px: length / worldPerPx };
}

export class ScaleBar implements Layer {
    readonly object = new Object3D();
    private readonly words: Labels;
    private readonly bar: Labels;
    private readonly target: () => Vec3;
    private unit = '';

    /** @param layer lies over the canvas @param target what the view turns about */
    constructor(layer: HTMLElement, target: () => Vec3) {
        this.words = new Labels(layer);
        this.bar = new Labels(layer);
        this.target = target;
    }

    /** Empty: unknown. */
    setUnit(unit: string): void {
        this.unit = unit;
    }

    update(view: View): void {
        const scale = scaleOf(view.worldPerPx(this.target()));
        this.words.begin();
        this.bar.begin();
        if (scale !== null) {
            const foot = view.size.height - at.bottom;
            const words = `${shortNumber(scale.length)}${this.unit === '' ? '' : ` ${this.unit}`}`;
            this.words.place({ x: at.x, y: foot - 20 }, words, 'scale', beside);
            const bar = this.bar.place({ x: at.x, y: foot - thickPx }, '', 'scale scale-line', beside);
            bar.style.width = `${scale.px.toFixed(1)}px`;
        }
        this.words.end();
        this.bar.end();
    }
}
