// The predictors: what both ends expect of a vertex before its residual. protocol/wire/README.md, Points.
// Sums are exact in double precision and cut to 32 bits once, which is to wrap. Twin: protocol/wire/wire_predict.hpp.
import type { Channel } from './wireMesh.ts';
import { type Neighbours, none } from './wireTopology.ts';

export const movePredictors = 6;
export const appendPredictors = 8;
export const changePredictor = 0;

const largestChange = 1 << 20;

/** Residuals of consecutive vertices, from `at` on; each counts `scale` steps. */
export interface Residuals {
    values: Int32Array;
    at: number;
    scale: number;
}

function clamp(value: number, last: number): number {
    const wrapped = value | 0;
    return wrapped < 0 ? 0 : wrapped > last ? last : wrapped;
}

/** Moved vertices from .. to - 1. */
export function move(
    channel: Channel,
    near: Neighbours,
    predictor: number,
    from: number,
    to: number,
    residuals: Residuals,
): void {
    if (channel.components === 3) movePositions(channel, near, predictor, from, to, residuals);
    else moveCodes(channel, near, predictor, from, to, residuals);
}

/** Three components at a time: nearly all of the work of an update is here. */
function movePositions(
    { last, values: x, change: d, changeBefore: h }: Channel,
    { highest, lowest, beside, beside2, opposite }: Neighbours,
    predictor: number,
    from: number,
    to: number,
    { values: r, at, scale }: Residuals,
): void {
    for (let v = from, next = 3 * at; v < to; ++v, next += 3) {
        const i = 3 * v;
        const a = 3 * highest[v]!;
        const b = 3 * lowest[v]!;
        let c0 = 0;
        let c1 = 0;
        let c2 = 0;
        if (a < 0 || predictor === 0) {
            c0 = h[i]!;
            c1 = h[i + 1]!;
            c2 = h[i + 2]!;
        } else if (predictor === 1) {
            c0 = d[a]!;
            c1 = d[a + 1]!;
            c2 = d[a + 2]!;
        } else if (predictor === 3) {
            c0 = (h[i]! + d[a]! - h[a]!) | 0;
            c1 = (h[i + 1]! + d[a + 1]! - h[a + 1]!) | 0;
            c2 = (h[i + 2]! + d[a + 2]! - h[a + 2]!) | 0;
        } else if (predictor === 4) {
            c0 = (h[i]! + ((d[a]! - h[a]! + d[b]! - h[b]!) >> 1)) | 0;
            c1 = (h[i + 1]! + ((d[a + 1]! - h[a + 1]! + d[b + 1]! - h[b + 1]!) >> 1)) | 0;
            c2 = (h[i + 2]! + ((d[a + 2]! - h[a + 2]! + d[b + 2]! - h[b + 2]!) >> 1)) | 0;
        } else if (predictor === 5 && opposite[v]! >= 0) {
            const p = 3 * beside[v]!;
            const n = 3 * beside2[v]!;
            const o = 3 * opposite[v]!;
            c0 = (d[p]! + d[n]! - d[o]!) | 0;
            c1 = (d[p + 1]! + d[n + 1]! - d[o + 1]!) | 0;
            c2 = (d[p + 2]! + d[n + 2]! - d[o + 2]!) | 0;
        } else {
            c0 = (d[a]! + d[b]!) >> 1;
            c1 = (d[a + 1]! + d[b + 1]!) >> 1;
            c2 = (d[a + 2]! + d[b + 2]!) >> 1;
        }
        const x0 = x[i]!;
        const x1 = x[i + 1]!;
        const x2 = x[i + 2]!;
        const y0 = clamp(x0 + c0 + Math.imul(r[next]!, scale), last);
        const y1 = clamp(x1 + c1 + Math.imul(r[next + 1]!, scale), last);
        const y2 = clamp(x2 + c2 + Math.imul(r[next + 2]!, scale), last);
        x[i] = y0;
        x[i + 1] = y1;
        x[i + 2] = y2;
        d[i] = y0 - x0;
        d[i + 1] = y1 - x1;
        d[i + 2] = y2 - x2;
    }
}

/** Codes remember no earlier change: h is 0. */
function moveCodes(
    { last, values: x, change: d }: Channel,
    { highest, lowest, beside, beside2, opposite }: Neighbours,
    predictor: number,
    from: number,
    to: number,
    { values: r, at, scale }: Residuals,
): void {
    for (let v = from, next = at; v < to; ++v, ++next) {
        const a = highest[v]!;
        const b = lowest[v]!;
        let change = 0;
        if (a < 0 || predictor === 0) change = 0;
        else if (predictor === 1 || predictor === 3) change = d[a]!;
        else if (predictor === 5 && opposite[v]! >= 0) change = (d[beside[v]!]! + d[beside2[v]!]! - d[opposite[v]!]!) | 0;
        else change = (d[a]! + d[b]!) >> 1;
        const before = x[v]!;
        const after = clamp(before + change + Math.imul(r[next]!, scale), last);
        x[v] = after;
        d[v] = after - before;
    }
}

/** What is used where the neighbours of an appended vertex do not suffice for `predictor`. */
function usable(near: Neighbours, predictor: number, v: number, stayed: number): number {
    const a = near.highest[v]!;
    const b = near.lowest[v]!;
    if (a < 0) return 0;
    switch (predictor) {
        case 7:
            return b < stayed ? 7 : 1;
        case 5:
            if (near.lowest[b]! >= 0 && near.lowest[a]! >= 0 && near.lowest[near.lowest[a]!]! >= 0) return 5;
            return usable(near, 4, v, stayed);
        case 4:
            return near.beside[v]! >= 0 ? 4 : usable(near, 2, v, stayed);
        case 3:
            return near.lowest[b]! >= 0 ? 3 : 1;
        case 2:
            return near.highest[a]! >= 0 ? 2 : 0;
        default:
            return predictor;
    }
}

/** Appended vertices from .. to - 1; the first `stayed` were there before the update. */
export function append(
    channel: Channel,
    near: Neighbours,
    predictor: number,
    from: number,
    to: number,
    residuals: Residuals,
    stayed: number,
): void {
    const { components: n, last, values: x, change: d } = channel;
    const { values: r, scale } = residuals;
    const { highest, lowest, beside, beside2, opposite } = near;
    let next = residuals.at * n;
    for (let v = from; v < to; ++v) {
        const formula = usable(near, predictor, v, stayed);
        const hasNeighbour = highest[v]! >= 0;
        const a = hasNeighbour ? highest[v]! : v - 1;
        const b = lowest[v]!;
        for (let i = v * n, k = 0; k < n; ++i, ++k, ++next) {
            let expected = 0;
            switch (formula) {
                case 0:
                    expected = a < 0 ? 0 : x[a * n + k]!;
                    break;
                case 1:
                    expected = x[b * n + k]!;
                    break;
                case 2:
                    expected = 2 * x[a * n + k]! - x[highest[a]! * n + k]!;
                    break;
                case 3:
                    expected = 2 * x[b * n + k]! - x[lowest[b]! * n + k]!;
                    break;
                case 4:
                    expected = x[beside[v]! * n + k]! + x[beside2[v]! * n + k]!;
                    expected = opposite[v]! < 0 ? expected >> 1 : expected - x[opposite[v]! * n + k]!;
                    break;
                case 5: {
                    const ba = lowest[a]!;
                    expected = 2 * x[b * n + k]! - x[lowest[b]! * n + k]! + x[a * n + k]!;
                    expected += x[lowest[ba]! * n + k]! - 2 * x[ba * n + k]!;
                    break;
                }
                case 6:
                    expected = (x[a * n + k]! + x[b * n + k]!) >> 1;
                    break;
                default:
                    expected = x[b * n + k]! - d[b * n + k]!;
            }
            x[i] = clamp(expected + Math.imul(r[next]!, scale), last);
        }
    }
}

function meanChange(d: Int32Array, near: Neighbours, v: number, k: number): number {
    const a = near.highest[v]!;
    return a === none ? 0 : (d[3 * a + k]! + d[3 * near.lowest[v]! + k]!) >> 1;
}

/** The changes of positions that a KEY sends for its vertices from .. to - 1. */
export function takeChanges(d: Int32Array, near: Neighbours, from: number, to: number, residuals: Residuals): void {
    let next = residuals.at * 3;
    for (let v = from; v < to; ++v) {
        for (let k = 0; k < 3; ++k, ++next) {
            const change = (meanChange(d, near, v, k) + residuals.values[next]!) | 0;
            d[3 * v + k] = Math.min(largestChange, Math.max(-largestChange, change));
        }
    }
}

/** Appended vertices from .. to - 1 are taken to have moved as their neighbours did. */
export function assumeChanges(d: Int32Array, near: Neighbours, from: number, to: number): void {
    for (let v = from; v < to; ++v) for (let k = 0; k < 3; ++k) d[3 * v + k] = meanChange(d, near, v, k);
}
