import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import type { DatasetDescription, DatasetEntry } from '../protocol/messages.ts';
import { AppState } from '../state/appState.ts';
import { plainBody } from '../state/bodyLook.ts';
import { datasetOf, suggestionOf, surfaceOf } from '../testing/records.ts';
import { rested } from '../testing/shownPanel.ts';
import { OpenDataset } from './openDataset.ts';

function bench() {
    const state = new AppState();
    const view = { body: signal(plainBody) };
    const shown: string[] = [];
    /** By dataset: what the server describes it as, and when. */
    const described = new Map<string, () => Promise<DatasetDescription> | DatasetDescription>();
    const entry: DatasetEntry = { dataset: 'flow', name: 'flow', state: 'ready', steps: { ready: 2, total: 2 }, values: '' };
    const answer = async (method: string, params: { dataset: string }) => {
        if (method === 'dataset.list') return { datasets: [entry] };
        if (method !== 'dataset.describe') return { steps: [], bytes: 0, budget: 0 };
        return described.get(params.dataset)?.() ?? datasetOf({ obstacle: true });
    };
    const worker = { call: answer as never };
    const bodies = {
        of: async () => {
            await Promise.resolve();
            shown.push('read the body');
            return { positions: new Float32Array(), indices: new Uint32Array() } as never;
        },
    };
    const scene = {
        setDomain: (_: unknown, stays?: boolean) => void shown.push(stays === true ? 'domain, camera stays' : 'domain'),
        body: { set: () => void shown.push('body'), remove: () => void shown.push('no body') },
    };
    const dataset = new OpenDataset({
        state,
        view,
        scene,
        worker,
        bodies,
        imports: { left: { value: false }, begin: async () => undefined } as never,
    });
    /** The server tells of these values; what the picture is changed by. */
    const tell = async (values: string): Promise<string[]> => {
        shown.length = 0;
        state.datasetEntry.value ??= { ...entry, values };
        dataset.patched({ ...entry, values });
        await rested();
        return [...shown];
    };
    return { state, view, dataset, tell, shown, described };
}

describe('a link to a dataset that is not there', () => {
    it('says so, and leaves the choice of the others', async () => {
        const { state, dataset } = bench();
        await expect(dataset.wait('gone', () => false)).rejects.toThrow(
            'The server does not have the dataset of this link. Choose another in the panel.',
        );
        expect(state.datasets.value.map(({ dataset: id }) => id)).toEqual(['flow']);
        expect((await dataset.wait('flow', () => false))?.dataset).toBe('flow');
    });
});

describe('the dataset that is shown', () => {
    it('keeps domain and body while its series grows, or its values are others', async () => {
        const { tell } = bench();
        expect(await tell('0-a 1-b')).toEqual(['domain', 'no body', 'read the body', 'body']);
        expect(await tell('0-a 1-b 2-c')).toEqual([]);
        expect(await tell('0-a 1-x 2-y')).toEqual([]);
    });

    it('gets the domain and the body of a grid that takes its place', async () => {
        const { tell } = bench();
        await tell('0-a 1-b 2-c');
        expect(await tell('0-z 1-b 2-c')).toEqual(['domain', 'no body', 'read the body', 'body']);
    });

    it('forgets what was suggested for other values, not for a longer series', async () => {
        const { state, tell } = bench();
        await tell('0-a 1-b 2-c');
        state.suggestion.value = { dataset: 'flow', ...suggestionOf() };
        await tell('0-a 1-b 3-d');
        expect(state.suggestion.value).not.toBeNull();
        await tell('0-a 1-b 3-e');
        expect(state.suggestion.value).toBeNull();
    });
});

describe('the dataset that is worked on, of several', () => {
    const fine = datasetOf({ dataset: 'fine', name: 'fine' });
    const entryOf = (dataset: string): DatasetEntry => {
        return { dataset, name: dataset, state: 'ready', steps: { ready: 1, total: 1 }, values: '0-a' };
    };

    function several() {
        const made = bench();
        const { state } = made;
        const records = ['flow', 'fine'].map((dataset, i) => surfaceOf(`s${i}`, { dataset }));
        state.surfaces.value = new Map(records.map((each) => [each.surface, each]));
        state.datasets.value = ['flow', 'fine'].map(entryOf);
        state.datasetEntry.value = entryOf('flow');
        state.dataset.value = datasetOf({ obstacle: true });
        state.otherDatasets.value = new Map([['fine', fine]]);
        made.described.set('fine', () => fine);
        return made;
    }

    const others = (state: AppState): string[] => [...state.otherDatasets.value.keys()];

    it('changes places with another that is described as the first one, and the camera stays', async () => {
        const { state, dataset, shown } = several();
        state.datasetEntry.value = entryOf('fine');
        await dataset.describe('fine');
        expect([state.dataset.value?.dataset, others(state), shown]).toEqual([
            'fine',
            ['flow'],
            ['domain, camera stays', 'no body', 'no body'],
        ]);
    });

    it('is not kept once the session has nothing of it', async () => {
        const { state, dataset } = several();
        state.surfaces.value = new Map([['s1', surfaceOf('s1', { dataset: 'fine' })]]);
        dataset.turnTo(fine);
        expect([state.dataset.value?.dataset, others(state)]).toEqual(['fine', []]);
    });

    it('stays where the answer about the one before comes late', async () => {
        const { state, dataset, described } = several();
        let answer: (description: DatasetDescription) => void = () => undefined;
        described.set('flow', () => new Promise((resolve) => (answer = resolve)));
        dataset.patched({ ...entryOf('flow'), values: '0-a 1-b' });
        await rested();
        dataset.turnTo(fine);
        answer(datasetOf({ times: [0, 1] }));
        await rested();
        expect([state.dataset.value?.dataset, state.otherDatasets.value.get('flow')?.times]).toEqual(['fine', [0, 1]]);
    });

    it('has the former body taken away, with its values', () => {
        const { dataset, shown } = several();
        dataset.turnTo({ ...fine, obstacle: true });
        expect(shown.slice(0, 2)).toEqual(['domain, camera stays', 'no body']);
    });
});
