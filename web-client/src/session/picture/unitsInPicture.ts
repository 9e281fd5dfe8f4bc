// The units in which lengths and times are meant: as people of the session have typed, or else as the reader
// of the data knows.
import { effect } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState, Units } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { Calls } from '../base/calls.ts';

export function showUnits(
    state: Pick<AppState, 'dataset' | 'typedUnits'>,
    view: Pick<ViewState, 'units'>,
    scene: Pick<FlowScene, 'setUnit'>,
): void {
    effect(() => {
        const { lengthUnit = '', timeUnit = '' } = state.dataset.value ?? {};
        const { length, time } = state.typedUnits.value;
        view.units.value = { length: length || lengthUnit, time: time || timeUnit };
        scene.setUnit(view.units.value.length);
    });
}

/** For every user in the session. An empty unit is as the data say. */
export async function typeUnits(state: AppState, calls: Pick<Calls, 'try'>, change: Partial<Units>): Promise<void> {
    const before = state.typedUnits.value;
    const typed = { ...before, ...change };
    const session = state.session.value;
    if (session === null) return;
    state.typedUnits.value = typed;
    if ((await calls.try('session.setUnits', { session, ...typed })) === null && state.typedUnits.value === typed) {
        state.typedUnits.value = before;
    }
}

/** A number with its unit, if there is one. */
export function withUnit(words: string, unit: string): string {
    return unit === '' ? words : `${words} ${unit}`;
}
