import { describe, expect, it } from 'vitest';
import { endOf, typedFrom, typedTo } from './surfaceTimes.ts';

const times = [0, 5, 10];
const streak = { kind: 'streak', from: 2, length: 6, direction: 'forward' } as const;
const backward = { ...streak, from: 8, direction: 'backward' } as const;

describe('a first time that is typed', () => {
    it('leaves the end where it is', () => {
        expect(typedFrom(streak, 4, times, false)).toEqual({ change: { from: 4, length: 4 }, remark: null });
        expect(typedFrom(backward, 5, times, false)).toEqual({ change: { from: 5, length: 3 }, remark: null });
    });

    it('moves the whole where it is past the end', () => {
        expect(typedFrom(streak, 9, times, false)).toEqual({ change: { from: 9 }, remark: null });
    });

    it('stops at the ends of the data, in words', () => {
        expect(typedFrom(streak, -3, times, false)).toEqual({
            change: { from: 0, length: 8 },
            remark: 't = −3 is outside the data, which go from 0 to 10: 0 is taken.',
        });
    });

    it('that rounding has put before the data is their first, without a word', () => {
        const first = Math.fround(0.1); // 0.100000001
        expect(typedFrom({ ...streak, from: 0.2 }, 0.1, [first, 5, 10], false)).toEqual({
            change: { from: first, length: expect.closeTo(6.1, 6) as number },
            remark: null,
        });
    });

    it('is any time where the flow is steady, and no other length for a stream surface', () => {
        expect(typedFrom(streak, -3, times, true)).toEqual({ change: { from: -3, length: 11 }, remark: null });
        expect(typedFrom({ ...streak, kind: 'stream' }, 7, times, false)).toEqual({ change: { from: 7 }, remark: null });
    });
});

describe('a last time that is typed', () => {
    it('is how long it is followed, and stops at the end of the data', () => {
        expect(typedTo(streak, 9.5, times, false)).toEqual({ change: { length: 7.5 }, remark: null });
        expect(typedTo(streak, 12, times, false)).toEqual({
            change: { length: 8 },
            remark: 't = 12 is outside the data, which go from 0 to 10: 10 is taken.',
        });
    });

    it('is earlier than the first of a surface that goes backward', () => {
        expect(typedTo(streak, 1, times, false).change).toEqual({ length: 1, direction: 'backward' });
        expect(typedTo(backward, 9, times, false).change).toEqual({ length: 1, direction: 'forward' });
        expect(typedTo({ ...streak, kind: 'path', direction: 'both' }, 1, times, false).change).toEqual({ length: 1 });
    });

    it('changes nothing where it is the first, and says so', () => {
        expect(typedTo(streak, 2, times, false)).toEqual({ change: null, remark: 'It ends at another time than it begins.' });
    });
});

describe('endOf', () => {
    it('is never beyond the data by what sums are rounded', () => {
        let beyond = 0;
        for (let i = 1; i < 300; ++i) {
            const [from, last] = [-i / 7, 0.01 + i / 1000];
            if (from + (last - from) > last) ++beyond;
            expect(endOf({ ...streak, from, length: 1e9 }, [from, last], false)).toBeLessThanOrEqual(last);
        }
        expect(beyond, 'sums that were').toBeGreaterThan(0);
    });
});
