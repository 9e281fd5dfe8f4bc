// A figure: the picture at any size, with another background or none, and with the text that lies over it. Drawn in the drawing
// buffer of the canvas, which has its own size again before the browser shows it.
import { Color } from 'three';
import { DomainOutline } from './domain/domainOutline.ts';
import { paintElement } from './elementPainter.ts';
import type { FlowScene } from './scene.ts';
import type { Layer, ScreenSize } from './base/view.ts';

/** shown: as on the page. clear: none. */
export type FigureBackground = 'shown' | 'white' | 'clear';

export interface FigureSetting {
    /** In pixels. */
    width: number;
    height: number;
    background: FigureBackground;
    /** The box of the domain with its numbers. */
    axes: boolean;
    rake: boolean;
    /** Element over the picture whose place is at the bottom right. */
    bar: HTMLElement | null;
    /** At the top left. */
    caption: string | null;
}

/** Sides that a picture may have here, in pixels. */
export function longestSide(scene: FlowScene): number {
    const gl = scene.renderer.getContext();
    const dims = gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array;
    const limits = [gl.MAX_TEXTURE_SIZE, gl.MAX_RENDERBUFFER_SIZE].map((name) => Number(gl.getParameter(name)));
    return Math.min(dims[0] ?? 0, dims[1] ?? 0, ...limits);
}

/** Why a figure of this size cannot be drawn; null if it can be tried. */
export function sizeFault({ width, height }: ScreenSize, longest: number): string | null {
    if (!(Number.isInteger(width) && Number.isInteger(height) && width >= 16 && height >= 16)) {
        return 'Width and height are whole numbers of pixels, at least 16.';
    }
    if (Math.max(width, height) <= longest) return null;
    return `The graphics here draw at most ${longest} pixels a side. Choose a smaller picture.`;
}

/** Error: in words. */
export function capture(scene: FlowScene, setting: FigureSetting): HTMLCanvasElement {
    const { width, height, background } = setting;
    const fault = sizeFault(setting, longestSide(scene));
    if (fault !== null) throw new Error(fault);
    // As tall as the picture on the page, so that text and handles have the same share of it.
    const layout = { width: 0, height: Math.max(1, scene.size.height) };
    const pixelRatio = height / layout.height;
    layout.width = width / pixelRatio;
    // Sizes are rounded down: a hair more keeps the last pixel.
    const [rounded, ratio] = [{ width: layout.width, height: layout.height }, pixelRatio * (1 + 1e-9)];
    const leftOut = (layer: Layer): boolean =>
        layer.notForFigures === true ||
        (!setting.rake && layer === scene.rakes) ||
        (!setting.axes && layer instanceof DomainOutline);
    return scene.drawAside(rounded, ratio, leftOut, (draw) => {
        const drawn = scene.renderer.domElement;
        const figure = document.createElement('canvas');
        [figure.width, figure.height] = [width, height];
        const context = figure.getContext('2d', { willReadFrequently: background === 'clear' });
        if (context === null) throw new Error('This browser has no memory for a picture of this size.');
        const shoot = (colour: Color | null): void => {
            draw(colour);
            if (drawn.width !== width || drawn.height !== height || scene.renderer.getContext().isContextLost()) {
                throw new Error(
                    'The graphics here have no memory for a picture of this size. Choose a smaller one.',
                );
            }
            context.drawImage(drawn, 0, 0);
        };
        if (background === 'clear') {
            shoot(new Color(0, 0, 0));
            const onBlack = context.getImageData(0, 0, width, height);
            shoot(new Color(1, 1, 1));
            const onWhite = context.getImageData(0, 0, width, height);
            withoutBackground(onBlack.data, onWhite.data);
            context.putImageData(onBlack, 0, 0);
        } else shoot(background === 'white' ? new Color(1, 1, 1) : null);
        paintText(context, scene, setting, layout, pixelRatio);
        return figure;
    });
}

/**
 * Opacity and colours from the same picture before black and before white: what is seen of a background differs by all of it.
 * Works for whatever the picture is made of, also for what lets light through. Changes `onBlack` to the result.
 */
export function withoutBackground(onBlack: Uint8ClampedArray, onWhite: Uint8ClampedArray): void {
    for (let i = 0; i < onBlack.length; i += 4) {
        let seenThrough = 0;
        for (let k = i; k < i + 3; ++k) seenThrough += onWhite[k]! - onBlack[k]!;
        const alpha = 255 - seenThrough / 3;
        const opacity = alpha < 1.5 ? 0 : Math.min(255, alpha);
        for (let k = i; k < i + 3; ++k) onBlack[k] = opacity === 0 ? 0 : (onBlack[k]! * 255) / opacity;
        onBlack[i + 3] = opacity;
    }
}

const pageForLight = 'light';
const captionAt = { x: 16, y: 24 };

function paintText(
    context: CanvasRenderingContext2D,
    scene: FlowScene,
    { background, axes, rake, bar, caption }: FigureSetting,
    layout: ScreenSize,
    pixelRatio: number,
): void {
    const { labels } = scene;
    const elements = bar === null ? [labels] : [labels, bar];
    const schemes = elements.map((element) => element.style.colorScheme);
    // On white, and on the pages that most figures go to, text is dark.
    if (background !== 'shown') for (const element of elements) element.style.colorScheme = pageForLight;
    context.save();
    context.scale(pixelRatio, pixelRatio);
    const page = labels.getBoundingClientRect();
    const skipped = (element: Element): boolean =>
        element.matches('.person') ||
        (!axes && element.matches('.tick, .axis-name')) ||
        (!rake && element.matches('.rake-label'));
    paintElement(context, labels, { x: -page.left, y: -page.top }, skipped);
    if (bar !== null) {
        // Where the labels lie has been placed for the figure, the bar has not.
        const [dx, dy] = [layout.width - page.width, layout.height - page.height];
        paintElement(context, bar, { x: dx - page.left, y: dy - page.top }, () => false);
    }
    if (caption !== null) {
        const style = getComputedStyle(labels);
        context.font = `600 16px ${style.fontFamily}`;
        context.fillStyle = style.color;
        context.textBaseline = 'middle';
        context.fillText(caption, captionAt.x, captionAt.y);
    }
    context.restore();
    elements.forEach((element, i) => (element.style.colorScheme = schemes[i] ?? ''));
}
