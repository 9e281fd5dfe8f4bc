// The axes of a plot: lines of one group share one, which holds all their values and has round numbers. The picture on the page and the
// file in SVG take them from here, so that they cannot disagree.
import { niceTicks, type Ticks } from '../../scene/base/numbers.ts';
import { type Plot, type Series, titleOf } from './plot.ts';

export interface PlotAxis {
    group: string;
    title: string;
    range: readonly [number, number];
    /** Of the plot's, by number. */
    series: readonly number[];
}

/** Room above and below the lines, as a part of their range. */
const margin = 0.06;
/** Pixels from one number to the next, about. */
const apart = { across: 80, up: 28 };

export function rangeOf(values: Iterable<number>): [number, number] | null {
    let [low, high] = [Infinity, -Infinity];
    for (const value of values) {
        if (!Number.isFinite(value)) continue;
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    return low <= high ? [low, high] : null;
}

export function axesOf({ series }: Plot): PlotAxis[] {
    return [...new Set(series.map(({ group }) => group))].map((group) => {
        const numbers = series.map((_, i) => i).filter((i) => series[i]!.group === group);
        return {
            group,
            title: axisTitle(numbers.map((i) => series[i]!)),
            range: withMargin(rangeOfAll(series, numbers)),
            series: numbers,
        };
    });
}

function rangeOfAll(series: readonly Series[], numbers: readonly number[]): [number, number] {
    const ranges = numbers.map((i) => rangeOf(series[i]!.values)).filter((range) => range !== null);
    return rangeOf(ranges.flat()) ?? [0, 1];
}

/** One value alone has room as well. */
function withMargin([low, high]: readonly [number, number]): [number, number] {
    const room = high > low ? margin * (high - low) : Math.abs(low) * 0.1 || 1;
    return [low - room, high + room];
}

/** "p, q [Pa]": what shares an axis has one unit. */
function axisTitle(of: readonly Series[]): string {
    const [first] = of;
    return titleOf({ name: of.map(({ name }) => name).join(', '), unit: first?.unit ?? '' });
}

export function ticksAcross(low: number, high: number, pixels: number): Ticks {
    return niceTicks(low, high, Math.max(2, pixels / apart.across));
}

export function ticksUp(low: number, high: number, pixels: number): Ticks {
    return niceTicks(low, high, Math.max(4, pixels / apart.up));
}

/** Of an axis, with what all its numbers share. */
export function withShared(title: string, { shared }: Ticks): string {
    return shared === '' ? title : `${title} (${shared})`;
}

/** Of lines, in turn: each is told from the others, and from a light and a dark ground. */
export const lineColours = ['#0b84c6', '#d1630a', '#1f9a5b', '#b455b6', '#a67c00', '#d6455d'] as const;
