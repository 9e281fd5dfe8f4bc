import { describe, expect, it } from 'vitest';
import type { ValueRange } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { usualLook } from '../../state/surfaceLook.ts';
import { ViewState } from '../../state/viewState.ts';
import { datasetOf, fieldOf, rakeOf, surfaceOf } from '../../testing/records.ts';
import { attributesOf, automaticRanges, colourFields, styleOf } from './surfaceStyleOf.ts';

const dataset = datasetOf({
    fields: [fieldOf('U', { components: 3, range: [0, 9] }), fieldOf('p', { range: [-2, 5] }), fieldOf('mask')],
    surfaceFields: ['U', 'p', 'deformation', 'approximated'],
});
const record = surfaceOf('s1', { from: 3 });
const rake = rakeOf('r1', {
    points: [
        [0, 0, 0],
        [3, 4, 0],
        [3, 4, 2],
    ],
    colour: '#123456',
});
const facts = { record, rake, dataset, speedRange: [1, 3] as const, automatic: new Map(), fixed: false };

describe('styleOf', () => {
    it('leaves the range to the surface, takes that of the data where it is to, and the locked one before both', () => {
        for (const colourBy of ['speed', 'field:p', 'deformation']) {
            const usual = styleOf({ ...facts, look: { ...usualLook, colourBy } });
            expect(usual).toMatchObject({ range: null, rangeOf: 'surface' });
        }
        const of = (colourBy: string) => styleOf({ ...facts, look: { ...usualLook, colourBy, rangeOf: 'data' } });
        expect(of('speed').rangeOf).toBe('data');
        expect(of('deformation').rangeOf).toBe('surface');
        expect(of('speed')).toMatchObject({ source: 'scalar', scalar: 'speed', range: [1, 3] });
        expect(of('field:p')).toMatchObject({ source: 'scalar', scalar: 'p', range: [-2, 5] });
        expect(of('deformation')).toMatchObject({ source: 'scalar', scalar: 'deformation', range: null });
        expect(of('q_criterion')).toMatchObject({ source: 'scalar', scalar: 'q_criterion', range: null });
        expect(of('age')).toMatchObject({ source: 'age', range: null });
        expect(of('constant')).toMatchObject({ source: 'constant', colour: '#123456' });
        const locked = styleOf({ ...facts, look: { ...usualLook, range: [0, 1] } });
        expect(locked).toMatchObject({ range: [0, 1], rangeOf: 'locked' });
    });

    it('measures age of streak surfaces from their release, and stretching by what the rake sweeps', () => {
        expect(styleOf({ ...facts, look: usualLook })).toMatchObject({ tIsRelease: false, tOrigin: 0, areaPerSeed: 7 * 2 });
        const streak = styleOf({ ...facts, look: usualLook, record: { ...record, kind: 'streak' } });
        expect(streak).toMatchObject({ tIsRelease: true, tOrigin: 3 });
        const patch = styleOf({ ...facts, look: usualLook, record: { ...record, kind: 'time', sweep: [0, 3, 4] } });
        expect(patch.areaPerSeed).toBe(35);
    });
});

describe('the flow texture', () => {
    const fields = ['velocity_x', 'velocity_y', 'velocity_z'];
    const look = { ...usualLook, texture: true, animated: true };

    it('is shown only where the velocity comes with the surface', () => {
        expect(styleOf({ ...facts, look }).texture).toBe(false);
        expect(styleOf({ ...facts, look, record: { ...record, fields } }).texture).toBe(true);
        expect(styleOf({ ...facts, look, record: { ...record, fields: fields.slice(1) } }).texture).toBe(false);
    });

    it('moves with the time that is shown, and by itself in a field that stands still', () => {
        expect(styleOf({ ...facts, look, record: { ...record, kind: 'stream' } }).textureMoves).toBe('byItself');
        expect(styleOf({ ...facts, look, record: { ...record, kind: 'streak' } })).toMatchObject({
            textureMoves: 'withTime',
            from: 3,
        });
        expect(styleOf({ ...facts, look: { ...look, animated: false } }).textureMoves).toBe('no');
    });
});

describe('what is asked of the server', () => {
    it('is what colours and what smoke needs, once', () => {
        expect(attributesOf(usualLook)).toEqual(['speed']);
        expect(attributesOf({ ...usualLook, colourBy: 's' })).toEqual([]);
        expect(attributesOf({ ...usualLook, colourBy: 'field:p', smoke: 1 })).toEqual(['p', 'deformation']);
        expect(attributesOf({ ...usualLook, colourBy: 'deformation', smoke: 1 })).toEqual(['deformation']);
    });

    it('is only what it can send', () => {
        expect(colourFields(dataset).map(({ name }) => name)).toEqual(['p']);
    });
});

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
