// @vitest-environment happy-dom
import { signal } from '@preact/signals-core';
import { expect, it, vi } from 'vitest';
import { PageBench } from '../../testing/pageBench.ts';
import { ShownPanel } from '../../testing/shownPanel.ts';
import './bodyRakePanel.ts';
import { loadBodyRakes } from './loadBodyRakes.ts';

const bodyRakes = {
    typedOff: signal<number | null>(null),
    off: signal(0.1),
    offSpan: signal([1e-5, 20]),
    alongEdge: signal(false),
    canMake: signal(true),
    canEnd: true,
    end: vi.fn(() => Promise.resolve()),
};
vi.mock('../slices/openedFields.ts', () => ({
    BodyRakes: class {
        constructor() {
            return bodyRakes;
        }
    },
}));

async function shown() {
    const { state, view } = new PageBench();
    state.dataset.value = { ...state.dataset.value!, patches: [{ name: 'square', kind: 'wall', triangles: 1 }] };
    return ShownPanel.of('wakesurf-body-rake', { state, view, bodyRakes });
}

it('Enter ends the line, but not in a field or on a button, which have it for themselves', async () => {
    const model = loadBodyRakes({} as Parameters<typeof loadBodyRakes>[0]);
    await vi.waitFor(() => expect(model.value).not.toBeNull());
    const panel = await shown();
    const pressed = (at: Element): number => {
        at.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true, composed: true, cancelable: true }));
        return bodyRakes.end.mock.calls.length;
    };
    expect(pressed(panel.get('#body-rake-off'))).toBe(0);
    expect(pressed(panel.get('#body-rake-cancel'))).toBe(0);
    expect(pressed(document.body)).toBe(1);
    expect(pressed(document.body.appendChild(document.createElement('canvas')))).toBe(2);
    bodyRakes.canEnd = false;
    expect(pressed(document.body)).toBe(2);
});

it('takes distances that are neither lost in the body nor beyond the domain', async () => {
    const panel = await shown();
    const off = panel.get('#body-rake-off');
    const typed = (value: string): number | null => {
        off.value = value;
        off.dispatchEvent(new Event('change'));
        return bodyRakes.typedOff.value;
    };
    expect(['1e-320', '0', '21'].map(typed)).toEqual([null, null, null]);
    expect(typed('0.5')).toBe(0.5);
});

it('makes no rake along an outline while none can be made', async () => {
    bodyRakes.canMake.value = false;
    expect((await shown()).get<HTMLButtonElement>('#body-rake-outline').disabled).toBe(true);
});
