import { describe, expect, it } from 'vitest';
import { LatencyLog } from './latency.ts';

describe('LatencyLog', () => {
    it('measures from the edit to the first picture of its epoch', () => {
        const log = new LatencyLog();
        log.answered('s1', 5, 1000);
        log.shown('s1', 5, 1080);
        log.shown('s1', 5, 1300);
        expect(log.samples).toEqual([{ surface: 's1', epoch: 5, milliseconds: 80 }]);
    });

    it('also when the picture overtakes the answer', () => {
        const log = new LatencyLog();
        log.shown('s1', 5, 1080);
        log.answered('s1', 5, 1000);
        expect(log.samples.map(({ milliseconds }) => milliseconds)).toEqual([80]);
    });

    it('counts no epoch that was never shown, and no other surface', () => {
        const log = new LatencyLog();
        log.answered('s1', 5, 1000);
        log.answered('s1', 6, 1010);
        log.shown('s2', 5, 1020);
        log.shown('s1', 6, 1100);
        expect(log.samples).toEqual([{ surface: 's1', epoch: 6, milliseconds: 90 }]);
    });
});
