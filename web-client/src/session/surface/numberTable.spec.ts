import { describe, expect, it } from 'vitest';
import { readNumbers } from './numberTable.ts';

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

    it('may be of a unit with commas, quotes and brackets', () => {
        expect([...readNumbers('"area [a,""b] [^2]",notes\n1,\n').units]).toEqual([['area', 'a,"b] [^2']]);
    });
});
