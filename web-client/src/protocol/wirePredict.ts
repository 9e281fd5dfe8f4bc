// The predictors: what both ends expect of a vertex before its residual. protocol/wire/FORMAT.md, Points.
// Sums are exact in double precision and cut to 32 bits once, which is to wrap. Twin:
// protocol/wire/wire_predict.hpp.
import { type Neighbours, none } from './neighbours.ts';

export const predictorsOf = { moved: 4, appended: 6 } as const;
/** Predicts the changes of appended vertices. */
export const changePredictor = 4;

const largestChange = 1 << 20;

/** Describes what is predicted: the positions, the codes of an attribute, or the changes of appended
 *  vertices. */
export interface Series {
    components: number;
    first: number; // values are first .. last
    last: number;
    values: Int32Array; // x
    change: Int32Array; // d, by this update
    changeBefore: Int32Array; // h; empty where it counts as 0
    isChange?: boolean;
}

export function changeSeries({ change }: { change: Int32Array }): Series {
    const range = { first: -largestChange, last: largestChange };
    return { components: 3, ...range, values: change, change, changeBefore: change, isChange: true };
}

function clamp(value: number, first: number, last: number): number {
    const wrapped = value | 0;
    return wrapped < first ? first : wrapped > last ? last : wrapped;
}

/** Vertices that moved; each residual in `r` counts `scale`. */
export function move(
    series: Series,
    near: Neighbours,
    predictor: number,
    vertices: Int32Array,
    r: Int32Array,
    scale: number,
): void {
    const { components: n, first, last, values: x, change: d, changeBefore: h } = series;
    const { highest, lowest, beside, beside2, opposite } = near;
    const remembers = h.length > 0;
    for (let j = 0, next = 0; j < vertices.length; ++j) {
        const v = vertices[j]!;
        const i = n * v;
        const a = n * highest[v]!;
        const b = n * lowest[v]!;
        const p = n * beside[v]!;
        const q = n * beside2[v]!;
        const o = n * opposite[v]!;
        for (let k = 0; k < n; ++k, ++next) {
            let change: number;
            if (a < 0 || predictor === 0) change = remembers ? h[i + k]! : 0;
            else if (predictor === 3 && o >= 0) change = (d[p + k]! + d[q + k]! - d[o + k]!) | 0;
            else if (predictor === 2 && remembers) change = h[i + k]! + ((d[a + k]! - h[a + k]! + d[b + k]! - h[b + k]!) >> 1);
            else change = (d[a + k]! + d[b + k]!) >> 1;
            const before = x[i + k]!;
            const after = clamp(before + change + Math.imul(r[next]!, scale), first, last);
            x[i + k] = after;
            d[i + k] = after - before;
        }
    }
}

/** Appended vertices; the first `stayed` of the mesh were there before the update. */
export function append(
    { components: n, first, last, values: x, change: d }: Series,
    { highest, lowest, beside, beside2, opposite }: Neighbours,
    predictor: number,
    vertices: Int32Array,
    r: Int32Array,
    scale: number,
    stayed: number,
): void {
    for (let j = 0, next = 0; j < vertices.length; ++j) {
        const v = vertices[j]!;
        let p = highest[v]!;
        let q = p;
        let o = none;
        let isOld = false;
        if (p < 0) p = q = v - 1;
        else if (predictor === 1) p = q = lowest[v]!;
        else if (predictor === 2) o = highest[p]!;
        else if (predictor === 3 && beside[v]! >= 0) [p, q, o] = [beside[v]!, beside2[v]!, opposite[v]!];
        else if (predictor === 4) q = lowest[v]!;
        else if (predictor === 5 && lowest[v]! < stayed) [p, isOld] = [lowest[v]!, true];
        for (let k = 0; k < n; ++k, ++next) {
            let expected = 0;
            if (p < 0) expected = 0;
            else if (isOld) expected = x[n * p + k]! - d[n * p + k]!;
            else if (o < 0) expected = (x[n * p + k]! + x[n * q + k]!) >> 1;
            else expected = x[n * p + k]! + x[n * q + k]! - x[n * o + k]!;
            x[n * v + k] = clamp(expected + Math.imul(r[next]!, scale), first, last);
        }
    }
}
