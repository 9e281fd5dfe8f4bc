// When values are asked for again.
import { expect, it } from 'vitest';
import type { SliceRecord } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { onOtherData } from './newestValues.ts';

const sliceOf = (slice: string, dataset: string, minus?: string): [string, SliceRecord] => {
    const less = minus === undefined ? {} : { minus };
    return [slice, { slice, rev: 1, dataset, origin: [0, 0, 0], normal: [0, 0, 1], field: 'p', ...less }];
};

it('values are asked for again when data of the session are others or the server is back, not for other data', () => {
    const state = new AppState();
    state.stage.value = 'running';
    const tell = (ready: Record<string, number>): void => {
        state.datasets.value = Object.entries(ready).map(([dataset, steps]) => {
            return { dataset, name: dataset, state: 'importing', steps: { ready: steps, total: 9 }, values: '0-a' };
        });
    };
    tell({ flow: 1, less: 1, foreign: 1 });
    state.slices.value = new Map([sliceOf('c1', 'flow', 'less')]);
    let asked = 0;
    onOtherData(state, () => ++asked);
    const since = (): number => {
        const before = asked;
        asked = 0;
        return before;
    };
    expect(since()).toBe(1);
    tell({ flow: 1, less: 1, foreign: 2 });
    expect(since(), 'other data grow').toBe(0);
    state.slices.value = new Map([sliceOf('c1', 'flow', 'less'), sliceOf('c2', 'foreign'), sliceOf('c3', 'lost')]);
    expect(since(), 'other data come in').toBe(0);
    tell({ flow: 2, less: 1, foreign: 2 });
    expect(since()).toBe(1);
    tell({ flow: 2, less: 2, foreign: 2 });
    expect(since(), 'what is subtracted').toBe(1);
    tell({ flow: 2, less: 2, foreign: 2, lost: 1 });
    expect(since(), 'what was missing').toBe(1);
    state.stage.value = 'starting';
    tell({ flow: 3, less: 2, foreign: 2, lost: 1 });
    expect(since()).toBe(0);
    state.stage.value = 'running';
    expect(since()).toBe(1);
});
