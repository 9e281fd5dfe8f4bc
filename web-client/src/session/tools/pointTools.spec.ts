import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import type { Pointer } from '../../scene/base/pointerTools.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { answering, type Params, settled } from '../../testing/fakes.ts';
import { datasetOf, fieldOf } from '../../testing/records.ts';
import { Measuring, nothingThere, Noting, Probing } from './pointTools.ts';

/** A picture in which x of the canvas is x of space, with a surface to the left of 100, a rake from 200 to
 *  260 and nothing else. */
function bench() {
    const state = new AppState();
    const pageView = new ViewState();
    const fields = [fieldOf('U', { components: 3 }), fieldOf('p'), fieldOf('mask')];
    state.dataset.value = datasetOf({
        fields,
        surfaceFields: ['p', 'deformation'],
        bounds: [0, 10, 0, 10, 0, 10],
        times: [2],
    });
    const asked: Params[] = [];
    const answers: (() => void)[] = [];
    const worker = answering((_, params) => {
        asked.push(params);
        return new Promise((resolve) => answers.push(() => resolve({ inside: [true], values: { U: [[3, 4, 0]], p: [7] } })));
    });
    const sight = {
        pick: ({ x }: { x: number }) => (x < 100 ? { point: [x, 1, 1] as Vec3, ...seen, distance: 4 } : null),
        rakeAt: ({ x }: { x: number }): Vec3 | null => (x >= 200 && x <= 260 ? [x, 2, 2] : null),
    };
    const probing = new Probing({ state, pageView, worker, requestFrame: () => undefined, ...sight });
    const answer = async (): Promise<void> => {
        answers.shift()?.();
        await settled();
    };
    return {
        state,
        pageView,
        probing,
        measuring: new Measuring({ state, pageView, ...sight }),
        noting: new Noting({ state, pageView, ...sight }),
        asked,
        answer,
    };
}

const seen = { surface: 's1', s: 0.25, t: 1.5, scalar: 3 };

const at = (x: number): Pointer => ({ at: { x, y: 0 }, time: 0, shift: false });

describe('Probing', () => {
    it('asks for the velocity and what can be sampled, on the surface under the pointer, at the time shown', async () => {
        const { probing, pageView, asked, answer } = bench();
        expect(probing.hover(at(50))).toBeNull();
        pageView.tool.value = 'probe';
        probing.hover(at(50));
        probing.flush();
        // At once, so that the next number that is typed belongs to this place.
        expect(pageView.probePlace.value).toEqual([50, 1, 1]);
        expect(pageView.probe.value).toBeNull();
        expect(asked).toEqual([{ dataset: 'flow', points: [[50, 1, 1]], time: 2, fields: ['U', 'p'] }]);
        await answer();
        expect(pageView.probe.value).toEqual({
            ...{ point: [50, 1, 1], time: 2, inside: true },
            values: [
                { name: 'U', value: [3, 4, 0] },
                { name: 'p', value: 7 },
            ],
            on: seen,
        });
    });

    it('shows no number where there is nothing to see, and says so', async () => {
        const { probing, pageView, asked, answer } = bench();
        pageView.tool.value = 'probe';
        probing.hover(at(50));
        probing.flush();
        // Still on its way when the pointer leaves the surface.
        probing.hover(at(150));
        probing.flush();
        await answer();
        probing.flush();
        expect(asked).toHaveLength(1);
        expect(pageView.probe.value).toBeNull();
        expect(pageView.probeMissed.value).toBe(true);
        probing.click(at(150));
        // A click there holds nothing: the probe goes on with the pointer.
        probing.hover(at(250));
        probing.flush();
        expect(asked.at(-1)?.points).toEqual([[250, 2, 2]]);
        await answer();
        expect(pageView.probe.value?.point).toEqual([250, 2, 2]);
        expect(pageView.probeMissed.value).toBe(false);
    });

    it('goes where numbers say, also where nothing can be seen', async () => {
        const { probing, pageView, answer } = bench();
        probing.probeThere([1, 2, 8]);
        await answer();
        expect(pageView.probe.value?.point).toEqual([1, 2, 8]);
    });

    it('asks for the newest place only, however fast the pointer is', async () => {
        const { probing, asked, answer } = bench();
        for (const x of [1, 2, 3]) probing.probeThere([x, 0, 0]);
        expect(asked).toHaveLength(1);
        await answer();
        expect(asked.map(({ points }) => points)).toEqual([[[1, 0, 0]], [[3, 0, 0]]]);
    });

    it('stays where it was clicked until the next click', async () => {
        const { probing, pageView, asked, answer } = bench();
        pageView.tool.value = 'probe';
        probing.click(at(20));
        await answer();
        probing.hover(at(60));
        probing.flush();
        expect(asked).toHaveLength(1);
        probing.click(at(70));
        await answer();
        probing.hover(at(80));
        probing.flush();
        expect(asked.at(-1)?.['points']).toEqual([[80, 1, 1]]);
    });
});

describe('Measuring', () => {
    it('takes two ends, and starts again with the third click', () => {
        const { measuring, pageView } = bench();
        expect(measuring.click(at(10))).toBe(false);
        pageView.tool.value = 'measure';
        measuring.click(at(10));
        measuring.click(at(220));
        expect(pageView.measured.value).toEqual([
            [10, 1, 1],
            [220, 2, 2],
        ]);
        measuring.click(at(30));
        expect(pageView.measured.value).toEqual([[30, 1, 1]]);
    });

    it('takes no end where nothing can be seen, and says so until one is on something', () => {
        const { measuring, pageView, state } = bench();
        pageView.tool.value = 'measure';
        measuring.click(at(10));
        expect(measuring.click(at(300))).toBe(true);
        expect(pageView.measured.value).toEqual([[10, 1, 1]]);
        expect(pageView.besidePointer.value?.words).toBe(nothingThere);
        measuring.click(at(20));
        expect(pageView.measured.value).toHaveLength(2);
        expect(state.problems.all.value.size).toBe(0);
    });
});

describe('Noting', () => {
    it('asks for words where the click was, on the surface that is there', () => {
        const { noting, pageView } = bench();
        expect(noting.click(at(10))).toBe(false);
        pageView.tool.value = 'annotate';
        expect(noting.click(at(10))).toBe(true);
        expect(pageView.note.value).toEqual({ annotation: null, text: '', position: [10, 1, 1], surface: 's1' });
    });

    it('puts no note where nothing can be seen', () => {
        const { noting, pageView } = bench();
        pageView.tool.value = 'annotate';
        expect(noting.click(at(300))).toBe(true);
        expect(pageView.note.value).toBeNull();
        expect(pageView.besidePointer.value).toEqual({ at: { x: 300, y: 0 }, words: nothingThere });
    });
});
