// @vitest-environment happy-dom
import { signal } from '@preact/signals-core';
import { expect, it } from 'vitest';
import { PageBench } from '../../testing/pageBench.ts';
import { fieldOf } from '../../testing/records.ts';
import { ShownPanel } from '../../testing/shownPanel.ts';
import './slicesPanel.ts';

async function shown(stored: boolean) {
    const { state, view } = new PageBench();
    const { fields, ...dataset } = state.dataset.value!;
    const own = stored ? [fieldOf('velocity_normal', { unit: 'K' })] : [];
    const surfaceFields = ['U', ...own.map(({ name }) => name)];
    state.dataset.value = { ...dataset, surfaceFields, fields: [{ ...fields[0]!, unit: 'm/s' }, ...own] };
    view.chosenThing.value = 'c1';
    const place = { origin: [0, 0, 0], normal: [0, 0, 1], field: 'velocity_normal', minus: null };
    const slices = {
        ...{ places: signal(new Map([['c1', place]])), faults: signal(new Map()), late: signal(new Set()) },
        ...{ arrows: { longest: signal(new Map()) }, numbersOf: () => ({ area: 2, mean: 3 }) },
    };
    const panel = await ShownPanel.of('wakesurf-slices', { state, view, slices, time: () => 0 });
    const words = [...panel.get<HTMLSelectElement>('#slice-field').options].map(({ textContent }) => textContent.trim());
    return { fields: words.slice(1), numbers: panel.get('#slice-numbers').textContent };
}

it('a slice says what flows through it where its field is the velocity across it, not a stored one of that name', async () => {
    const derived = await shown(false);
    expect(derived.fields).toEqual(['Velocity across the plane']);
    expect(derived.numbers).toMatch(/^Mean 3.m\/s over 2. .*flow through it/);
    const stored = await shown(true);
    expect(stored.fields).toEqual(['velocity_normal']);
    expect(stored.numbers).toMatch(/^Mean 3.K over 2.$/);
});
