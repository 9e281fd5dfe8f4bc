// Another kind for the surface that is being worked on: the time of the picture stays, and where it cannot,
// words say so.
import type { SurfaceKind } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import type { AppState } from '../../state/appState.ts';
import type { Edits } from '../edits/edits.ts';
import { followed } from '../edits/surfaceTimes.ts';
import type { SurfaceIntent } from '../edits/surfaceIntent.ts';
import type { ClockControl } from './clockControl.ts';
import type { Playback } from './playback.ts';
import { nearestStep } from './timeSteps.ts';

export interface KindChoice {
    state: Pick<AppState, 'surfaceTimes' | 'surfaceDataset' | 'clock' | 'suggestion'>;
    edits: Pick<Edits, 'intent' | 'changeSurface'>;
    clock: Pick<ClockControl, 'set'>;
    playback: Pick<Playback, 'time'>;
}

/** What makes it another kind that is shown at a time. */
interface Times {
    from: number;
    length: number;
    /** The time of the picture, afterwards. */
    shown: number;
}

export function chooseKind({ state, edits, clock, playback }: KindChoice, kind: SurfaceKind): void {
    const before = edits.intent.value;
    if (before === null || before.kind === kind) return;
    const steady = state.surfaceDataset.value?.steady ?? false;
    const shownBefore = playback.time.value;
    const suggested = suggestedOf(state, kind);
    const times = state.surfaceTimes.value;
    const after = steady
        ? steadyTimes(before, kind)
        : kind === 'stream'
          ? frozenTimes(times, shownBefore, suggested?.length ?? before.length)
          : movingTimes(before, { ...before, kind }, shownBefore, times, suggested, suggestedOf(state, before.kind));
    const separation = chosenSeparation(before, suggested?.separation, suggestedOf(state, before.kind)?.separation);
    const change = { kind, from: after.from, length: after.length, separation };
    edits.changeSurface(change, undefined, jumpWords(shownBefore, after, steady));
    // A clock that was never set shows the end.
    const clockTime = state.clock.value?.time ?? null;
    if (kind !== 'stream' && !steady && clockTime !== null && clockTime !== after.shown) clock.set(after.shown);
}

interface Suggested {
    from: number;
    length: number;
    separation: number;
}

function suggestedOf({ suggestion }: Pick<AppState, 'suggestion'>, kind: SurfaceKind): Suggested | null {
    const found = suggestion.value?.surfaces.find((each) => each.kind === kind);
    return found === undefined ? null : { from: found.from, length: found.to - found.from, separation: found.separation };
}

/** One that the user has chosen stays. */
function chosenSeparation(before: SurfaceIntent, now: number | undefined, then: number | undefined): number {
    return now !== undefined && before.separation === then ? now : before.separation;
}

function steadyTimes({ from, length, kind: old }: SurfaceIntent, kind: SurfaceKind): Times {
    return { from, length, shown: kind === 'stream' ? from : old === 'stream' ? from + length : Number.NaN };
}

function frozenTimes(times: readonly number[], shown: number, length: number): Times {
    const from = times[nearestStep(times, shown)] ?? shown;
    return { from, length, shown: from };
}

/** @param suggested,then  of the new kind, and of the one before */
function movingTimes(
    before: SurfaceIntent,
    wanted: SurfaceIntent,
    shown: number,
    times: readonly number[],
    suggested: Suggested | null,
    then: Suggested | null,
): Times {
    const [first, last] = [times[0] ?? shown, times.at(-1) ?? shown];
    if (before.kind !== 'stream') {
        const usual = suggested !== null && then !== null && before.from === then.from && before.length >= then.length;
        const covers = suggested !== null && shown >= suggested.from && shown <= suggested.from + suggested.length;
        if (usual && covers && before.direction === 'forward') {
            return { from: suggested.from, length: suggested.length, shown };
        }
        return { from: before.from, length: before.length, shown };
    }
    const length = Math.min(suggested?.length ?? before.length, last - first);
    if (before.direction === 'backward') {
        // Shown where it ends, so released later than that.
        const from = times[nearestStep(times, Math.min(last, shown + length))] ?? last;
        if (from > shown) return { from, length: from - shown, shown };
    } else if (shown > first) {
        const from = times[nearestStep(times, Math.max(first, shown - length))] ?? first;
        if (from < shown) return { from, length: shown - from, shown };
    }
    // Nothing is there yet at this time: from here on.
    const backward = before.direction === 'backward';
    const from = backward ? last : first;
    const whole = followed({ ...wanted, from, length }, times, false);
    return { from, length: whole, shown: from + (backward ? -whole : whole) };
}

function jumpWords(before: number, { shown }: Times, steady: boolean): string | null {
    if (steady || !Number.isFinite(before) || Math.abs(shown - before) <= 1e-9 * Math.max(1, Math.abs(before))) return null;
    return `Shown at ${shortNumber(shown)} now, no longer at ${shortNumber(before)}: this kind has nothing to show then.`;
}
