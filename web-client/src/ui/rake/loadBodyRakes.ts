// Rakes off bodies and their panel come after the first picture: few pages need them before that.
import { type ReadonlySignal, signal } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { BodyRakesOptions } from '../../session/tools/bodyRakes.ts';
import type { BodyRakesModel } from './bodyRakePanel.ts';

/** Null: not loaded yet. */
export function loadBodyRakes(
    options: BodyRakesOptions & { state: AppState; view: ViewState },
): ReadonlySignal<BodyRakesModel | null> {
    const model = signal<BodyRakesModel | null>(null);
    void import('../slices/openedFields.ts').then(({ BodyRakes }) => {
        model.value = { state: options.state, view: options.view, bodyRakes: new BodyRakes(options) };
    });
    return model;
}
