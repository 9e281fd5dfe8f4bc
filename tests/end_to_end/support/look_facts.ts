// What the tests of looks compare: vertices that are seen, their pixels, and hues.
import type { Page } from 'playwright-core';
import { maskSize } from '../../../web-client/src/scene/surface/surfaceMask.ts';
import type { PickHit } from '../../../web-client/src/scene/surface/pickHit.ts';
import type { SurfaceVertex } from '../../../web-client/src/scene/surface/surfaceMesh.ts';
import type { ScreenPoint } from '../../../web-client/src/scene/base/view.ts';
import { type ColourMapName, colourTable, fractionOf } from '../../../web-client/src/scene/surface/colourMap.ts';

export type Rgb = [number, number, number];

export interface SeenVertex extends SurfaceVertex {
    at: ScreenPoint;
    pixel: Rgb;
}

/** Hue in degrees and how colourful, of an sRGB colour. */
export function hueOf([r, g, b]: readonly number[]): { hue: number; chroma: number } {
    const [red, green, blue] = [r ?? 0, g ?? 0, b ?? 0];
    const high = Math.max(red, green, blue);
    const chroma = high - Math.min(red, green, blue);
    if (chroma === 0) return { hue: 0, chroma };
    let sector = (red - green) / chroma + 4;
    if (high === red) sector = ((green - blue) / chroma + 6) % 6;
    else if (high === green) sector = (blue - red) / chroma + 2;
    return { hue: sector * 60, chroma };
}

/** Every n-th vertex that is in the picture, under nothing else, with the pixel at its place. */
export async function seenVertices(page: Page, every: number): Promise<SeenVertex[]> {
    return page.evaluate((n) => {
        const hook = window.wakesurf!;
        const bounds = hook.bounds!;
        const size = Math.hypot(...[0, 2, 4].map((i) => bounds[i + 1]! - bounds[i]!));
        const box = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
        const radius = Math.floor(Math.min(box.width, box.height) / 2) - 4;
        const grid = hook.pickGrid({ x: Math.round(box.left + box.width / 2), y: Math.round(box.top + box.height / 2) }, radius);
        const seen = hook.vertices(n).flatMap((vertex) => {
            const at = hook.project(vertex.point);
            if (at === null) return [];
            const [column, row] = [Math.round(at.x - grid.corner.x), Math.round(at.y - grid.corner.y)];
            if (column < 0 || row < 0 || column >= grid.size || row >= grid.size) return [];
            const hit = grid.hits[row * grid.size + column];
            if (!hit?.surface) return [];
            const apart = Math.hypot(...hit.point.map((x, i) => x - vertex.point[i]!));
            return apart < size * 0.004 ? [{ ...vertex, at }] : [];
        });
        const pixels = hook.pixelsAt(seen.map(({ at }) => at));
        return seen.map((vertex, i) => ({ ...vertex, pixel: pixels[i]! }));
    }, every);
}

export interface Colouring {
    map: ColourMapName;
    range: readonly [number, number];
    log?: boolean;
    invert?: boolean;
}

/** How many of the vertices have the hue that a colouring leads to, where it leads to one. */
export function agreement(
    seen: readonly SeenVertex[],
    valueOf: (vertex: SeenVertex) => number,
    { map, range, log = false, invert = false }: Colouring,
): number {
    const table = colourTable(map);
    const hues = seen.flatMap((vertex) => {
        const fraction = fractionOf(valueOf(vertex), range, log ? 'log' : 'even');
        const i = 4 * Math.round((invert ? 1 - fraction : fraction) * 255);
        const [wanted, is] = [hueOf([...table.subarray(i, i + 3)]), hueOf(vertex.pixel)];
        return wanted.chroma > 40 && is.chroma > 25 ? [Math.abs(wanted.hue - is.hue)] : [];
    });
    if (hues.length < 30) throw new Error(`only ${hues.length} of ${seen.length} vertices have a hue`);
    return hues.filter((apart) => Math.min(apart, 360 - apart) < 12).length / hues.length;
}

export type PlacedPick = Pick<PickHit, 's' | 't'> & { at: ScreenPoint };

export interface PlacedHit extends PickHit {
    at: ScreenPoint;
    /** How s and t change by a pixel; null at an edge. */
    slope: { s: number; t: number } | null;
}

/** What is seen in the middle of the picture, at every so many pixels. */
export async function hitsOver(page: Page, stepPx: number): Promise<PlacedHit[]> {
    return page.evaluate((step) => {
        const hook = window.wakesurf!;
        const box = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
        const radius = Math.floor(Math.min(box.width, box.height) / 2) - 4;
        const centre = { x: Math.round(box.left + box.width / 2) + 0.5, y: Math.round(box.top + box.height / 2) + 0.5 };
        const { corner, size, hits } = hook.pickGrid(centre, radius);
        const found: PlacedHit[] = [];
        for (let row = 1; row < size - 1; row += step) {
            for (let column = 1; column < size - 1; column += step) {
                const i = row * size + column;
                const hit = hits[i];
                if (!hit) continue;
                const around = [hits[i - 1], hits[i + 1], hits[i - size], hits[i + size]];
                const whole = around.every((each) => each?.surface === hit.surface);
                const along = (name: 's' | 't'): number => {
                    const [a, b, c, d] = around.map((each) => each?.[name] ?? 0) as [number, number, number, number];
                    return Math.hypot((b - a) / 2, (d - c) / 2);
                };
                const slope = whole ? { s: along('s'), t: along('t') } : null;
                found.push({ ...hit, at: { x: corner.x + column, y: corner.y + row }, slope });
            }
        }
        return found;
    }, stepPx);
}

/** What of surfaces is seen at every pixel of a square round a position in the window. */
export async function hitsRound(page: Page, centre: ScreenPoint, radiusPx: number): Promise<PlacedPick[]> {
    return page.evaluate(
        ({ at, radius }) => {
            const { corner, size, hits } = window.wakesurf!.pickGrid(at, radius);
            return hits.flatMap((hit, i) => {
                if (!hit?.surface) return [];
                return [{ s: hit.s, t: hit.t, at: { x: corner.x + (i % size), y: corner.y + Math.floor(i / size) } }];
            });
        },
        { at: centre, radius: radiusPx },
    );
}

/** Luminance, 0 to 1, of an sRGB colour. */
export const light = ([r, g, b]: Rgb): number => {
    const [x, y, z] = [r, g, b].map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * x! + 0.7152 * y! + 0.0722 * z!;
};

/** How far a position in the window is from the line between two. */
export function distanceFrom(from: ScreenPoint, to: ScreenPoint): (at: ScreenPoint) => number {
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    return ({ x, y }) => {
        const part = Math.min(1, Math.max(0, ((x - from.x) * dx + (y - from.y) * dy) / (dx * dx + dy * dy)));
        return Math.hypot(x - from.x - part * dx, y - from.y - part * dy);
    };
}

/** How many texels of a mask over all of s and `times` a place is from the nearest of others. */
export function texelsFrom(others: readonly PlacedPick[], times: readonly number[]): (hit: PlacedPick) => number {
    const texel = { s: 1 / maskSize, t: (Math.max(...times) - Math.min(...times)) / maskSize };
    return (hit) => Math.min(...others.map(({ s, t }) => Math.max(Math.abs(s - hit.s) / texel.s, Math.abs(t - hit.t) / texel.t)));
}
