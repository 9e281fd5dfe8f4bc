// A copied session in another dataset: as much of it as that can have.
import { expect, it } from 'vitest';
import type { SliceRecord } from '../../protocol/messages.ts';
import { CallError } from '../../worker/workerClient.ts';
import { answering, type Params } from '../../testing/fakes.ts';
import { datasetOf, emptySnapshot, rakeOf, surfaceOf } from '../../testing/records.ts';
import { showOtherData } from './otherData.ts';

it('builds the same surfaces in it, at times that it has, of the fields that it has, and says what it lacks', async () => {
    const told: [string, Params][] = [];
    const worker = answering((method, params) => {
        told.push([method, params]);
        if (method === 'dataset.describe') {
            return { ...datasetOf({ times: [2, 3, 4] }), name: 'fine', surfaceFields: ['speed'] };
        }
        if (method === 'slice.set') {
            throw new CallError({ kind: 'rpc', code: -32602, message: 'a field the dataset does not have: p', hint: '' });
        }
        return {};
    });
    const streak = surfaceOf('s1', { rake: 'r1', kind: 'streak', from: 0, to: 3.5, fields: ['speed', 'p'] });
    const stream = surfaceOf('s2', { rake: 'r1', kind: 'stream', from: 9, to: 19 });
    const slice: SliceRecord = { slice: 'c1', rev: 1, dataset: 'flow', origin: [0, 0, 0], normal: [0, 0, 1], field: 'p' };
    const snapshot = {
        ...emptySnapshot('copy'),
        ...{ rakes: [rakeOf('r1')], surfaces: [streak, stream], slices: [slice] },
    };
    const missing = await showOtherData(worker, snapshot, 'other');
    expect(missing).toBe('Not shown in fine: 1 slice. a field the dataset does not have: p');
    const of = (method: string): Params[] => told.filter(([each]) => each === method).map(([, params]) => params);
    expect(of('surface.set')).toMatchObject([
        { surface: 's1', dataset: 'other', from: 2, to: 3.5, fields: ['speed'] },
        { surface: 's2', dataset: 'other', from: 4, to: 14 },
    ]);
    expect(of('slice.delete')).toEqual([{ slice: 'c1' }]);
});
