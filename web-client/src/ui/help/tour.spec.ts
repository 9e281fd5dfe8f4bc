// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { datasetOf } from '../../testing/records.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './helpDialog.ts';
import { type TourFacts, tourSteps } from './tour.ts';
import './tour.ts';

function wordsOf(id: string, facts: { touch: boolean; narrow: boolean }): string {
    const [state, view] = [new AppState(), new ViewState()];
    state.dataset.value = datasetOf({ times: [0, 1, 2], steady: false });
    const edits = { intent: { value: null } };
    const rest = { state, view, edits, ...facts } as unknown as TourFacts;
    return tourSteps.find((step) => step.id === id)!.words(rest);
}

describe('the tour', () => {
    it('speaks of fingers where there is no mouse, and of a mouse where there is one', () => {
        expect(wordsOf('turn', { touch: true, narrow: false })).toMatch(/one finger.*two fingers.*pinch/);
        expect(wordsOf('turn', { touch: true, narrow: false })).not.toMatch(/button|scroll/);
        expect(wordsOf('turn', { touch: false, narrow: true })).toMatch(/right button.*scroll/);
    });

    it('says where the settings are on this screen', () => {
        expect(wordsOf('kind', { touch: false, narrow: false })).toContain('On the right');
        expect(wordsOf('kind', { touch: true, narrow: true })).toContain('Below the picture');
    });
});

let bench: PageBench;
let tour: ShownPanel;
/** The camera has moved: a picture is drawn. */
let turn: (pose: string) => void;

/** A page is opened by the same browser. */
async function visit(): Promise<void> {
    bench = new PageBench();
    const controls = { pose: 'as at first' };
    const onDraw = (heard: () => void): void => {
        turn = (pose) => {
            controls.pose = pose;
            heard();
        };
    };
    tour = await ShownPanel.of('wakesurf-tour', Object.assign(bench, { scene: { controls, onDraw } }));
}

const steps = (): (string | null)[] => tour.all('[data-step]').map((card) => card.getAttribute('data-step'));

async function leads(act: () => unknown, step: string): Promise<void> {
    void act();
    await rested();
    expect(steps()).toEqual([step]);
}

beforeEach(() => {
    localStorage.clear();
    return visit();
});

it('a first visit is led from the rake to sharing, by doing what the tour says', async () => {
    expect(steps()).toEqual(['drag']);
    await leads(() => turn('from elsewhere'), 'drag');
    await leads(() => bench.edits.changeRake('rake-1', { seeds: 40 }), 'turn');
    await leads(() => turn('from elsewhere'), 'turn');
    await leads(() => turn('from above'), 'play');
    await leads(() => bench.playback.toggle(), 'kind');
    await leads(() => bench.chooseKind('streak'), 'look');
    await leads(() => bench.view.changeLook('surface-1', { map: 'cividis' }), 'share');
    await tour.press('Done');
    expect(steps()).toEqual([]);
});

it('whoever has sent the tour away sees it again on request alone', async () => {
    await tour.press('Next');
    expect(steps()).toEqual(['turn']);
    await tour.press('Skip the tour');
    await visit();
    expect(steps()).toEqual([]);
    document.body.append(Object.assign(document.createElement('wakesurf-help'), { model: bench }));
    await rested();
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: '?', bubbles: true }));
    await rested();
    const dialog = tour.get<HTMLDialogElement>('dialog');
    expect(dialog.open).toBe(true);
    await tour.press('Show the tour');
    expect([dialog.open, steps()]).toEqual([false, ['drag']]);
    bench.state.role.value = 'viewer';
    await rested();
    expect(steps()).toEqual([]);
});
