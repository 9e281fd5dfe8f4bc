// Arithmetic of the time-steps: the nearest, the next, what the timeline spans, and its numbers.
import type { DatasetDescription, SurfaceKind } from '../../protocol/messages.ts';
import { labelForm, niceTicks, type Ticks } from '../../scene/base/numbers.ts';
import type { AppState } from '../../state/appState.ts';

export type Span = readonly [low: number, high: number];

export function nearestStep(times: readonly number[], time: number): number {
    let nearest = 0;
    times.forEach((t, i) => {
        if (Math.abs(t - time) < Math.abs((times[nearest] ?? 0) - time)) nearest = i;
    });
    return nearest;
}

/**
 * The time-step after (sign 1) or before (-1) a time, as one presses "step": the end of the span where none
 * is left in it. Data of one time-step have none in between: there it is a twentieth of the span.
 */
export function stepFrom(times: readonly number[], time: number, sign: 1 | -1, [low, high]: Span): number {
    // Of seconds since 1970, a double tells those apart that differ by 2e-7.
    const nearby = Math.max(1e-6 * (high - low), 1e-15 * Math.abs(time));
    const stops = times.length > 1 ? [low, ...times, high] : twentieths(low, high);
    const ahead = stops.filter((t) => sign * (t - time) > nearby && t >= low && t <= high);
    if (ahead.length === 0) return sign > 0 ? high : low;
    return sign > 0 ? Math.min(...ahead) : Math.max(...ahead);
}

function twentieths(low: number, high: number): number[] {
    return Array.from({ length: 21 }, (_, i) => low + ((high - low) * i) / 20);
}

export function clampTo([low, high]: Span, time: number): number {
    return Math.min(high, Math.max(low, time));
}

/** The part of a surface's time in which it is released; of all but streak surfaces none. @param until where
 *  it ends, if earlier */
export function releasedSpan([low, high]: Span, kind: SurfaceKind, backward: boolean, until?: number): Span {
    const from = backward ? high : low;
    const to = kind === 'streak' ? (until ?? (backward ? low : high)) : from;
    return [Math.min(from, to), Math.max(from, to)];
}

/**
 * Where what is shown at `time` has come on the other side of its release, in a surface that goes both ways:
 * as far back as forward, and no further than the data.
 */
export function otherSide(from: number, time: number, times: readonly number[]): number {
    const back = 2 * from - time;
    return times.length > 1 ? Math.max(times[0]!, back) : back;
}

/** All time-steps, and all of the surface; never empty. */
export function timelineSpan(times: readonly number[], surface: Span | null): Span {
    const all = [...times, ...(surface ?? [])].filter(Number.isFinite);
    const low = all.length === 0 ? 0 : Math.min(...all);
    const high = all.length === 0 ? 1 : Math.max(...all);
    return high > low ? [low, high] : [low, low + 1];
}

/** Every how many time-steps there may be a number. */
const strides = [1, 2, 5];

/**
 * Numbers for the line of time, about `wanted` of them, each at a time-step, because its mark stands above
 * it. Where a series has fewer than two steps in the span, round numbers.
 */
export function stepTicks(times: readonly number[], [low, high]: Span, wanted: number): Ticks {
    const within = times.filter((time) => time >= low && time <= high);
    if (within.length < 2) return niceTicks(low, high, wanted);
    const least = within.length / Math.max(1, wanted);
    const power = 10 ** Math.floor(Math.log10(Math.max(1, least)));
    const stride = power * (strides.find((each) => each * power >= least) ?? 10);
    const shown = within.filter((_, i) => i % stride === 0);
    const gap = Math.min(...shown.slice(1).map((time, i) => time - shown[i]!), high - low);
    const { shared, label } = labelForm(low, high, 10 ** -decimalsOf(shown, gap));
    return { ticks: shown.map((value) => ({ value, label: label(value) })), shared };
}

/** Returns as few decimals as tell each value, to a hundredth of the gap between two. */
function decimalsOf(values: readonly number[], gap: number): number {
    for (let decimals = 0; decimals < 12; ++decimals) {
        if (values.every((value) => Math.abs(Number(value.toFixed(decimals)) - value) <= 0.01 * gap)) return decimals;
    }
    return 12;
}

/** The time at which data are sampled for a picture: of a series the nearest that it has. Null: the data have one time. @param shown no number
 *  where nothing has a time */
export function dataTime(
    { times, steady, grid }: Pick<DatasetDescription, 'times' | 'steady' | 'grid'>,
    shown: number,
): number | null {
    if (steady || times.length < 2) return null;
    const [first = 0, last = first] = [times[0], times.at(-1)];
    const time = Number.isNaN(shown) ? first : shown;
    return grid === 'analytic' ? time : clampTo([first, last], time);
}

/** Returns the time of the selected surface; where there is none, of the clock or of the first time-step. */
export function shownTime({ activeSurface, displayed, clock, times }: AppState): number {
    const shown = displayed.value.get(activeSurface.value ?? '');
    return shown?.time ?? clock.value?.time ?? times.value[0] ?? 0;
}
