import { describe, expect, it } from 'vitest';
import { BackOff } from './backOff.ts';

describe('BackOff', () => {
    it('doubles from 250 ms up to 5 s', () => {
        const backOff = new BackOff(() => 1);
        const waits = Array.from({ length: 7 }, () => backOff.nextWaitMs());
        expect(waits).toEqual([250, 500, 1000, 2000, 4000, 5000, 5000]);
    });

    it('never waits less than half of that', () => {
        const backOff = new BackOff(() => 0);
        expect([backOff.nextWaitMs(), backOff.nextWaitMs()]).toEqual([125, 250]);
    });

    it('starts again after a success', () => {
        const backOff = new BackOff(() => 1);
        backOff.nextWaitMs();
        backOff.nextWaitMs();
        backOff.reset();
        expect(backOff.nextWaitMs()).toBe(250);
    });
});
