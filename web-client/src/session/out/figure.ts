// Holds what a figure is to show, chosen once for pictures and films, and the picture as it is now.
import { signal } from '@preact/signals-core';
import { capture, type FigureBackground } from '../../scene/capture.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { ScreenSize } from '../../scene/base/view.ts';

export class Figure {
    readonly background = signal<FigureBackground>('shown');
    readonly bar = signal(true);
    readonly axes = signal(true);
    readonly rake = signal(false);
    /** Says whether a picture that shows a surface before it is final says so. */
    readonly coarse = signal(true);
    /** The last one that was drawn had no room for it. */
    barLeftOut = false;
    private readonly scene: FlowScene;
    private readonly findBar: () => HTMLElement | null;

    /** `findBar`: the scalar bar that lies over the picture. */
    constructor(scene: FlowScene, findBar: () => HTMLElement | null) {
        this.scene = scene;
        this.findBar = findBar;
    }

    /** Returns the size of the picture on the page, in pixels of the screen. */
    get shownSize(): ScreenSize {
        const ratio = Math.max(1, devicePixelRatio);
        const { width, height } = this.scene.size;
        return { width: Math.round(width * ratio), height: Math.round(height * ratio) };
    }

    /** Error: in words, where the graphics cannot draw it. */
    draw(size: ScreenSize, caption: string | null, background = this.background.value, tileSide?: number): HTMLCanvasElement {
        const bar = this.bar.value ? this.findBar() : null;
        const [axes, rake] = [this.axes.value, this.rake.value];
        const shownBar = bar?.hidden === true ? null : bar;
        const drawn = capture(this.scene, { ...size, background, axes, rake, caption, bar: shownBar }, tileSide);
        this.barLeftOut = drawn.barLeftOut;
        return drawn.figure;
    }
}
