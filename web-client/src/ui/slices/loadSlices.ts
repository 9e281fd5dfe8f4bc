// Slices and their panel come after the first picture: few pages need them before that.
import { computed, type ReadonlySignal, signal } from '@preact/signals-core';
import type { SlicesOptions } from '../../session/picture/slicesInPicture.ts';
import type { SlicesModel } from './slicesPanel.ts';

export interface LoadedSlices {
    /** Null: not loaded yet. */
    model: ReadonlySignal<SlicesModel | null>;
    /** What the session has of them is not all in the picture. */
    waiting: ReadonlySignal<boolean>;
}

export function loadSlices(options: SlicesOptions): LoadedSlices {
    const { state, view } = options;
    const model = signal<SlicesModel | null>(null);
    void import('./openedFields.ts').then(({ Slices }) => {
        model.value = { state, view, slices: new Slices(options), time: () => options.time(state.dataset.value?.dataset ?? '') };
    });
    const waiting = computed(() => state.slices.value.size > 0 && (model.value?.slices.waiting.value ?? true));
    return { model, waiting };
}
