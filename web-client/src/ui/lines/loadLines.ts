// Streamlines and their panel come after the first picture: few pages need them before that.
import { computed, type ReadonlySignal, signal } from '@preact/signals-core';
import type { LinesOptions } from '../../session/picture/linesInPicture.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { LinesModel } from './linesPanel.ts';

export interface LoadedLines {
    /** Null: not loaded yet. */
    model: ReadonlySignal<LinesModel | null>;
    /** What the session has of them is not all in the picture. */
    waiting: ReadonlySignal<boolean>;
}

export function loadLines(
    options: LinesOptions & { scene: Pick<FlowScene, 'controls'>; view: Pick<ViewState, 'chosenThing' | 'lines'> },
): LoadedLines {
    const { state, view, scene } = options;
    const model = signal<LinesModel | null>(null);
    void import('../slices/openedFields.ts').then(({ Lines }) => {
        model.value = { state, view, lines: new Lines(options), middle: () => scene.controls.target };
    });
    const waiting = computed(() => state.lines.value.size > 0 && (model.value?.lines.waiting.value ?? true));
    return { model, waiting };
}
