import { describe, expect, it } from 'vitest';
import { isShownAt } from './figure.ts';

describe('a surface of a picture', () => {
    it('is waited for at the time asked for, or at the nearer end of what it covers, whichever way it runs', () => {
        for (const ends of [
            { from: 1, to: 5 },
            { from: 5, to: 1 },
        ]) {
            expect([2, 2 + 1e-7, 2.1].map((shown) => isShownAt(ends, shown, 2))).toEqual([true, true, false]);
            expect([isShownAt(ends, 5, 7), isShownAt(ends, 1, 7), isShownAt(ends, 1, 0)]).toEqual([true, false, true]);
        }
    });
});
