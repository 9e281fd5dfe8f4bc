import { describe, expect, it } from 'vitest';
import { agoWords, dayWords } from './words.ts';

describe('a moment in words', () => {
    it('is told by the largest unit that fits', () => {
        const now = Date.parse('2026-11-22T12:00:00Z');
        expect(agoWords('2026-11-22T11:59:30Z', now)).toBe('just now');
        expect(agoWords('2026-11-22T11:58:00Z', now)).toBe('2 minutes ago');
        expect(agoWords('2026-11-22T09:10:00Z', now)).toBe('2 hours ago');
        expect(agoWords('2026-11-21T11:00:00Z', now)).toBe('yesterday');
        expect(agoWords('2026-10-20T12:00:00Z', now)).toBe('last month');
        expect(agoWords('2020-01-01T00:00:00Z', now)).toBe('6 years ago');
    });

    it('is no claim where the server has said nothing that can be read', () => {
        expect(agoWords('', Date.now())).toBe('at an unknown time');
        expect(dayWords('2026-12-22T12:00:00Z')).toBe('December 22, 2026');
    });
});
