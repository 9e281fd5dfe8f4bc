// Arrows on slices: the part of the velocity that lies in the plane, at evenly spaced places. White on a dark edge, so that they are seen on
// every colour.
import { Color, Group } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { noSliceValue, sliceCodes, type SliceRaster } from '../../protocol/sliceFile.ts';
import type { Layer, View } from '../base/view.ts';
import { tintOf, WideLines } from '../base/wideLines.ts';
import { cross, dot, lengthOf, minus, plus, times, unit } from '../rake/rakeShape.ts';

export interface PlaneArrows {
    /** xyz of both ends of each line: a shaft and two barbs an arrow. */
    ends: number[];
    /** The speed in the plane of the longest one; 0: there are none. */
    longest: number;
}

/** Shorter ones are no more than specks. */
const leastPart = 0.04;
/** Of the distance between two arrows, so that they do not touch. */
const longestPart = 0.9;
const [barbAlong, barbAcross] = [0.32, 0.16];
const [edgePx, shaftPx] = [3.4, 1.5];

/** @param components  x, y and z of the velocity at the same samples. One value in a hundred may be longer than the longest arrow. */
export function planeArrows(components: readonly [SliceRaster, SliceRaster, SliceRaster]): PlaneArrows {
    const [{ columns, rows, corner, across, up }] = components;
    const normal = unit(cross(across, up));
    const spacing = lengthOf(across) / columns;
    const vectors: { at: Vec3; flow: Vec3; speed: number }[] = [];
    for (let i = 0; i < columns * rows; ++i) {
        if (components.some(({ codes }) => codes[i] === noSliceValue)) continue;
        const velocity = components.map(
            ({ codes, range: [low, high] }) => low + ((high - low) * codes[i]!) / sliceCodes,
        ) as unknown as Vec3;
        const flow = minus(velocity, times(normal, dot(velocity, normal)));
        const [s, t] = [((i % columns) + 0.5) / columns, (Math.floor(i / columns) + 0.5) / rows];
        vectors.push({ at: plus(corner, plus(times(across, s), times(up, t))), flow, speed: lengthOf(flow) });
    }
    const speeds = vectors.map(({ speed }) => speed).sort((a, b) => a - b);
    const longest = speeds[Math.floor(0.99 * speeds.length)] ?? 0;
    if (!(longest > 0)) return { ends: [], longest: 0 };
    const ends: number[] = [];
    for (const { at, flow, speed } of vectors) {
        if (speed < leastPart * longest) continue;
        const arrow = times(flow, (longestPart * spacing * Math.min(1, longest / speed)) / longest);
        const tip = plus(at, times(arrow, 0.5));
        const side = times(cross(normal, arrow), barbAcross);
        const neck = minus(tip, times(arrow, barbAlong));
        ends.push(...minus(tip, arrow), ...tip, ...plus(neck, side), ...tip, ...minus(neck, side), ...tip);
    }
    return { ends, longest };
}

export class SliceArrowLayer implements Layer {
    readonly object = new Group();
    private readonly drawn = new Map<string, readonly [WideLines, WideLines]>();

    update(view: View): void {
        for (const lines of this.drawn.values()) for (const each of lines) each.update(view);
    }

    set(id: string, { ends }: PlaneArrows): void {
        let lines = this.drawn.get(id);
        if (lines === undefined) {
            lines = [new WideLines({ width: edgePx, hidden: true }), new WideLines({ width: shaftPx, hidden: true })];
            lines.forEach(({ object }, i) => {
                object.renderOrder = 20 + i;
                // In front of the slice that they lie on.
                Object.assign(object.material, { polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -8 });
                this.object.add(object);
            });
            this.drawn.set(id, lines);
        }
        const tints = [tintOf(new Color('#10151c'), 0.75), tintOf(new Color('#ffffff'))];
        lines.forEach((each, i) => each.set(ends, Array.from({ length: ends.length / 6 }, () => tints[i]!).flat()));
    }

    remove(id: string): void {
        const lines = this.drawn.get(id);
        this.drawn.delete(id);
        for (const each of lines ?? []) {
            this.object.remove(each.object);
            each.dispose();
        }
    }
}
