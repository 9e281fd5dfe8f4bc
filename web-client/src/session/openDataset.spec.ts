import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import type { DatasetEntry } from '../protocol/messages.ts';
import { AppState } from '../state/appState.ts';
import { plainBody } from '../state/bodyLook.ts';
import { datasetOf, suggestionOf } from '../testing/records.ts';
import { rested } from '../testing/shownPanel.ts';
import { OpenDataset } from './openDataset.ts';

function bench() {
    const state = new AppState();
    const view = { body: signal(plainBody) };
    const shown: string[] = [];
    const description = () => datasetOf({ obstacle: true });
    const entry: DatasetEntry = { dataset: 'flow', name: 'flow', state: 'ready', steps: { ready: 2, total: 2 }, values: '' };
    const answer = async (method: string) => {
        if (method === 'dataset.list') return { datasets: [entry] };
        return method === 'dataset.describe' ? description() : { steps: [], bytes: 0, budget: 0 };
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
        setDomain: () => void shown.push('domain'),
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
    return { state, view, dataset, tell };
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
        expect(await tell('0-a 1-b')).toEqual(['domain', 'read the body', 'body']);
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
