// A session shows one dataset: its outline, body, times and fields. What it has of others is said, with what becomes of it.
import { computed, effect } from '@preact/signals-core';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';

const about = 'other data';

export function sayOtherDatasets(
    state: Pick<AppState, 'dataset' | 'datasets' | 'lines' | 'notices' | 'slices' | 'stage' | 'surfaces'>,
): void {
    const words = computed(() => {
        const shown = state.dataset.value?.dataset;
        if (shown === undefined || state.stage.value !== 'running') return '';
        const others = (records: ReadonlyMap<string, { dataset: string }>): string => {
            const ids = new Set([...records.values()].map(({ dataset }) => dataset).filter((id) => id !== shown));
            return [...ids]
                .map((id) => isolated(state.datasets.value.find(({ dataset }) => dataset === id)?.name ?? id))
                .join(', ');
        };
        const surfaces = others(state.surfaces.value);
        const fields = others(new Map<string, { dataset: string }>([...state.slices.value, ...state.lines.value]));
        return [
            surfaces === '' ? '' : `Surfaces of ${surfaces} are drawn here without its outline, body and fields.`,
            fields === '' ? '' : `Slices and streamlines of ${fields} are not drawn.`,
            surfaces + fields === '' ? '' : 'Side by side shows another dataset as a whole.',
        ]
            .filter((each) => each !== '')
            .join(' ');
    });
    effect(() => {
        if (words.value === '') state.notices.solved(about);
        else state.notices.say(about, words.value);
    });
}
