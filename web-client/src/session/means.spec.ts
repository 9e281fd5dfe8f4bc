import { describe, expect, it } from 'vitest';
import type { MeanMakeParams, MeanMakeResult } from '../protocol/generated/mean.ts';
import { AppState } from '../state/appState.ts';
import { datasetOf } from '../testing/records.ts';
import { Means } from './means.ts';

function bench(answer: (method: string, signal?: AbortSignal) => Promise<MeanMakeResult>) {
    const state = new AppState();
    state.dataset.value = datasetOf({ times: [0, 1, 2] });
    const asked: MeanMakeParams[] = [];
    const worker = {
        call: async (method: string, params: MeanMakeParams, signal?: AbortSignal) => {
            asked.push(params);
            return await answer(method, signal);
        },
    };
    return { means: new Means({ state, worker }), asked };
}

const made: MeanMakeResult = {
    means: [
        {
            of: 'p',
            from: 1,
            to: 2,
            steps: 2,
            version: '0.1.0',
            fields: [
                { name: 'p_mean', range: [0, 1] },
                { name: 'p_rms', range: [0, 1] },
            ],
        },
    ],
};

describe('means made from the page', () => {
    it('are asked for with what the user chose, and named once they are there', async () => {
        const { means, asked } = bench(() => Promise.resolve(made));
        await means.make({ fields: ['p'], from: 1 });
        expect(asked).toEqual([{ dataset: 'flow', fields: ['p'], from: 1, workDoneToken: 'mean 1' }]);
        expect(means.status.value).toEqual({
            making: false,
            words: 'Made: p_mean, p_rms. Colour by them, or show them on a slice.',
        });
    });

    it('say how far they are, and end when they are cancelled', async () => {
        const { means, asked } = bench(
            (_, signal) =>
                new Promise((_resolve, reject) => signal?.addEventListener('abort', () => reject(new Error('it was cancelled')))),
        );
        const making = means.make({ fields: ['p'] });
        await means.make({ fields: ['U'] });
        expect(asked).toHaveLength(1);
        means.progressed('mean 1', 41.6);
        expect(means.status.value).toEqual({ making: true, words: '42 %' });
        means.cancel();
        await making;
        expect(means.status.value).toEqual({ making: false, words: 'it was cancelled' });
    });

    it('that cannot be removed say why', async () => {
        const { means } = bench(() => Promise.reject(new Error('only hosts remove means')));
        await means.remove('p_mean');
        expect(means.status.value).toEqual({ making: false, words: 'only hosts remove means' });
    });
});
