import { describe, expect, it } from 'vitest';
import { averagedFields, readNumbers } from './numberTable.ts';
import { datasetOf } from '../../testing/records.ts';

describe('the numbers of a surface', () => {
    it('have their units, and are not a number where the server knows none', () => {
        const table = readNumbers('time [s],area [m^2],entered,notes\n0.5,1e-3,,"torn, ""twice"""\n1,2,0,\n');
        expect([...table.units]).toEqual([
            ['time', 's'],
            ['area', 'm^2'],
            ['entered', ''],
        ]);
        expect([...(table.rows[0]?.values() ?? [])]).toEqual([0.5, 0.001, Number.NaN]);
        expect(table.rows[1]?.get('entered')).toBe(0);
        expect(table.notes).toEqual(['torn, "twice"', '']);
    });

    it('ask for the means of the velocity and of what the surface carries for its colours', () => {
        const dataset = datasetOf({ velocity: 'u, v, w' });
        const fields = ['p (cells)', 'normal_x', 'velocity_y', 'twin_lag', 'deformation'];
        expect(averagedFields(dataset, { fields })).toEqual(['u, v, w', 'p (cells)', 'deformation']);
        expect([...readNumbers('mean_p (cells) [Pa],notes\n1,\n').units]).toEqual([['mean_p (cells)', 'Pa']]);
    });

    it('may be of a unit with commas, quotes and brackets', () => {
        expect([...readNumbers('"area [a,""b] [^2]",notes\n1,\n').units]).toEqual([['area', 'a,"b] [^2']]);
    });
});
