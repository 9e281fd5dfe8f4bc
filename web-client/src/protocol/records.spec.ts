import { describe, expect, it } from 'vitest';
import { errorWords, readError } from './records.ts';

describe('why something failed', () => {
    it('is what and what to do, in one text', () => {
        expect(errorWords({ message: 'it is outside', hint: 'move it' })).toBe('it is outside: move it');
        expect(errorWords({ message: 'it is outside', hint: '' })).toBe('it is outside');
        expect(errorWords({ message: 'it is outside' })).toBe('it is outside');
    });

    it('is read from an object that says so, and from no other', () => {
        expect(readError({ message: 'it is outside', hint: 'move it', code: 7 })).toEqual({
            message: 'it is outside',
            hint: 'move it',
        });
        expect(readError({ message: 'it is outside', hint: '', kind: 3 })).toEqual({ message: 'it is outside' });
        expect(readError({ hint: 'move it' })).toBeNull();
        expect(readError('it is outside')).toBeNull();
    });
});
