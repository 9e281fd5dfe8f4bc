// Says whether what is taken out of the page is less than was asked for: names of files, and pictures, say
// so.
import type { AppState } from '../../state/appState.ts';

export const coarseCaption = 'Coarse, not the final surface';

/** A surface that is in the picture has not become final. */
export function pictureIsCoarse({ displayed, hiddenSurfaces }: Pick<AppState, 'displayed' | 'hiddenSurfaces'>): boolean {
    const hidden = hiddenSurfaces.value;
    return [...displayed.value.values()].some(
        ({ surface, phase }) => !hidden.has(surface) && (phase === 'coarse' || phase === 'refined'),
    );
}

/** Returns whether there is something of the selected surface that is not final. */
export function meshIsCoarse({ displayed, activeSurface }: Pick<AppState, 'displayed' | 'activeSurface'>): boolean {
    const phase = displayed.value.get(activeSurface.value ?? '')?.phase;
    return phase === 'coarse' || phase === 'refined';
}
