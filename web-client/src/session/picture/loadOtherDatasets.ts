// What draws further datasets comes when a session has something of a second one.
import { effect } from '@preact/signals-core';
import type { OtherDatasetsOptions } from './otherDatasets.ts';

export function loadOtherDatasets(options: OtherDatasetsOptions): void {
    const { dataset, wantedDatasets, notices } = options.state;
    let loading = false;
    effect(() => {
        const shown = dataset.value?.dataset;
        if (loading || shown === undefined || [...wantedDatasets.value].every((each) => each === shown)) return;
        loading = true;
        import('./otherDatasets.ts').then(
            ({ OtherDatasets }) => new OtherDatasets(options),
            (error: unknown) => {
                // Once more with the next change of the session.
                loading = false;
                notices.tell('other data', error);
            },
        );
    });
}
