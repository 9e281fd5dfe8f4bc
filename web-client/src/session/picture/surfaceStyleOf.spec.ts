import { describe, expect, it } from 'vitest';
import { usualLook } from '../../state/surfaceLook.ts';
import { datasetOf, fieldOf, rakeOf, surfaceOf } from '../../testing/records.ts';
import { attributesOf, colourFields, styleOf } from './surfaceStyleOf.ts';

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
