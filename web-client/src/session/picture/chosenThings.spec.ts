import { describe, expect, it } from 'vitest';
import type { SliceRecord } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { newBodyRake, newSlice, ViewState } from '../../state/viewState.ts';
import { connectChosenThings } from './chosenThings.ts';

const slice: SliceRecord = { slice: 'c1', rev: 1, dataset: 'flow', origin: [0, 0, 1], normal: [0, 0, 1], field: 'U' };

/** A page whose link shows one thing alone, before it is in its session. */
function opened(only: string) {
    const [state, view] = [new AppState(), new ViewState()];
    view.changeVisibility({ only });
    connectChosenThings({
        state,
        view,
        scene: { body: { setOpacity: () => undefined, setHidden: () => undefined } },
    });
    return { state, view };
}

describe('a link that shows one thing alone', () => {
    it('shows it once the records are there', () => {
        const { state, view } = opened('c1');
        expect(view.visibility.value.only).toBe('c1');
        state.slices.value = new Map([['c1', slice]]);
        state.stage.value = 'running';
        expect(view.visibility.value.only).toBe('c1');
    });

    it('shows everything where that was deleted since', () => {
        const { state, view } = opened('c9');
        state.slices.value = new Map([['c1', slice]]);
        state.stage.value = 'running';
        expect(view.visibility.value.only).toBeNull();
    });
});

describe('what is chosen', () => {
    it('may be there before its record, and is not when that is deleted', () => {
        const { state, view } = opened('c1');
        state.stage.value = 'running';
        view.chosenThing.value = 'c1';
        expect(view.chosenThing.value).toBe('c1');
        state.slices.value = new Map([['c1', slice]]);
        expect(view.chosenThing.value).toBe('c1');
        state.slices.value = new Map();
        expect(view.chosenThing.value).toBeNull();
    });

    it('yields to a rake that becomes the active one, but for a line that is being drawn on the body', () => {
        const { state, view } = opened('c1');
        view.chosenThing.value = newSlice;
        state.activeRake.value = 'r1';
        expect(view.chosenThing.value).toBeNull();
        view.chosenThing.value = newBodyRake;
        state.activeRake.value = 'r2';
        expect(view.chosenThing.value).toBe(newBodyRake);
    });
});
