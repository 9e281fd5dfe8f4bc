import { describe, expect, it } from 'vitest';
import { maxFrames, frameTimes } from './film.ts';

describe('the frames of a film', () => {
    it('begin and end with the playback, at even distances', () => {
        const times = frameTimes([8.5, 16], { fps: 25, seconds: 10 });
        expect(times).toHaveLength(250);
        expect([times[0], times.at(-1)]).toEqual([8.5, 16]);
        for (const [i, time] of times.slice(1).entries()) expect(time - times[i]!).toBeCloseTo(7.5 / 249);
    });

    it('are at least two and not too many', () => {
        expect(frameTimes([0, 1], { fps: 12, seconds: 0.01 })).toEqual([0, 1]);
        expect(frameTimes([0, 1], { fps: 60, seconds: 1e6 })).toHaveLength(maxFrames);
    });
});
