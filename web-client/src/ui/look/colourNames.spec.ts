import { describe, expect, it } from 'vitest';
import { plainStyle } from '../../scene/surface/surfaceStyle.ts';
import { datasetOf, fieldOf } from '../../testing/records.ts';
import { colourChoices, colourTitle } from './colourNames.ts';

function titleOf(scalar: string, time: string, speedUnit?: string): string {
    const velocity = fieldOf('U', { components: 3, ...(speedUnit === undefined ? {} : { unit: speedUnit }) });
    const dataset = datasetOf({ velocity: 'U', fields: [velocity] });
    return colourTitle({ ...plainStyle, scalar }, dataset, 'stream', { length: '', time });
}

describe('what colours show, in words', () => {
    it('has the unit of what is derived from the velocity', () => {
        expect(titleOf('vorticity', 's')).toBe('|Vorticity| (1/s)');
        expect(titleOf('vorticity_y', 'ms')).toBe('Vorticity y (1/ms)');
        expect(titleOf('q_criterion', 's')).toBe('Q, above 0: vortex (1/s²)');
        expect(titleOf('vorticity', '')).toBe('|Vorticity|');
    });

    it.each([
        ['m/s', '1/s'],
        ['m / s', '1/s'],
        ['m s-1', '1/s'],
        ['m s^-1', '1/s'],
        ['mm·ms⁻¹', '1/ms'],
        ['km/h', '1/h'],
    ])('knows the time from a speed in %s where nobody has said it', (speedUnit, unit) => {
        expect(titleOf('vorticity', '', speedUnit)).toBe(`|Vorticity| (${unit})`);
    });

    it('takes the time from the speed where times count the iterations of a solver', () => {
        expect(titleOf('vorticity', 'iterations', 'm/s')).toBe('|Vorticity| (1/s)');
        expect(titleOf('vorticity', 'iterations')).toBe('|Vorticity|');
    });

    it('makes up no unit', () => {
        for (const unit of ['', 'knots', '-', 'm/', 'm^2']) expect(titleOf('vorticity', '', unit)).toBe('|Vorticity|');
        expect(titleOf('speed', 's', 'm/s')).toBe('Speed (m/s)');
    });

    it('offers the vorticity as magnitude and components where the server has them', () => {
        const words = (surfaceFields: string[]): string[] =>
            colourChoices(datasetOf({ surfaceFields }), { kind: 'stream' }, () => true).map((each) => each.words);
        expect(words(['vorticity', 'vorticity_x', 'vorticity_y', 'vorticity_z'])).toEqual(
            expect.arrayContaining(['Vorticity (magnitude)', 'Vorticity x', 'Vorticity y', 'Vorticity z']),
        );
        expect(words(['vorticity'])).not.toContain('Vorticity x');
    });
});
