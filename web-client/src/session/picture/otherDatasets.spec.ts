// A session with records of several datasets says which it shows as a whole.
import { expect, it } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { datasetOf, surfaceOf } from '../../testing/records.ts';
import { sayOtherDatasets } from './otherDatasets.ts';

it('is said as long as the session has something of other data', () => {
    const state = new AppState();
    state.stage.value = 'running';
    state.dataset.value = datasetOf();
    sayOtherDatasets(state);
    const said = (): string => state.notices.all.value.get('other data') ?? '';
    state.surfaces.value = new Map([['s1', surfaceOf('s1')]]);
    expect(said()).toBe('');
    state.surfaces.value = new Map([
        ['s1', surfaceOf('s1')],
        ['s2', surfaceOf('s2', { dataset: 'fine' })],
    ]);
    expect(said()).toContain('Surfaces of fine are drawn here without its outline');
    expect(said()).not.toContain('Slices');
    state.slices.value = new Map([
        ['c1', { slice: 'c1', rev: 1, dataset: 'fine', origin: [0, 0, 0], normal: [0, 0, 1], field: 'p' }],
    ]);
    expect(said()).toContain('Slices and streamlines of fine are not drawn.');
    [state.surfaces.value, state.slices.value] = [new Map(), new Map()];
    expect(said()).toBe('');
});
