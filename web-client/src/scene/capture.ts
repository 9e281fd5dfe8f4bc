// A figure: the picture at any size, with another background or none, and with the text that lies over it.
// Drawn in the drawing buffer of the canvas, in tiles where it is large; the canvas has its own size again
// before the browser shows it.
import { Color } from 'three';
import { type Cover, coverOf, placeOf } from './base/cover.ts';
import { DomainOutline } from './domain/domainOutline.ts';
import { paintElement } from './elementPainter.ts';
import { barIn, layoutOf } from './figureLayout.ts';
import type { FlowScene } from './scene.ts';
import type { Layer, ScreenSize } from './base/view.ts';
import { tilesOf } from './tiles.ts';

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

/** Holds what browsers make canvases of, and what pictures on paper need. */
const longestSide = 16_384;
const pixelsAtMost = 128e6;
/** Drawn at once; peeling needs some 60 bytes a pixel. */
const tileSide = 2048;
/** Leaves room for handles, which reach from one tile into another; in pixels of CSS. */
const tileMargin = 24;

/** Why a figure of this size cannot be drawn; null if it can be tried. */
export function sizeFault({ width, height }: ScreenSize): string | null {
    if (!(Number.isInteger(width) && Number.isInteger(height) && width >= 16 && height >= 16)) {
        return 'Width and height must be whole numbers of pixels, at least 16.';
    }
    if (Math.max(width, height) > longestSide) {
        return `A picture can have at most ${longestSide} pixels per side. Choose a smaller picture.`;
    }
    if (width * height <= pixelsAtMost) return null;
    return `A picture can have at most ${pixelsAtMost / 1e6} million pixels. Choose a smaller picture.`;
}

/** Returns what the graphics draw at once. */
function drawnSide(scene: FlowScene, pixelRatio: number): number {
    const gl = scene.renderer.getContext();
    const dims = gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array;
    const limits = [gl.MAX_TEXTURE_SIZE, gl.MAX_RENDERBUFFER_SIZE].map((name) => Number(gl.getParameter(name)));
    // Where the margin is wide, a somewhat larger tile is mostly picture all the same.
    const margin = Math.min(tileMargin * pixelRatio, tileSide / 4);
    return Math.min(Math.max(tileSide, 6 * margin), dims[0] ?? 0, dims[1] ?? 0, ...limits);
}

export interface Captured {
    figure: HTMLCanvasElement;
    /** There was no room for it. */
    barLeftOut: boolean;
}

/** Error: in words. @param side of tiles, in pixels; without it as large as they are best */
export function capture(scene: FlowScene, setting: FigureSetting, side?: number): Captured {
    const { width, height, background } = setting;
    const fault = sizeFault(setting);
    if (fault !== null) throw new Error(fault);
    const layout = layoutOf(setting, scene.size.height);
    const { pixelRatio } = layout;
    const leftOut = (layer: Layer): boolean =>
        layer.notForFigures === true ||
        (!setting.rake && layer === scene.rakes) ||
        (!setting.axes && layer instanceof DomainOutline);
    const page = scene.labels.getBoundingClientRect();
    const wanted = setting.bar === null ? null : coverOf(page, setting.bar.getBoundingClientRect());
    const cover = wanted === null ? null : barIn(layout, wanted);
    const tiles = tilesOf(setting, side ?? drawnSide(scene, pixelRatio), Math.ceil(tileMargin * pixelRatio));
    return scene.drawAside(layout, pixelRatio, leftOut, { encoded: background === 'clear', cover }, (draw) => {
        const drawn = scene.renderer.domElement;
        const figure = document.createElement('canvas');
        [figure.width, figure.height] = [width, height];
        const context = figure.getContext('2d', { willReadFrequently: background === 'clear' });
        if (context === null) throw new Error('This browser does not have enough memory for a picture of this size.');
        for (const { drawn: part, kept } of tiles) {
            const { x, y } = kept;
            const shoot = (colour: Color | null): void => {
                draw(colour, part);
                if (drawn.width !== part.width || drawn.height !== part.height || scene.renderer.getContext().isContextLost()) {
                    throw new Error(
                        'The graphics hardware does not have enough memory for a picture of this size. Choose a smaller one.',
                    );
                }
                const [left, top] = [x - part.x, y - part.y];
                context.drawImage(drawn, left, top, kept.width, kept.height, x, y, kept.width, kept.height);
            };
            if (background === 'clear') {
                shoot(new Color(0, 0, 0));
                const onBlack = context.getImageData(x, y, kept.width, kept.height);
                shoot(new Color(1, 1, 1));
                const onWhite = context.getImageData(x, y, kept.width, kept.height);
                withoutBackground(onBlack.data, onWhite.data);
                context.putImageData(onBlack, x, y);
            } else shoot(background === 'white' ? new Color(1, 1, 1) : null);
        }
        paintText(context, scene, setting, { layout, cover, pixelRatio });
        return { figure, barLeftOut: wanted !== null && cover === null };
    });
}

/**
 * Opacity and colours from the same picture before black and before white: what is seen of a background
 * differs by all of it. Works for whatever the picture is made of, also for what lets light through. Changes
 * `onBlack` to the result.
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
    { layout, cover, pixelRatio }: { layout: ScreenSize; cover: Cover | null; pixelRatio: number },
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
        element.classList.contains('beside-pointer') ||
        element.matches('.person') ||
        (!axes && element.matches('.tick, .axis-name')) ||
        (!rake && element.matches('.rake-label'));
    paintElement(context, labels, { x: -page.left, y: -page.top }, skipped);
    if (bar !== null && cover !== null) {
        // Where the labels lie has been placed for the figure, the bar has not.
        const [at, box] = [placeOf(cover, layout), bar.getBoundingClientRect()];
        paintElement(context, bar, { x: at.x - box.left, y: at.y - box.top }, () => false);
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
