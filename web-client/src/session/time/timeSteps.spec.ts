import { describe, expect, it } from 'vitest';
import { clampTo, nearestStep, otherSide, releasedSpan, stepFrom, stepTicks, timelineSpan } from './timeSteps.ts';

const times = [8.5, 9, 10, 10.25, 16];

describe('time-steps', () => {
    it('step on and back over every one, and stop at the ends', () => {
        const on = [8.5];
        while (on.at(-1)! < 16) on.push(stepFrom(times, on.at(-1)!, 1, [8.5, 16]));
        expect(on).toEqual(times);
        const back = [16];
        while (back.at(-1)! > 8.5) back.push(stepFrom(times, back.at(-1)!, -1, [8.5, 16]));
        expect(back).toEqual([...times].reverse());
        // Microseconds, in seconds since 1970.
        const late = [0, 1, 2, 3].map((i) => 1700000000 + i * 1e-5);
        expect(stepFrom(late, late[1]!, 1, [late[0]!, late[3]!])).toBe(late[2]);
        expect(stepFrom(times, 16, 1, [8.5, 16])).toBe(16);
        expect(stepFrom(times, 8.5, -1, [8.5, 16])).toBe(8.5);
    });

    it('step from between two to either, within the span of the surface', () => {
        expect(stepFrom(times, 9.3, 1, [8.5, 16])).toBe(10);
        expect(stepFrom(times, 9.3, -1, [8.5, 16])).toBe(9);
        expect(stepFrom(times, 10.1, 1, [9, 10.2])).toBe(10.2);
        expect(stepFrom(times, 9.5, -1, [9.2, 10.2])).toBe(9.2);
        // Not from a rounding error to the same time again.
        expect(stepFrom(times, 10 - 1e-9, 1, [8.5, 16])).toBe(10.25);
    });

    it('are twentieths where the data have only one', () => {
        expect(stepFrom([0], 0, 1, [0, 10])).toBeCloseTo(0.5);
        expect(stepFrom([0], 9.9, 1, [0, 10])).toBe(10);
    });

    it('are found by time', () => {
        expect(times.map((t) => nearestStep(times, t + 0.1))).toEqual([0, 1, 2, 3, 4]);
        expect(clampTo([1, 2], 3)).toBe(2);
    });

    it('of a streak surface in which it is released begin at its release, whichever way it runs', () => {
        expect(releasedSpan([1, 5], 'streak', false)).toEqual([1, 5]);
        expect(releasedSpan([1, 5], 'streak', false, 2)).toEqual([1, 2]);
        expect(releasedSpan([1, 5], 'streak', true)).toEqual([1, 5]);
        expect(releasedSpan([1, 5], 'streak', true, 4)).toEqual([4, 5]);
        expect([releasedSpan([1, 5], 'path', false), releasedSpan([1, 5], 'time', true)]).toEqual([
            [1, 1],
            [5, 5],
        ]);
    });

    it('have the other side of a surface that goes both ways, as long as the data have it', () => {
        expect(otherSide(10, 11, times)).toBe(9);
        expect(otherSide(10, 16, times)).toBe(8.5);
        expect(otherSide(8.5, 16, times)).toBe(8.5);
        expect(otherSide(0, 4, [0])).toBe(-4);
    });

    it('and the surface fit on the timeline', () => {
        expect(timelineSpan(times, null)).toEqual([8.5, 16]);
        expect(timelineSpan([0], [0, 40])).toEqual([0, 40]);
        expect(timelineSpan([], null)).toEqual([0, 1]);
    });
});

describe('the numbers of the line of time', () => {
    it('stand at time-steps, with as many digits as tell them', () => {
        const steps = Array.from({ length: 16 }, (_, i) => 8.5 + 0.5 * i);
        expect(
            stepTicks(steps, [8.5, 16], 16)
                .ticks.map(({ label }) => label)
                .slice(0, 3),
        ).toEqual(['8.5', '9.0', '9.5']);
        expect(stepTicks(steps, [8.5, 16], 9).ticks.map(({ value }) => value)).toEqual(steps.filter((_, i) => i % 2 === 0));
        const short = Array.from({ length: 6 }, (_, i) => 0.1 + 0.0001 * i);
        expect(stepTicks(short, [0.1, 0.1005], 8).ticks.map(({ label }) => label)).toEqual([
            '0.1000',
            '0.1001',
            '0.1002',
            '0.1003',
            '0.1004',
            '0.1005',
        ]);
        expect(stepTicks([-2, -1, 0], [-2, 0], 4).ticks.map(({ label }) => label)).toEqual(['\u22122', '\u22121', '0']);
    });

    it('are at most as many as are wanted, however many steps there are, and at steps all of them', () => {
        for (const count of [2, 3, 7, 40, 999, 12_345]) {
            const steps = Array.from({ length: count }, (_, i) => 1000 + 0.37 * i);
            for (const wanted of [1, 2.5, 5, 14]) {
                const { ticks } = stepTicks(steps, [0, 1e6], wanted);
                expect(ticks.length).toBeLessThanOrEqual(Math.ceil(wanted) + 1);
                expect(ticks.every(({ value }) => steps.includes(value))).toBe(true);
            }
        }
    });

    it('are round where there are no two steps in the span', () => {
        expect(stepTicks([5], [0, 10], 5).ticks.map(({ label }) => label)).toEqual(['0', '2', '4', '6', '8', '10']);
    });
});
