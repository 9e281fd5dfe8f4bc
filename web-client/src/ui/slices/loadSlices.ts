// Slices and their panel come after the first picture: few pages need them before that.
import { type ReadonlySignal, signal } from '@preact/signals-core';
import type { SlicesOptions } from '../../session/picture/slicesInPicture.ts';
import type { SlicesModel } from './slicesPanel.ts';

/** Returns null until they are loaded. */
export function loadSlices(options: SlicesOptions): ReadonlySignal<SlicesModel | null> {
    const loaded = signal<SlicesModel | null>(null);
    void import('./slicesPanel.ts').then(({ Slices }) => {
        loaded.value = { state: options.state, slices: new Slices(options) };
    });
    return loaded;
}
