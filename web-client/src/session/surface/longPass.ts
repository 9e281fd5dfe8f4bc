// Says of a surface that takes long, and what one could have instead.
import { shortNumber } from '../../scene/base/numbers.ts';
import type { AppState, SurfaceStanding } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { SurfaceIntent } from '../edits/surfaceIntent.ts';
import { timeWords } from '../picture/writtenNumbers.ts';
import { withUnit } from '../picture/unitsInPicture.ts';

/** Coarser by so much, where everything else is as fast as it gets. */
const coarser = 2;
/** Rounds an end to this part of the time that the surface was followed for. */
const finestPart = 1000;

/** Returns words like "t = 8.2 of 19.2, 12 345 quads, about 8 s left". Empty: there is nothing to say yet. */
export function standingWords(
    standing: SurfaceStanding,
    state: Pick<AppState, 'dataset' | 'surfaces'>,
    view: Pick<ViewState, 'units'>,
): string {
    const words: string[] = [];
    const to = state.surfaces.value.get(standing.surface)?.to;
    if (standing.time !== null && to !== undefined) {
        const reached = shortNumber(standing.time);
        words.push(`t = ${reached} of ${timeWords(state, view, to)}`);
    } else if (standing.fraction !== null) words.push(`${Math.floor(100 * standing.fraction)} %`);
    if (standing.quads !== null) words.push(`${standing.quads.toLocaleString('en').replaceAll(',', '\u202f')} quads`);
    if (standing.remaining !== null) words.push(leftWords(standing.remaining));
    return words.join(', ');
}

function leftWords(seconds: number): string {
    const about = (count: number, unit: string): string => `about ${Math.max(1, Math.round(count))} ${unit} left`;
    if (seconds < 90) return about(seconds, 's');
    return seconds < 5400 ? about(seconds / 60, 'min') : about(seconds / 3600, 'h');
}

/** A surface that takes less, and words for it. */
export interface LessWork {
    change: Partial<SurfaceIntent>;
    words: string;
}

/** First what costs least of the picture. */
export function faster(intent: SurfaceIntent, view: Pick<ViewState, 'units'>): LessWork[] {
    const separation = intent.separation * coarser;
    const coarse = { change: { separation }, words: `Separation ${withUnit(shortNumber(separation), view.units.value.length)}` };
    if (intent.accuracy === 'fast') return [coarse];
    return [{ change: { accuracy: 'fast' }, words: 'Fast accuracy' }, coarse];
}

/** Ends where the work has come to; null: of a surface all of which is at one time there is no shorter
 *  one. */
export function untilHere(intent: SurfaceIntent, standing: SurfaceStanding, view: Pick<ViewState, 'units'>): LessWork | null {
    if (standing.time === null) return null;
    const unit = 10 ** Math.floor(Math.log10(intent.length / finestPart));
    const length = Math.floor(Math.abs(standing.time - intent.from) / unit) * unit;
    if (!(length > 0 && length < intent.length)) return null;
    const end = intent.from + (intent.direction === 'backward' ? -length : length);
    return { change: { length }, words: `Until t = ${withUnit(shortNumber(end), view.units.value.time)}` };
}
