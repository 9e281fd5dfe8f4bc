import { describe, expect, it } from 'vitest';
import { LatencyLog } from './latency.ts';

const drawn = { decodeMs: 3, drawMs: 20, roundTripMs: 2 };

describe('LatencyLog', () => {
    it('measures from the edit to the first picture of its epoch', () => {
        const log = new LatencyLog();
        log.answered('s1', 5, 1000);
        log.shown('s1', 5, 1080, drawn);
        log.shown('s1', 5, 1300, drawn);
        expect(log.samples).toMatchObject([{ surface: 's1', epoch: 5, milliseconds: 80 }]);
    });

    it('also when the picture overtakes the answer', () => {
        const log = new LatencyLog();
        log.shown('s1', 5, 1080, drawn);
        log.answered('s1', 5, 1000);
        expect(log.samples.map(({ milliseconds }) => milliseconds)).toEqual([80]);
    });

    it('counts no epoch that was never shown, and no other surface', () => {
        const log = new LatencyLog();
        log.answered('s1', 5, 1000);
        log.answered('s1', 6, 1010);
        log.shown('s2', 5, 1020, drawn);
        log.shown('s1', 6, 1100, drawn);
        expect(log.samples).toMatchObject([{ surface: 's1', epoch: 6, milliseconds: 90 }]);
    });

    it('says where the time went: the parts of the first pass, and all of them are the whole', () => {
        const log = new LatencyLog();
        log.answered('s1', 5, 1000);
        log.passed('s1', 5, { queue: 0.001, load: 0, compute: 0.004, encode: 0.0005 });
        log.passed('s1', 5, { queue: 0.1, load: 0.2, compute: 0.3, encode: 0.4 });
        log.shown('s1', 5, 1080, drawn);
        const { parts } = log.samples[0]!;
        expect(parts).toEqual({ network: 2, queue: 1, load: 0, compute: 4, encode: 0.5, decode: 3, draw: 20, rest: 49.5 });
        expect(Object.values(parts).reduce((a, b) => a + b)).toBe(80);
    });
});
