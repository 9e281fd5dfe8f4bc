// Keeps what this page has chosen and shows alone in step with the records: what is gone is neither chosen nor shown alone any more, and
// a rake or surface that is chosen takes the panel from a slice or the body. Shows the body as this page wants it.
import { effect, untracked } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import { hasBoundary, hiddenCells } from '../../state/bodyPatches.ts';
import { bodyId, chosenRake, opacityOf, shows } from '../../state/pageView.ts';
import { newBodyRake, type ViewState } from '../../state/viewState.ts';

export interface ChosenThingsOptions {
    state: Pick<
        AppState,
        | 'activeRake'
        | 'activeSurface'
        | 'allPatchesShown'
        | 'dataset'
        | 'lines'
        | 'pictured'
        | 'rakes'
        | 'slices'
        | 'stage'
        | 'surfaces'
    >;
    view: Pick<ViewState, 'body' | 'changeVisibility' | 'chosenThing' | 'visibility'>;
    scene: { body: Pick<FlowScene['body'], 'setHidden' | 'setOpacity'> };
}

/** Returns the ids of what can be chosen and shown alone. */
export function thingsThere(state: Pick<AppState, 'lines' | 'pictured' | 'rakes' | 'slices' | 'surfaces'>): Set<string> {
    const { rakes, surfaces, slices, lines } = state;
    const there = new Set([rakes, surfaces, slices, lines].flatMap(({ value }) => [...value.keys()]));
    if (state.pictured.value.some((each) => hasBoundary(each))) there.add(bodyId);
    return there;
}

/** For as long as the page lives. */
export function connectChosenThings({ state, view, scene }: ChosenThingsOptions): void {
    effect(() => {
        void [state.activeRake.value, state.activeSurface.value];
        // What is drawn on the body is not lost to what others do to rakes.
        if (view.chosenThing.peek() !== newBodyRake) untracked(() => (view.chosenThing.value = null));
    });
    effect(() => {
        const visibility = view.visibility.value;
        scene.body.setOpacity(shows(visibility, bodyId) ? opacityOf(visibility, bodyId) : 0);
    });
    effect(() => {
        scene.body.setHidden(hiddenCells(state.dataset.value, view.body.value, state.allPatchesShown.value));
    });
    // Only what was there can be gone: a link is read before the records are here.
    const seen = new Set<string>();
    effect(() => {
        const there = thingsThere(state);
        const isGone = (id: string | null): boolean => id !== null && seen.has(id) && !there.has(id);
        for (const id of there) seen.add(id);
        if (isGone(view.chosenThing.value)) view.chosenThing.value = null;
        // A link may show alone what was deleted since; whoever opens it must not see nothing.
        const { only } = view.visibility.value;
        const records = state.stage.value === 'running' && only !== null && only !== chosenRake;
        if (records && !there.has(only)) untracked(() => view.changeVisibility({ only: null }));
    });
}
