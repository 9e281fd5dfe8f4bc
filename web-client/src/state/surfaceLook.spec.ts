import { describe, expect, it } from 'vitest';
import { decodeLook, encodeLook, type SurfaceLook, usualLook } from './surfaceLook.ts';

const other: SurfaceLook = {
    colourBy: 'field:p',
    colour: '#12abEF',
    map: 'coolToWarm',
    invert: true,
    log: true,
    root: true,
    bands: 8,
    range: [-1, 2.5],
    rangeOf: 'data',
    centre: 0,
    backSide: 'tinted',
    points: true,
    opacity: 0.4,
    angleOpacity: true,
    smoke: 0.5,
    silhouettes: true,
    hatched: false,
    lines: 'checker',
    pieces: 'arrows',
    pieceEvery: 0.5,
    pieceWidth: 0.1,
    density: 2,
    texture: true,
    animated: true,
    sWindow: [0.25, 0.5],
    ageWindow: [1, 3],
    hiddenParts: [[0.5, 2]],
    trimmed: false,
    curved: true,
    painting: true,
    faded: 0.1,
};

describe('a look', () => {
    it('comes back from JSON as it was, and says nothing where it is the usual', () => {
        expect(Object.keys(other)).toEqual(Object.keys(usualLook));
        expect(decodeLook(JSON.parse(JSON.stringify(encodeLook(other))))).toEqual(other);
        expect(encodeLook(usualLook)).toEqual({});
        expect(encodeLook({ ...usualLook, opacity: 0.5 })).toEqual({ opacity: 0.5 });
    });

    it('is the usual one where there is none', () => {
        for (const nothing of [null, undefined, 7, 'look', [], [1, 2]]) expect(decodeLook(nothing)).toEqual(usualLook);
    });

    it('keeps what is right and drops what is not', () => {
        const wrong = {
            colourBy: '',
            colour: 'red; background: url(x)',
            map: 'jet',
            invert: 'yes',
            range: [3, 1],
            centre: Number.NaN,
            backSide: 3,
            opacity: 2,
            smoke: -0.1,
            lines: 'toString',
            density: 0,
            sWindow: [0.1],
            ageWindow: [0, Number.POSITIVE_INFINITY],
            hiddenParts: [[1, 2, 3]],
            faded: null,
            ['__proto__']: { opacity: 0 },
            toString: 4,
            more: 1,
        };
        expect(decodeLook(wrong)).toEqual(usualLook);
        expect(decodeLook({ ...wrong, opacity: 0.25, log: true })).toEqual({ ...usualLook, opacity: 0.25, log: true });
        expect(Object.keys(decodeLook(wrong))).toEqual(Object.keys(usualLook));
    });
});
