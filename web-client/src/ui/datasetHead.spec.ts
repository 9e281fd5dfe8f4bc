// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import type { DatasetEntry } from '../protocol/messages.ts';
import { Announcements } from '../state/announcements.ts';
import { PageBench } from '../testing/pageBench.ts';
import { datasetOf, suggestionOf } from '../testing/records.ts';
import { rested, ShownPanel } from '../testing/shownPanel.ts';
import './datasetHead.ts';

let bench: PageBench;
let head: ShownPanel;
let entered: string[];

const entryOf = (dataset: string, total = 1): DatasetEntry => ({
    ...{ dataset, name: dataset, state: 'ready', steps: { ready: total, total }, values: '' },
});

beforeEach(async () => {
    bench = new PageBench();
    bench.state.datasets.value = [entryOf('flow', 16), entryOf('sphere')];
    entered = [];
    const sessionList = { problems: new Announcements(), enterDataset: async (id: string) => void entered.push(id) };
    bench.answers['dataset.suggest'] = () => suggestionOf();
    head = await ShownPanel.of('wakesurf-dataset-head', Object.assign(bench, { sessionList }));
});

const opens = (): boolean => !head.get('button', 'Open').matches(':disabled');
const offered = (): (string | null)[] =>
    [...head.get<HTMLSelectElement>('#dataset').options].map(({ textContent }) => textContent);

describe('a server with several datasets', () => {
    it('offers them; to choose is not to open yet', async () => {
        expect(offered()).toEqual(['flow (16 time-steps)', 'sphere']);
        expect(opens()).toBe(false);
        await head.enter('#dataset', 'Dataset', 'sphere');
        expect([opens(), entered]).toEqual([true, []]);
        await head.press('Open');
        expect(entered).toEqual(['sphere']);
    });

    it('offers them as well where none is shown, since a link asked for another', async () => {
        bench.state.dataset.value = null;
        await rested();
        expect(offered()).toEqual(['Choose a dataset', 'flow (16 time-steps)', 'sphere']);
        expect(opens()).toBe(false);
        await head.enter('#dataset', 'Dataset', 'flow');
        await head.press('Open');
        expect(entered).toEqual(['flow']);
    });

    it('adds one to this picture: a rake and a surface as the server suggests, which are chosen', async () => {
        await head.enter('#dataset', 'Dataset', 'sphere');
        await head.press('Add to this picture');
        expect(bench.asked('dataset.suggest')).toEqual([{ dataset: 'sphere' }]);
        expect(bench.rakes.map(({ name }) => name)).toEqual(['Rake 1', 'Rake 2']);
        expect(bench.state.surface.value).toMatchObject({ dataset: 'sphere', rake: 'rake-2', kind: 'stream', from: 10 });
        expect(entered).toEqual([]);
    });

    it('adds nothing that has to be imported first', async () => {
        bench.state.datasets.value = [entryOf('flow', 16), { ...entryOf('sphere'), steps: { ready: 0, total: 1 } }];
        await head.enter('#dataset', 'Dataset', 'sphere');
        expect([opens(), head.get('button', 'Add to this picture').matches(':disabled')]).toEqual([true, true]);
    });

    it('offers none to people who were invited to this session', async () => {
        bench.state.role.value = 'editor';
        await rested();
        expect(head.all('select')).toEqual([]);
        expect(head.text).toContain('flow');
    });
});

it('says that data of one time-step are a flow that stands still', async () => {
    bench.state.dataset.value = datasetOf({ times: [3], steady: true, points: 8 });
    await rested();
    expect(head.get('p.quiet').textContent).toMatch(/1 time-step: the flow stands still/);
    bench.state.dataset.value = datasetOf({ times: [3, 4], steady: false, points: 8 });
    await rested();
    expect(head.get('p.quiet').textContent).not.toMatch(/still/);
});
