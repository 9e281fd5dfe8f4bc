import { describe, expect, it } from 'vitest';
import { datasetOf } from '../../testing/records.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { type TourFacts, tourSteps } from './tourSteps.ts';

function wordsOf(id: string, facts: { touch: boolean; narrow: boolean }): string {
    const [state, view] = [new AppState(), new ViewState()];
    state.dataset.value = datasetOf({ times: [0, 1, 2], steady: false });
    const rest = { state, view, ...facts } as unknown as TourFacts;
    return tourSteps.find((step) => step.id === id)!.words(rest);
}

describe('the tour', () => {
    it('speaks of fingers where there is no mouse, and of a mouse where there is one', () => {
        expect(wordsOf('turn', { touch: true, narrow: false })).toMatch(/one finger.*two fingers.*pinch/);
        expect(wordsOf('turn', { touch: true, narrow: false })).not.toMatch(/button|scroll/);
        expect(wordsOf('turn', { touch: false, narrow: true })).toMatch(/right button.*scroll/);
    });

    it('says where the settings are on this screen', () => {
        expect(wordsOf('streak', { touch: false, narrow: false })).toContain('On the right');
        expect(wordsOf('streak', { touch: true, narrow: true })).toContain('Below the picture');
    });
});
