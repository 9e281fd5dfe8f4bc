// Means over time of the fields of the dataset, made and removed from the page. The fields that come of them are
// in its next description.
import type { MeanMakeParams } from '../protocol/generated/mean.ts';
import type { AppState } from '../state/appState.ts';
import type { WorkerClient } from '../worker/workerClient.ts';
import { LongCall } from './base/longCall.ts';

export interface MeansOptions {
    state: Pick<AppState, 'dataset'>;
    worker: Pick<WorkerClient, 'call'>;
}

export type MeanWish = Omit<MeanMakeParams, 'dataset' | 'workDoneToken'>;

export class Means extends LongCall {
    private readonly options: MeansOptions;

    constructor(options: MeansOptions) {
        super('mean');
        this.options = options;
    }

    async make(wish: MeanWish): Promise<void> {
        const { state, worker } = this.options;
        const dataset = state.dataset.value?.dataset;
        if (dataset === undefined) return;
        await this.run(async (workDoneToken, signal) => {
            const { means } = await worker.call('mean.make', { dataset, ...wish, workDoneToken }, signal);
            const names = means.flatMap(({ fields }) => fields.map(({ name }) => name));
            return `Made: ${names.join(', ')}. Colour by them, or show them on a slice.`;
        });
    }

    /** @param name  of one of the fields that were made together */
    async remove(name: string): Promise<void> {
        const { state, worker } = this.options;
        const dataset = state.dataset.value?.dataset;
        if (dataset === undefined) return;
        await this.run(async () => {
            await worker.call('mean.remove', { dataset, name });
            return `${name} is removed.`;
        });
    }
}
