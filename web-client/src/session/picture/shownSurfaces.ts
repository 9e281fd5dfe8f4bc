// Surfaces that this page hides: their subscriptions end, so that the server sends nothing of them, and they
// begin again when the surfaces are shown.
import { effect } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { showsSurface } from '../../state/pageView.ts';

/** For as long as the page lives. */
export function hideSurfaces(state: AppState, view: Pick<ViewState, 'visibility'>): void {
    effect(() => {
        const visibility = view.visibility.value;
        const chosen = state.activeRake.value;
        const hidden = [...state.surfaces.value.values()].filter((each) => !showsSurface(visibility, each, chosen));
        const before = state.hiddenSurfaces.peek();
        if (hidden.length === before.size && hidden.every(({ surface }) => before.has(surface))) return;
        state.hiddenSurfaces.value = new Set(hidden.map(({ surface }) => surface));
    });
}
