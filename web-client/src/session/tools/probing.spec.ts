import { describe, expect, it } from 'vitest';
import { settled } from '../../testing/fakeClock.ts';
import type { Vec3 } from '../../protocol/messages.ts';
import type { Pointer } from '../../scene/base/pointerTools.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { Measuring } from './measuring.ts';
import { Noting } from './noting.ts';
import { type Asked, answering } from '../../testing/answering.ts';
import { datasetOf, fieldOf } from '../../testing/records.ts';
import { Probing } from './probing.ts';

/** A picture in which x of the canvas is x of space, with a surface to the left of 100. */
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
    const asked: Asked[] = [];
    const answers: (() => void)[] = [];
    const worker = answering((_, params) => {
        asked.push(params);
        return new Promise((resolve) => answers.push(() => resolve({ inside: [true], values: { U: [[3, 4, 0]], p: [7] } })));
    });
    const sight = {
        view: () => ({ pointAtDepth: ({ x }: { x: number }, anchor: Vec3): Vec3 => [x, 0, anchor[2]] }),
        pick: ({ x }: { x: number }) => (x < 100 ? { point: [x, 1, 1] as Vec3, surface: 's1' } : null),
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
        });
    });

    it('in the open stays as far away as it was', async () => {
        const { probing, pageView, asked, answer } = bench();
        pageView.tool.value = 'probe';
        probing.probeThere([1, 2, 8]);
        await answer();
        probing.hover(at(200));
        probing.flush();
        expect(asked).toHaveLength(1);
        probing.click(at(250));
        await answer();
        probing.hover(at(300));
        probing.flush();
        expect(asked.at(-1)?.points).toEqual([[300, 0, 8]]);
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
        measuring.click(at(300));
        expect(pageView.measured.value).toEqual([
            [10, 1, 1],
            [300, 0, 1],
        ]);
        measuring.click(at(30));
        expect(pageView.measured.value).toEqual([[30, 1, 1]]);
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
});
