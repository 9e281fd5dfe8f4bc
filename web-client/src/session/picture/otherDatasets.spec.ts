// A session with things of several datasets: which is worked on, what is drawn of the others, and what is said of the rest.
import { batch } from '@preact/signals-core';
import { beforeEach, describe, expect, it } from 'vitest';
import type { OtherBody } from '../../scene/surface/drawnBody.ts';
import type { BodyMesh } from '../../mesh/meshChange.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { answering, settled } from '../../testing/fakes.ts';
import { datasetOf, surfaceOf } from '../../testing/records.ts';
import { OtherDatasets } from './otherDatasets.ts';

const fine = datasetOf({ dataset: 'fine', name: 'fine.foam', bounds: [0, 2, 0, 1, 0, 1], obstacle: true, lengthUnit: 'm' });
const entryOf = (dataset: string, ready = 2) => {
    return { dataset, name: `${dataset}.foam`, state: 'ready' as const, steps: { ready, total: ready }, values: '0-a' };
};
const box: BodyMesh = { positions: new Float32Array(9), normals: new Float32Array(9), indices: new Uint32Array(6) };

let state: AppState;
let view: ViewState;
let asked: string[];
let domains: (readonly number[])[];
let others: readonly OtherBody[];
const said = (): string => state.notices.all.value.get('other data') ?? '';

beforeEach(() => {
    state = new AppState();
    view = new ViewState();
    asked = [];
    state.stage.value = 'running';
    state.dataset.value = datasetOf({ name: 'coarse.foam' });
    state.datasets.value = [entryOf('flow'), entryOf('fine')];
    new OtherDatasets({
        ...{ state, view },
        scene: {
            setOtherDomains: (bounds) => (domains = [...bounds]),
            body: { setOthers: (bodies) => (others = bodies) },
        },
        worker: answering((_, { dataset }) => {
            asked.push(String(dataset));
            if (dataset !== 'fine') throw new Error('gone');
            return fine;
        }),
        bodies: { of: async () => box },
        turnTo: (description) => {
            const before = state.dataset.value!;
            batch(() => {
                state.otherDatasets.value = new Map([[before.dataset, before]]);
                state.dataset.value = description;
            });
        },
    });
});

async function show(...datasets: string[]): Promise<void> {
    const records = datasets.map((dataset, i) => surfaceOf(`s${i + 1}`, { dataset }));
    state.surfaces.value = new Map(records.map((record) => [record.surface, record]));
    for (let i = 0; i < 3; ++i) await settled();
}

describe('data of which the session has something', () => {
    it('have their outline and body in the picture, as long as that is so', async () => {
        await show('flow');
        expect([asked, domains, others]).toEqual([[], [], []]);
        await show('flow', 'fine');
        expect([asked, domains]).toEqual([['fine'], [fine.bounds]]);
        expect(others.map(({ mesh }) => mesh.positions)).toEqual([box.positions]);
        expect(said()).toBe('');
        await show('flow');
        expect([domains, others, asked]).toEqual([[], [], ['fine']]);
    });

    it('are described again when they have grown, and not otherwise', async () => {
        await show('flow', 'fine');
        state.datasets.value = [entryOf('flow', 3), entryOf('fine')];
        await settled();
        expect(asked).toEqual(['fine']);
        state.datasets.value = [entryOf('flow', 3), entryOf('fine', 3)];
        await settled();
        expect(asked).toEqual(['fine', 'fine']);
    });

    it('are described again after an interruption in which they were lost', async () => {
        await show('flow', 'fine');
        state.stage.value = 'starting';
        state.otherDatasets.value = new Map();
        state.stage.value = 'running';
        await settled();
        expect([asked, domains]).toEqual([['fine', 'fine'], [fine.bounds]]);
    });

    it('are not asked for again with every edit where the server does not describe them', async () => {
        await show('flow', 'lost');
        await show('flow', 'lost');
        expect(asked).toEqual(['lost']);
    });

    it('are worked on when something of them is chosen, also a slice', async () => {
        await show('flow', 'fine');
        state.activeSurface.value = 's2';
        expect(state.dataset.value?.dataset).toBe('fine');
        expect(domains).toEqual([[0, 1, 0, 1, 0, 1]]);
        state.slices.value = new Map([
            ['c1', { slice: 'c1', rev: 1, dataset: 'flow', origin: [0, 0, 0], normal: [0, 0, 1], field: 'p' }],
        ]);
        view.chosenThing.value = 'body';
        expect(state.dataset.value?.dataset).toBe('fine');
        view.chosenThing.value = 'c1';
        expect(state.dataset.value?.dataset).toBe('flow');
    });
});

describe('what is not drawn', () => {
    it('is what the server does not describe', async () => {
        await show('flow', 'lost');
        expect(said()).toBe('Of lost only surfaces are drawn: the server does not describe it.');
        state.datasets.value = [...state.datasets.value, entryOf('lost', 0)];
        expect(said()).toBe('Of lost.foam only surfaces are drawn: it is not imported.');
        await show('flow');
        expect(said()).toBe('');
    });

    it('are colours on the body of the others, and another unit', async () => {
        state.dataset.value = datasetOf({ name: 'coarse.foam', lengthUnit: 'mm' });
        view.body.value = { ...view.body.value, colourBy: 'field:p' };
        await show('flow', 'fine');
        expect(said()).toContain('the body of fine.foam is grey.');
        expect(said()).toContain('fine.foam is in m, coarse.foam in mm: both are drawn as their numbers say.');
    });
});
