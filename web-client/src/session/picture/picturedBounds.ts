// The box round all data in the picture.
import { type Bounds, boundsRound } from '../../scene/domain/domainAxes.ts';
import type { AppState } from '../../state/appState.ts';

/** Null: there are none. */
export function picturedBounds({ pictured }: Pick<AppState, 'pictured'>): Bounds | null {
    const all = pictured.value.map(({ bounds }) => bounds);
    return all.length === 0 ? null : boundsRound(all);
}
