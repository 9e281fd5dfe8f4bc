// Says whether what is on the screen of a surface is all that a picture of it will have: what saved pictures
// and films wait for.
import type { SurfaceRecord } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { attributesOf } from '../picture/surfaceStyleOf.ts';
import { clampTo, type Span } from '../time/timeSteps.ts';

/** Why it is not; empty where it is. Of a failed surface it says what is missing, for ever. `time`: of the
 *  clock, null: as it is. */
export function unfinishedSurface(
    state: Pick<AppState, 'displayed' | 'hiddenSurfaces' | 'requestedEpochs'>,
    view: Pick<ViewState, 'lookOf'>,
    { surface, kind, from, to }: SurfaceRecord,
    time: number | null,
): string {
    if (state.hiddenSurfaces.value.has(surface)) return '';
    const displayed = state.displayed.value.get(surface);
    if (displayed === undefined || displayed.epoch < (state.requestedEpochs.value.get(surface) ?? 0)) {
        return `${surface} is not there`;
    }
    if (displayed.phase !== 'final') return `${surface} is ${displayed.phase}`;
    // Without them it is drawn as if they never came: colours of before, smoke as the picture guesses it.
    const look = view.lookOf(surface);
    const missing = attributesOf(look).filter((name) => displayed.withheld.includes(name));
    if (missing.length > 0) return `${surface} has no ${missing.join(', ')} yet`;
    if (look.curved && !displayed.curved) return `the cells of ${surface} are not curved yet`;
    if (time !== null && kind !== 'stream' && !isShownAt({ from, to }, displayed.time, time)) {
        return `${surface} is shown at ${displayed.time}`;
    }
    return '';
}

/** Returns whether a surface that moves is drawn as it is at a time, or at its end that is nearer; backward
 *  ones end before `from`. */
export function isShownAt({ from, to }: { from: number; to: number }, shown: number, time: number): boolean {
    const span: Span = [Math.min(from, to), Math.max(from, to)];
    return Math.abs(shown - clampTo(span, time)) <= 1e-6 * (span[1] - span[0]);
}
