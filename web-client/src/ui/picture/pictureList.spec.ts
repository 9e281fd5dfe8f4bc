// @vitest-environment happy-dom
import { signal } from '@preact/signals-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { connectChosenThings } from '../../session/picture/chosenThings.ts';
import { hideSurfaces } from '../../session/picture/looksInPicture.ts';
import type { SlicePlace } from '../../session/picture/slicesInPicture.ts';
import { bodyId } from '../../state/pageView.ts';
import { newSlice } from '../../state/viewState.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { isolated } from '../../state/announcements.ts';
import { datasetOf, surfaceOf } from '../../testing/records.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './pictureList.ts';

let bench: PageBench;
let panel: ShownPanel;
let removed: string[];
let bodyOpacity: number;
const places = signal<ReadonlyMap<string, SlicePlace>>(new Map());

beforeEach(async () => {
    bench = new PageBench();
    removed = [];
    places.value = new Map([['c1', { origin: [0, 0, 2], normal: [0, 0, 1], field: 'p', minus: null }]]);
    const { state, view, edits } = bench;
    const body = { setHidden: () => undefined, setOpacity: (opacity: number) => void (bodyOpacity = opacity) };
    const scene = { body, loop: { request: () => undefined } };
    connectChosenThings({ state, view, scene });
    hideSurfaces(state, view);
    const remove = (id: string): Promise<void> => Promise.resolve(void removed.push(id));
    panel = await ShownPanel.of('wakesurf-picture-list', {
        state,
        view,
        edits,
        slices: signal({ slices: { places, remove } }),
        lines: signal(null),
    });
});

const names = () => panel.all('.thing .cut:not(.about)').map(({ textContent }) => textContent);
const chosen = () => panel.all('.thing[aria-pressed="true"]').map((each) => each.dataset['thing']);
const unseen = () => panel.all('.thing.unseen').map((each) => each.dataset['thing']);
const choose = (id: string): Promise<void> => panel.click(`.thing[data-thing="${id}"]`);

it('says of which data things are where there are several, and has one row for their bodies', async () => {
    const { state } = bench;
    expect(panel.all('.data')).toEqual([]);
    state.otherDatasets.value = new Map([['fine', datasetOf({ dataset: 'fine', name: 'fine', obstacle: true })]]);
    state.surfaces.value = new Map([
        ...state.surfaces.value,
        ['l1', surfaceOf('l1', { dataset: 'fine', kind: 'level', rake: undefined })],
    ]);
    await rested();
    expect(panel.all('.data').map(({ textContent }) => textContent)).toEqual(['flow', 'fine'].map(isolated));
    expect(names().at(-1)).toBe('Bodies');
});

describe('what is in the picture', () => {
    it('is one list: a rake, isosurfaces, slices and the body, each with what it is coloured by', async () => {
        expect(names()).toEqual(['Rake 1', 'z = 2', 'Body']);
        await panel.press('New isosurface');
        expect(names()).toEqual(['Rake 1', 'U (speed) = 0.896', 'z = 2', 'Body']);
        expect(chosen()).toEqual(['surface-2']);
        bench.view.changeLook('surface-2', { colourBy: 'q_criterion' });
        await rested();
        expect(panel.all('.about').map(({ textContent }) => textContent)).toEqual(['stream, speed', 'Q', 'p', 'grey']);
    });

    it('is chosen, and what is chosen is deleted: a rake leaves isosurfaces, and the body belongs to the data', async () => {
        await panel.press('New isosurface');
        await choose(bodyId);
        expect(chosen()).toEqual([bodyId]);
        expect(panel.get<HTMLButtonElement>('button', 'Delete').disabled).toBe(true);
        await choose('c1');
        await panel.press('Delete');
        expect(removed).toEqual(['c1']);
        await choose('rake-1');
        expect(chosen()).toEqual(['rake-1']);
        bench.answers['rake.delete'] = () => {
            bench.tell([
                { op: 'delete', type: 'surface', id: 'surface-1' },
                { op: 'delete', type: 'rake', id: 'rake-1' },
            ]);
            return {};
        };
        await panel.press('Delete');
        expect(names()).toEqual(['U (speed) = 0.896', 'z = 2', 'Body']);
        expect(chosen()).toEqual(['surface-2']);
        await panel.press('Delete');
        expect(names()).toEqual(['z = 2', 'Body']);
    });

    it('is hidden one by one, and shown alone until that is taken back', async () => {
        await panel.press('New isosurface');
        await panel.press('Hide Body');
        expect([unseen(), bodyOpacity]).toEqual([[bodyId], 0]);
        await panel.press('Show only U (speed) = 0.896');
        expect(unseen()).toEqual(['rake-1', 'c1', bodyId]);
        expect([...bench.state.hiddenSurfaces.value]).toEqual(['surface-1']);
        await panel.press('Show only U (speed) = 0.896');
        expect(unseen()).toEqual([bodyId]);
        await panel.press('Show only z = 2');
        // What is asked for is shown, with all the rest.
        await panel.press('Hide Body');
        expect([unseen(), bodyOpacity]).toEqual([[], 1]);
    });

    it('is shown again where what was shown alone is gone', async () => {
        await panel.press('New isosurface');
        await panel.press('Show only U (speed) = 0.896');
        await panel.press('Delete');
        expect(unseen()).toEqual([]);
    });

    it('is seen through as far as one wants', async () => {
        await panel.enter('#thing-opacity', 'Opacity', 0.5);
        expect(bench.view.lookOf('surface-1').opacity).toBe(0.5);
        await choose(bodyId);
        await panel.enter('#thing-opacity', 'Opacity', 0.25);
        expect(bodyOpacity).toBe(0.25);
        await panel.enter('#thing-opacity', 'Opacity', 1);
        expect([bodyOpacity, bench.view.visibility.value.opacities.size]).toEqual([1, 0]);
    });

    it('takes the panel back from a slice that is added or the body where a rake or surface is chosen elsewhere', async () => {
        await panel.press('New slice');
        expect(bench.view.chosenThing.value).toBe(newSlice);
        expect(chosen()).toEqual([]);
        await bench.edits.actions.newIsosurface();
        await rested();
        expect(chosen()).toEqual(['surface-2']);
    });

    it('is not another’s to change who may only look, but to hide', async () => {
        bench.state.role.value = 'viewer';
        await rested();
        for (const name of ['New rake', 'New isosurface', 'New slice', 'Delete']) {
            expect(panel.get<HTMLButtonElement>('button', name).disabled, name).toBe(true);
        }
        await panel.press('Hide Rake 1');
        expect(unseen()).toEqual(['rake-1']);
    });
});
