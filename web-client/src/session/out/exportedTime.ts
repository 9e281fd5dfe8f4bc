// Which time a file is of, in words for the panel and in the names of files.
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { timeWords } from '../picture/writtenNumbers.ts';
import { clampTo } from '../time/timeSteps.ts';

/** Returns the time of the selected surface's mesh, which the server writes as it is at the time of its
 *  clock; empty without a surface. */
export function meshTimeWords(state: AppState, view: Pick<ViewState, 'units'>): string {
    const record = state.surface.value;
    if (record === undefined) return '';
    const words = (time: number): string => `t = ${timeWords(state, view, time)}`;
    if (record.kind === 'stream') return `Of the flow as it is at ${words(record.from)}.`;
    const clock = state.clock.value;
    const time = clock?.time ?? null;
    if (clock?.playing === true) return 'As it is at the time of the clock when you press. The file says which.';
    if (time === null) return `As it is at its end, ${words(record.to)}.`;
    const span = [Math.min(record.from, record.to), Math.max(record.from, record.to)] as const;
    return `As it is at ${words(clampTo(span, time))}, the time of the clock.`;
}

/** Returns a text like "t12.5". */
export function timeInName(time: number): string {
    return `t${Number(time.toPrecision(10))}`;
}
