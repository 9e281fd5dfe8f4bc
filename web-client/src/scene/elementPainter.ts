// Draws elements of the page into a picture, where they are and as they are styled: grounds, borders,
// canvases and text. Enough for the labels and the scalar bar; no browser offers this by itself.
import type { ScreenPoint } from './base/view.ts';

/** `shift`: from the window to the picture. Elements that are skipped are so with all in them. */
export function paintElement(
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
            paintText(context, run, style, shift);
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
function paintText(
    context: CanvasRenderingContext2D,
    run: readonly Text[],
    style: CSSStyleDeclaration,
    shift: ScreenPoint,
): void {
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
