// The simulation time of what is on the screen.
import type { AppState } from '../../state/appState.ts';

/** Returns the time of the selected surface; where there is none, of the clock or of the first time-step. */
export function shownTime({ activeSurface, displayed, clock, times }: AppState): number {
    const shown = displayed.value.get(activeSurface.value ?? '');
    return shown?.time ?? clock.value?.time ?? times.value[0] ?? 0;
}
