// Rakes off bodies and their panel come after the first picture: few pages need them before that. Enter ends the line
// that is drawn.
import { type ReadonlySignal, signal } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { BodyRakesOptions } from '../../session/tools/bodyRakes.ts';
import { isFree } from '../base/keyboard.ts';
import type { BodyRakesModel } from './bodyRakePanel.ts';

/** Null: not loaded yet. */
export function loadBodyRakes(
    options: BodyRakesOptions & { state: AppState; view: ViewState },
): ReadonlySignal<BodyRakesModel | null> {
    const model = signal<BodyRakesModel | null>(null);
    void import('../slices/openedFields.ts').then(({ BodyRakes }) => {
        model.value = { state: options.state, view: options.view, bodyRakes: new BodyRakes(options) };
    });
    addEventListener('keydown', (event) => {
        const { bodyRakes } = model.value ?? {};
        if (event.key !== 'Enter' || !isFree(event) || !bodyRakes?.canEnd) return;
        event.preventDefault();
        void bodyRakes.end();
    });
    return model;
}
