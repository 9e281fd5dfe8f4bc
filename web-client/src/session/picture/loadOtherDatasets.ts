// What draws further datasets comes when a session has something of a second one.
import { effect } from '@preact/signals-core';
import type { OtherDatasetsOptions } from './otherDatasets.ts';

export function loadOtherDatasets(options: OtherDatasetsOptions): void {
    const { dataset, lines, slices, surfaces } = options.state;
    let loading = false;
    effect(() => {
        const shown = dataset.value?.dataset;
        const all = [surfaces, slices, lines].flatMap(({ value }) => [...value.values()]);
        if (loading || shown === undefined || all.every((each) => each.dataset === shown)) return;
        loading = true;
        void import('./otherDatasets.ts').then(({ OtherDatasets }) => new OtherDatasets(options));
    });
}
