// @vitest-environment happy-dom
import { beforeEach, expect, it } from 'vitest';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './helpDialog.ts';
import './tour.ts';

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
    await leads(() => turn('from above'), 'streak');
    await leads(() => bench.chooseKind('path'), 'streak');
    await leads(() => bench.chooseKind('streak'), 'play');
    await leads(() => bench.playback.toggle(), 'look');
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
