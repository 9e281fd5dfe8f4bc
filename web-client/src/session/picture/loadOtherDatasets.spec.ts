import { expect, it, vi } from 'vitest';
import { PageBench } from '../../testing/pageBench.ts';
import { surfaceOf } from '../../testing/records.ts';
import { loadOtherDatasets } from './loadOtherDatasets.ts';

const tries = vi.hoisted(() => ({ made: 0 }));
vi.mock('./otherDatasets.ts', () => {
    ++tries.made;
    throw new Error('not there');
});

it('code for a second dataset that could not be loaded is told of', async () => {
    const { state, view, worker } = new PageBench();
    const rest = { scene: {} as never, bodies: {} as never, turnTo: () => undefined };
    loadOtherDatasets({ state, view, worker, ...rest });
    expect(tries.made).toBe(0);
    state.surfaces.value = new Map([['s1', surfaceOf('s1', { dataset: 'other' })]]);
    await vi.waitFor(() => expect([...state.notices.all.value.keys()]).toEqual(['other data']));
});
