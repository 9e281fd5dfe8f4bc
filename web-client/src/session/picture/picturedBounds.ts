// The box round all data in the picture.
import { type Bounds, boundsRound } from '../../scene/domain/domainAxes.ts';
import type { AppState } from '../../state/appState.ts';

/** Null: there are none. */
export function picturedBounds({ pictured }: Pick<AppState, 'pictured'>): Bounds | null {
    const all = pictured.value.map(({ bounds }) => bounds);
    return all.length === 0 ? null : boundsRound(all);
}

/** The box in which cut planes are placed by fractions: that of the first data that the session has something of, so that others may
 *  come and go, or be worked on, without moving them. Null: there is none. */
export function clipBounds(state: Pick<AppState, 'dataset' | 'described' | 'lines' | 'slices' | 'surfaces'>): Bounds | null {
    const [first] = [state.surfaces, state.slices, state.lines].flatMap(({ value }) => [...value.values()]);
    return (state.described(first?.dataset ?? '') ?? state.dataset.value)?.bounds ?? null;
}
