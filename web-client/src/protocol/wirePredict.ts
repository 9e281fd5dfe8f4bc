// The predictors: what both ends expect of a vertex before its residual. protocol/README.md, Points.
// Sums are exact in double precision and cut to 32 bits once, which is to wrap. Twin: protocol/wire_predict.hpp.
import type { Channel } from './wireMesh.ts';
import { type Neighbours, none } from './wireTopology.ts';

export const movePredictors = 6;
export const appendPredictors = 8;
export const changePredictor = 0;

const largestChange = 1 << 20;

/// Residuals of consecutive vertices, from `at` on; each counts `scale` steps.
export interface Residuals {
    values: Int32Array;
    at: number;
    scale: number;
}

function clamp(value: number, last: number): number {
    const wrapped = value | 0;
    return wrapped < 0 ? 0 : wrapped > last ? last : wrapped;
}

/// Moved vertices from .. to - 1.
export function move(
    channel: Channel,
    near: Neighbours,
    predictor: number,
    from: number,
    to: number,
    residuals: Residuals,
): void {
    const { components: n, last, values: x, change: d, changeBefore: h } = channel;
    const { values: r, scale } = residuals;
    let next = residuals.at * n;
    for (let v = from; v < to; v += 1) {
        const a = near.highest[v]! * n;
        const b = near.lowest[v]! * n;
        let formula = a < 0 ? 0 : predictor;
        if (formula === 5 && near.opposite[v]! < 0)
            formula = 2;
        for (let i = v * n, k = 0; k < n; i += 1, k += 1, next += 1) {
            let change = 0;
            switch (formula) {
                case 0:
                    change = h[i]!;
                    break;
                case 1:
                    change = d[a + k]!;
                    break;
                case 2:
                    change = (d[a + k]! + d[b + k]!) >> 1;
                    break;
                case 3:
                    change = h[i]! + d[a + k]! - h[a + k]!;
                    break;
                case 4:
                    change = h[i]! + ((d[a + k]! - h[a + k]! + d[b + k]! - h[b + k]!) >> 1);
                    break;
                default:
                    change = d[near.beside[v]! * n + k]! + d[near.beside2[v]! * n + k]! - d[near.opposite[v]! * n + k]!;
            }
            const before = x[i]!;
            const after = clamp(before + change + r[next]! * scale, last);
            x[i] = after;
            d[i] = after - before;
        }
    }
}

/// What is used where the neighbours of an appended vertex do not suffice for `predictor`.
function usable(near: Neighbours, predictor: number, v: number, stayed: number): number {
    const a = near.highest[v]!;
    const b = near.lowest[v]!;
    if (a < 0)
        return 0;
    switch (predictor) {
        case 7:
            return b < stayed ? 7 : 1;
        case 5:
            if (near.lowest[b]! >= 0 && near.lowest[a]! >= 0 && near.lowest[near.lowest[a]!]! >= 0)
                return 5;
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

/// Appended vertices from .. to - 1; the first `stayed` were there before the update.
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
    let next = residuals.at * n;
    for (let v = from; v < to; v += 1) {
        const formula = usable(near, predictor, v, stayed);
        const hasNeighbour = near.highest[v]! >= 0;
        const a = hasNeighbour ? near.highest[v]! : v - 1;
        const b = near.lowest[v]!;
        const of = (id: number, k: number): number => x[id * n + k]!;
        for (let i = v * n, k = 0; k < n; i += 1, k += 1, next += 1) {
            let expected = 0;
            switch (formula) {
                case 0:
                    expected = a < 0 ? 0 : of(a, k);
                    break;
                case 1:
                    expected = of(b, k);
                    break;
                case 2:
                    expected = 2 * of(a, k) - of(near.highest[a]!, k);
                    break;
                case 3:
                    expected = 2 * of(b, k) - of(near.lowest[b]!, k);
                    break;
                case 4:
                    expected = of(near.beside[v]!, k) + of(near.beside2[v]!, k);
                    expected = near.opposite[v]! < 0 ? expected >> 1 : expected - of(near.opposite[v]!, k);
                    break;
                case 5: {
                    const ba = near.lowest[a]!;
                    expected = 2 * of(b, k) - of(near.lowest[b]!, k) + of(a, k) - 2 * of(ba, k) + of(near.lowest[ba]!, k);
                    break;
                }
                case 6:
                    expected = (of(a, k) + of(b, k)) >> 1;
                    break;
                default:
                    expected = of(b, k) - d[b * n + k]!;
            }
            x[i] = clamp(expected + r[next]! * scale, last);
        }
    }
}

function meanChange(d: Int32Array, near: Neighbours, v: number, k: number): number {
    const a = near.highest[v]!;
    return a === none ? 0 : (d[3 * a + k]! + d[3 * near.lowest[v]! + k]!) >> 1;
}

/// The changes of positions that a KEY sends for its vertices from .. to - 1.
export function takeChanges(d: Int32Array, near: Neighbours, from: number, to: number, residuals: Residuals): void {
    let next = residuals.at * 3;
    for (let v = from; v < to; v += 1)
        for (let k = 0; k < 3; k += 1, next += 1) {
            const change = (meanChange(d, near, v, k) + residuals.values[next]!) | 0;
            d[3 * v + k] = Math.min(largestChange, Math.max(-largestChange, change));
        }
}

/// Appended vertices from .. to - 1 are taken to have moved as their neighbours did.
export function assumeChanges(d: Int32Array, near: Neighbours, from: number, to: number): void {
    for (let v = from; v < to; v += 1)
        for (let k = 0; k < 3; k += 1)
            d[3 * v + k] = meanChange(d, near, v, k);
}
