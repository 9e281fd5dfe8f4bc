// What the shader of the surfaces is meant to draw (scene/surface/surfaceShader.ts), said once more: colour of a lit point, and
// opacity of a layer. Colours are sRGB, 0 .. 1.
import type { BackSide } from '../../../web-client/src/state/surfaceLook.ts';

export type Colour = [number, number, number];

const toLinear = (c: number): number => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const fromLinear = (c: number): number => (c <= 0.0031308 ? c * 12.92 : 1.055 * c ** (1 / 2.4) - 0.055);

const lightFrom = [0.286, 0.477, 0.831] as const;
const grey = ([r, g, b]: Colour): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;
const mixed = (a: number, b: number, part: number): number => a + part * (b - a);

/** Of the side that is not the front. */
function otherSide(base: Colour, side: BackSide): Colour {
    if (side === 'shaded') return base.map((c) => mixed(c, grey(base), 0.15) * 0.8) as Colour;
    if (side === 'same') return base;
    const tint = [0.93, 0.36, 0.12] as const;
    return base.map((_, i) => mixed(grey(base), tint[i]!, 0.72) * (0.45 + 0.75 * grey(base))) as Colour;
}

/** @param normal towards the viewer, in the axes of the camera, which has no perspective */
export function litColour(hex: string, normal: readonly [number, number, number], back: BackSide | null = null): Colour {
    const own = [1, 3, 5].map((at) => toLinear(Number.parseInt(hex.slice(at, at + 2), 16) / 255)) as Colour;
    const base = back === null ? own : otherSide(own, back);
    const half = lightFrom.map((x, i) => x + (i === 2 ? 1 : 0));
    const dot = (a: readonly number[], b: readonly number[]): number => a.reduce((sum, x, i) => sum + x * b[i]!, 0);
    const diffuse = 0.38 + 0.5 * Math.max(0, dot(normal, lightFrom)) + 0.24 * Math.max(0, normal[2]);
    const shine = 0.07 * Math.max(0, dot(normal, half) / Math.hypot(...half)) ** 40;
    return base.map((c) => Math.min(1, fromLinear(c * diffuse + shine))) as Colour;
}

export interface LayerFacts {
    opacity: number;
    /** Cosine between normal and line of sight, where that counts. */
    facing?: number;
    /** 0 .. 1, and what it thins out by. */
    smoke?: number;
    areaRatio?: number;
    /** Age as a part of the greatest. */
    age?: number;
    /** What a fixed grid cannot resolve: by the shape of its triangles, and by how far the surface turns between vertices. */
    unresolved?: readonly [number, number];
}

/** Opacity of a thin layer: light falls off with the way through it, and with what is left of it. */
export function layerAlpha({ opacity, facing = 1, smoke = 0, areaRatio = 1, age = 0, unresolved = [0, 0] }: LayerFacts): number {
    const resolved = (1 - unresolved[0]) * (1 - unresolved[1]);
    const density = Math.min(1.5, Math.max(0.02, 1 / areaRatio)) * resolved * Math.max(0, 1 - age);
    const thickness = (-Math.log(1 - opacity) / Math.max(facing, 0.06)) * mixed(1, density, smoke);
    return 1 - Math.exp(-thickness);
}

export interface Layer {
    colour: Colour;
    alpha: number;
}

/** Layers from the nearest on over a ground, of 0 .. 255, as is the result. */
export function layered(layers: readonly Layer[], ground: readonly number[]): number[] {
    return layers.reduceRight(
        (behind, { colour, alpha }) => behind.map((c, i) => 255 * colour[i]! * alpha + (1 - alpha) * c),
        [...ground],
    );
}
