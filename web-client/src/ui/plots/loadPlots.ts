// Plots, and what draws them, come with the first plot that someone opens.
import { computed, effect, type ReadonlySignal, signal } from '@preact/signals-core';
import type { PlotsOptions } from '../../session/plots/plots.ts';
import type { PlotDockModel } from './plotDock.ts';

/** Null: nothing is plotted, or it is not loaded yet. */
export function loadPlots(options: PlotsOptions, playback: PlotDockModel['playback']): ReadonlySignal<PlotDockModel | null> {
    const { state, view } = options;
    const model = signal<PlotDockModel | null>(null);
    effect(() => {
        if (view.plot.value === null) return;
        void import('./plotDock.ts').then(({ Plots }) => {
            model.value ??= { state, view, playback, plots: new Plots(options) };
        });
    });
    return computed(() => (view.plot.value === null ? null : model.value));
}
