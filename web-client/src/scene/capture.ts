// A figure: the picture at any size, with another background or none, and with the text that lies over it. Laid out in pixels of CSS, like
// a page of its shape, so that text, lines and handles can be read however small the figure or the page is; drawn in the drawing buffer of
// the canvas, in tiles where it is large. The canvas has its own size again before the browser shows it.
import { Color } from 'three';
import { type Cover, coverOf, placeOf } from './base/labels.ts';
import type { Layer, Part, ScreenPoint, ScreenSize } from './base/view.ts';
import { DomainOutline } from './domain/domainOutline.ts';
import { ScaleBar } from './domain/scaleBar.ts';
import type { FlowScene } from './scene.ts';
import { MarkerLayer } from './tools/markers.ts';

/** shown: as on the page. clear: none. */
export type FigureBackground = 'shown' | 'white' | 'clear';

export interface FigureSetting {
    /** In pixels. */
    width: number;
    height: number;
    background: FigureBackground;
    /** The box of the domain with its numbers. */
    axes: boolean;
    /** The bar of a round length. */
    scale?: boolean;
    rake: boolean;
    /** Notes, and what is probed and measured. */
    marks?: boolean;
    /** Element over the picture whose place is at the bottom right. */
    bar: HTMLElement | null;
    /** At the top left. */
    caption: string | null;
}

/** What browsers make canvases of, and what pictures on paper need. */
const longestSide = 16_384;
const maxPixels = 128e6;
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
    if (width * height <= maxPixels) return null;
    return `A picture can have at most ${maxPixels / 1e6} million pixels. Choose a smaller picture.`;
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
        (!setting.axes && layer instanceof DomainOutline) ||
        (setting.scale !== true && layer instanceof ScaleBar) ||
        (setting.marks === false && layer instanceof MarkerLayer);
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
        for (const { drawn: part, inner } of tiles) {
            const { x, y } = inner;
            const shoot = (colour: Color | null): void => {
                draw(colour, part);
                if (drawn.width !== part.width || drawn.height !== part.height || scene.renderer.getContext().isContextLost()) {
                    throw new Error(
                        'The graphics hardware does not have enough memory for a picture of this size. Choose a smaller one.',
                    );
                }
                const [left, top] = [x - part.x, y - part.y];
                context.drawImage(drawn, left, top, inner.width, inner.height, x, y, inner.width, inner.height);
            };
            if (background === 'clear') {
                shoot(new Color(0, 0, 0));
                const onBlack = context.getImageData(x, y, inner.width, inner.height);
                shoot(new Color(1, 1, 1));
                const onWhite = context.getImageData(x, y, inner.width, inner.height);
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
    { background, axes, scale, rake, marks, bar, caption }: FigureSetting,
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
        (scale !== true && element.matches('.scale')) ||
        (marks === false && element.matches('.marker')) ||
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

/**
 * Enough for the labels and the scalar bar: grounds, borders, canvases and text, where they are and as they are styled. No
 * browser offers this by itself. `shift`: from the window to the picture. Elements that are skipped are so with all in them.
 */
function paintElement(
    context: CanvasRenderingContext2D,
    element: Element,
    shift: ScreenPoint,
    skipped: (element: Element) => boolean,
): void {
    const style = getComputedStyle(element);
    if (style.display === 'none' || style.visibility === 'hidden' || skipped(element)) return;
    const box = element.getBoundingClientRect();
    const at = { x: box.left + shift.x, y: box.top + shift.y };
    paintBox(context, style, at, box);
    if (element instanceof HTMLCanvasElement && element.width > 0 && element.height > 0) {
        context.drawImage(element, at.x, at.y, box.width, box.height);
    }
    let run: Text[] = [];
    for (const node of [...(element.shadowRoot ?? element).childNodes, null]) {
        if (node instanceof Text) run.push(node);
        else if (!(node instanceof Comment)) {
            paintRun(context, run, style, shift);
            run = [];
            if (node instanceof Element) paintElement(context, node, shift, skipped);
        }
    }
}

function paintBox(context: CanvasRenderingContext2D, style: CSSStyleDeclaration, at: ScreenPoint, box: DOMRect): void {
    const border = style.borderTopStyle === 'solid' ? parseFloat(style.borderTopWidth) : 0;
    const inset = border / 2;
    context.beginPath();
    context.roundRect(
        at.x + inset,
        at.y + inset,
        Math.max(0, box.width - border),
        Math.max(0, box.height - border),
        Math.max(0, (parseFloat(style.borderTopLeftRadius) || 0) - inset),
    );
    if (!isClear(style.backgroundColor)) {
        context.fillStyle = style.backgroundColor;
        context.fill();
    }
    if (border > 0 && !isClear(style.borderTopColor)) {
        context.strokeStyle = style.borderTopColor;
        context.lineWidth = border;
        context.stroke();
    }
}

/** Neighbours are one text: templates leave comments between their parts. */
function paintRun(context: CanvasRenderingContext2D, run: readonly Text[], style: CSSStyleDeclaration, shift: ScreenPoint): void {
    const words = run
        .map(({ data }) => data)
        .join('')
        .replace(/\s+/g, ' ')
        .trim();
    if (words === '') return;
    const range = document.createRange();
    range.setStartBefore(run[0]!);
    range.setEndAfter(run.at(-1)!);
    const box = range.getBoundingClientRect();
    if (box.width === 0) return;
    context.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    context.fillStyle = style.color;
    context.textBaseline = 'middle';
    context.textAlign = 'left';
    context.fillText(words, box.left + shift.x, box.top + box.height / 2 + shift.y);
}

function isClear(colour: string): boolean {
    return colour === 'transparent' || /[,/]\s*0\)$/.test(colour);
}

export interface Tile {
    /** What is drawn. */
    drawn: Part;
    /** What of it is taken. */
    inner: Part;
}

/**
 * Parts that cover each pixel of the picture once, each drawn with a margin in which whatever begins outside of it and reaches
 * into it has room. All are drawn equally large, at most `side` pixels a side; even offsets keep differences between
 * neighbouring pixels the same. A margin of more than a quarter of a tile is cut down to that: tiles that were little but
 * margin would be too many. REQUIRES: side >= 8
 */
export function tilesOf({ width, height }: ScreenSize, side: number, margin: number): Tile[] {
    const edge = 2 * Math.ceil(Math.floor(Math.min(margin, side / 4)) / 2);
    const columns = stretchesOf(width, side, edge);
    return stretchesOf(height, side, edge).flatMap((row) =>
        columns.map((column) => ({
            drawn: { x: column.drawn, y: row.drawn, width: column.drawnLength, height: row.drawnLength },
            inner: { x: column.inner, y: row.inner, width: column.innerLength, height: row.innerLength },
        })),
    );
}

interface Stretch {
    drawn: number;
    drawnLength: number;
    inner: number;
    innerLength: number;
}

/** Divides one side of the picture. */
function stretchesOf(length: number, side: number, edge: number): Stretch[] {
    if (length <= side) return [{ drawn: 0, drawnLength: length, inner: 0, innerLength: length }];
    const count = Math.ceil(length / (2 * Math.floor((side - 2 * edge) / 2)));
    const step = 2 * Math.ceil(length / count / 2);
    return Array.from({ length: Math.ceil(length / step) }, (_, i) => ({
        ...{ drawn: i * step - edge, drawnLength: step + 2 * edge },
        ...{ inner: i * step, innerLength: Math.min(step, length - i * step) },
    }));
}
