// The comparison of two pictures is loaded when it is first asked for.
import { computed, type ReadonlySignal, signal } from '@preact/signals-core';
import type { Beside, CompareOptions } from '../../session/compare/compare.ts';
import type { CompareBarModel, Side } from './compareBar.ts';

export interface ComparisonModel<Page extends Beside> {
    /** The page beside this one; null: nothing is compared. */
    right: ReadonlySignal<Page | null>;
    /** The half that the settings are those of. */
    chosen: ReadonlySignal<Side>;
    /** Null: nothing is compared. */
    bar: ReadonlySignal<CompareBarModel | null>;
    /** Why there can be none now; empty: there can. */
    whyNot: ReadonlySignal<string>;
    choose: (side: Side) => void;
    toggle: () => Promise<void>;
}

export function loadCompare<Page extends Beside>(options: Omit<CompareOptions<Page>, 'close'>): ComparisonModel<Page> {
    const { state } = options.left;
    const loaded = signal<CompareBarModel | null>(null);
    const chosen = signal<Side>('left');
    const right = computed(() => (loaded.value?.compare.right.value ?? null) as Page | null);
    const load = async (): Promise<CompareBarModel> => {
        const { Compare } = await import('./compareBar.ts');
        const compare = new Compare({ ...options, close: () => (chosen.value = 'left') });
        return (loaded.value ??= { compare, chosen });
    };
    return {
        right,
        chosen,
        bar: computed(() => (right.value === null ? null : loaded.value)),
        whyNot: computed(() => {
            if (state.stage.value !== 'running') return 'Not connected to the server';
            return state.dataset.value === null ? 'There is nothing to compare' : '';
        }),
        choose: (side) => (chosen.value = side),
        toggle: async () => {
            const { compare } = loaded.value ?? (await load());
            await (compare.right.value === null ? compare.begin() : compare.end());
        },
    };
}

/** Of a half, beside which there is no other. */
export const noComparison = {
    right: signal(null),
    whyNot: signal('This is a comparison already'),
    toggle: (): Promise<void> => Promise.resolve(),
};
