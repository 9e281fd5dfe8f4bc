import { describe, expect, it } from 'vitest';
import { readUnits, withUnit } from './unitsInPicture.ts';

describe('units', () => {
    it('are what was kept, or none where that is damaged', () => {
        expect(readUnits(JSON.stringify({ length: 'mm', time: 's' }))).toEqual({ length: 'mm', time: 's' });
        for (const text of [null, '', '{', '7', '{"length":7}']) {
            expect(readUnits(text)).toEqual({ length: '', time: '' });
        }
    });

    it('stand behind their number', () => {
        expect(withUnit('7.3', 'mm')).toBe('7.3 mm');
        expect(withUnit('7.3', '')).toBe('7.3');
    });
});
