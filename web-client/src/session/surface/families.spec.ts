import { describe, expect, it } from 'vitest';
import type { Family, FamilyMakeParams } from '../../protocol/generated/family.ts';
import { AppState } from '../../state/appState.ts';
import { datasetOf, rakeOf } from '../../testing/records.ts';
import { CallError } from '../../worker/workerClient.ts';
import { errorCodes } from '../../protocol/generated/errors.ts';
import { Families } from './families.ts';

function bench(answer: (asked: FamilyMakeParams, signal?: AbortSignal) => Promise<Family>) {
    const state = new AppState();
    state.dataset.value = datasetOf({ times: [0, 1, 2], surfaceFields: ['U', 'rake_family'] });
    state.rakes.value = new Map([['r1', rakeOf('r1')]]);
    const asked: FamilyMakeParams[] = [];
    const changes: object[] = [];
    const times: (number | null)[] = [];
    const families = new Families({
        state,
        worker: {
            call: async (_method: string, params: FamilyMakeParams, signal?: AbortSignal) => {
                asked.push(params);
                return await answer(params, signal);
            },
        },
        edits: { changeSurface: (change) => void changes.push(change) },
        clock: { set: (time) => void times.push(time) },
        time: () => 1.2,
    });
    return { families, asked, changes, times };
}

function familyOf(name: string): Family {
    const counts = { nodes: 1000, reached: 900, atRest: 60, obstacle: 20, lost: 10, outside: 10 };
    const step = { index: 1, time: 1, ...counts, range: [-2, 4] as [number, number] };
    return { name, from: 'curve', accuracy: 'balanced', length: 10, version: '0.1.0', steps: [step] };
}

describe('a family made from the page', () => {
    it('of the rake shows its level 0 at the time it was made for, and says how many nodes have no value', async () => {
        const { families, asked, changes, times } = bench(({ name }) => Promise.resolve(familyOf(name)));
        await families.make({ rake: 'r1' });
        expect(asked[0]).toMatchObject({ dataset: 'flow', name: 'rake_family_2', from: 'curve', rakeKind: 'line', time: 1.2 });
        expect(changes).toEqual([{ kind: 'level', field: 'rake_family_2', level: 0 }]);
        expect(times).toEqual([1]);
        expect(families.status.value).toMatchObject({ making: false });
        expect(families.status.value!.words).toBe('rake_family_2: 100 of 1000 nodes have no value.');
    });

    it('of the inflow shows the middle of its range', async () => {
        const { families, asked, changes } = bench(({ name }) => Promise.resolve(familyOf(name)));
        await families.make('y');
        expect(asked[0]).toMatchObject({ name: 'y_family', from: 'inflow', scalar: 'y' });
        expect(asked[0]).not.toHaveProperty('points');
        expect(changes).toEqual([{ kind: 'level', field: 'y_family', level: 1 }]);
    });

    it('tells its own progress, one at a time, and can be given up', async () => {
        const cancelled = { kind: 'rpc', code: errorCodes.cancelled, message: 'given up', hint: '' } as const;
        const { families, asked, changes } = bench(
            (_asked, signal) =>
                new Promise((_resolve, reject) => {
                    signal?.addEventListener('abort', () => reject(new CallError(cancelled)));
                }),
        );
        const making = families.make({ rake: 'r1' });
        await families.make('x');
        expect(asked).toHaveLength(1);
        families.progressed('another', 90);
        expect(families.status.value).toMatchObject({ making: true, words: '' });
        families.progressed(asked[0]!.workDoneToken!, 25);
        expect(families.status.value).toMatchObject({ words: '25 %' });
        families.cancel();
        await making;
        expect(families.status.value).toMatchObject({ making: false });
        expect(changes).toEqual([]);
    });

    it('that is refused says why', async () => {
        const refusal = { kind: 'rpc', code: -32602, message: 'the flow enters nowhere', hint: 'take a plane' } as const;
        const { families, changes } = bench(() => Promise.reject(new CallError(refusal)));
        await families.make('z');
        expect(families.status.value).toMatchObject({ making: false });
        expect(families.status.value!.words).toContain('the flow enters nowhere');
        expect(changes).toEqual([]);
    });
});
