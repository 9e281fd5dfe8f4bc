// The units in which lengths and times of a dataset are meant, as its user has said once: kept in this browser, dataset by
// dataset, and shown at the axes.
import { effect } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import { keep, recall } from '../../state/browserMemory.ts';
import type { Units, ViewState } from '../../state/viewState.ts';

const none: Units = { length: '', time: '' };

export function showUnits(state: AppState, view: ViewState, scene: Pick<FlowScene, 'setUnit'>): void {
    let dataset: string | null = null;
    effect(() => {
        const opened = state.dataset.value?.dataset ?? null;
        if (opened === dataset) return;
        dataset = opened;
        if (dataset !== null) view.units.value = readUnits(recall(`units.${dataset}`));
    });
    effect(() => {
        const units = view.units.value;
        scene.setUnit(units.length);
        if (dataset !== null && units !== none) keep(`units.${dataset}`, JSON.stringify(units));
    });
}

export function readUnits(text: string | null): Units {
    try {
        const { length, time } = JSON.parse(text ?? '{}') as Record<string, unknown>;
        const word = (value: unknown): string => (typeof value === 'string' ? value.slice(0, 12) : '');
        return length === undefined && time === undefined ? none : { length: word(length), time: word(time) };
    } catch {
        return none;
    }
}

/** A number with its unit, if there is one. */
export function withUnit(words: string, unit: string): string {
    return unit === '' ? words : `${words} ${unit}`;
}
