import { describe, expect, it } from 'vitest';
import type { ValueRange } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { usualLook } from '../../state/surfaceLook.ts';
import { ViewState } from '../../state/viewState.ts';
import { surfaceOf } from '../../testing/records.ts';
import { automaticRanges } from './colourRanges.ts';
import { styleOf } from './surfaceStyleOf.ts';

function told(attribute: string, low: number, high: number, least = low, greatest = high): ValueRange {
    return { attribute, low, high, least, greatest };
}

function bench(ranges: Record<string, ValueRange[]>) {
    const [state, view] = [new AppState(), new ViewState()];
    state.surfaces.value = new Map(Object.keys(ranges).map((id) => [id, surfaceOf(id, { kind: 'streak' })]));
    state.valueRanges.value = new Map(Object.entries(ranges));
    const styleFor = (id: string, fixed = false) =>
        styleOf({
            ...{ look: view.lookOf(id), record: state.surfaces.value.get(id)!, rake: undefined, dataset: null },
            ...{ speedRange: [0, 9] as const, automatic: automaticRanges(state, view), fixed },
        });
    return { state, view, styleFor };
}

describe('the range of colours', () => {
    it('is one for all surfaces that show the same field, and holds what any of them has', () => {
        const { styleFor } = bench({ s1: [told('speed', 0.2, 1.6)], s2: [told('speed', 0, 1.1)] });
        for (const id of ['s1', 's2']) expect(styleFor(id)).toMatchObject({ range: [0, 1.6], rangeOf: 'surfaces' });
    });

    it('does not hold what is hidden, locked or coloured by something else', () => {
        const { state, view, styleFor } = bench({
            ...{ s1: [told('speed', 0.2, 1)], s2: [told('speed', 0, 4)], s3: [told('speed', 0, 5)] },
            s4: [told('speed', 0, 6), told('vorticity', 0, 7)],
        });
        state.hiddenSurfaces.value = new Set(['s2']);
        view.changeLook('s3', { range: [2, 3] });
        view.changeLook('s4', { colourBy: 'vorticity' });
        expect(styleFor('s1')).toMatchObject({ range: [0.2, 1], rangeOf: 'surface' });
        expect(styleFor('s3')).toMatchObject({ range: [2, 3], rangeOf: 'locked' });
        expect(styleFor('s4')).toMatchObject({ range: [0, 7] });
        state.hiddenSurfaces.value = new Set();
        expect(styleFor('s1')).toMatchObject({ range: [0, 4], rangeOf: 'surfaces' });
    });

    it('says what lies beyond its ends, at both where the values have a sign', () => {
        const { view, styleFor } = bench({
            s1: [told('vorticity', 0, 0.97, 0, 3.47), told('q_criterion', -1, 1, -40, 60), told('speed', 0, 0.98, 0, 0.995)],
        });
        expect(styleFor('s1').beyond).toEqual([null, null]);
        view.changeLook('s1', { colourBy: 'vorticity' });
        expect(styleFor('s1')).toMatchObject({ range: [0, 1], beyond: [null, 3.47] });
        view.changeLook('s1', { colourBy: 'q_criterion' });
        expect(styleFor('s1')).toMatchObject({ range: [-1, 1], beyond: [-40, 60] });
    });

    it('leaves nothing out over powers of ten, where large values take no room', () => {
        const { view, styleFor } = bench({ s1: [told('error', 1e-9, 1e-3, 1e-9, 5)] });
        view.changeLook('s1', { colourBy: 'error', log: true });
        expect(styleFor('s1')).toMatchObject({ range: [1e-9, 5], beyond: [null, null] });
    });

    it('is that of the whole film while one is made, and not of a field that the film does not know', () => {
        const { state, view, styleFor } = bench({ s1: [told('speed', 0, 1)] });
        const fixed = automaticRanges(state, view);
        state.valueRanges.value = new Map([['s1', [told('speed', -3, 8), told('t', 0, 2)]]]);
        const facts = { record: state.surfaces.value.get('s1')!, rake: undefined, dataset: null, speedRange: [0, 9] as const };
        const style = styleOf({ ...facts, look: view.lookOf('s1'), automatic: fixed, fixed: true });
        expect(style).toMatchObject({ range: [0, 1], rangeOf: 'film' });
        const age = { ...usualLook, colourBy: 'age' };
        expect(styleOf({ ...facts, look: age, automatic: fixed, fixed: true })).toMatchObject({
            range: null,
            rangeOf: 'surface',
        });
        expect(styleFor('s1').rangeOf).toBe('surface');
    });

    it('of the age is what the server tells of t, and that across a patch is another', () => {
        const { state, view, styleFor } = bench({ s1: [told('t', 0, 10)], s2: [told('t', 0, 0.5)] });
        state.surfaces.value = new Map([...state.surfaces.value, ['s2', surfaceOf('s2', { kind: 'time' })]]);
        for (const id of ['s1', 's2']) view.changeLook(id, { colourBy: 'age' });
        expect(styleFor('s1').range).toEqual([0, 10]);
        expect(styleFor('s2').range).toEqual([0, 0.5]);
    });
});
