import { describe, expect, it } from 'vitest';
import type { RakeRecord } from '../protocol/messages.ts';
import { freeColor, rakeColor, rakeColors } from './palette.ts';

function rakesOf(...colours: (string | undefined)[]): Map<string, RakeRecord> {
    return new Map(colours.map((colour, i) => [`r${i}`, { rake: `r${i}`, colour } as RakeRecord]));
}

describe('the colour of a rake', () => {
    it('is its own, or else one by its place', () => {
        const rakes = rakesOf(undefined, '#123456', undefined);
        const colors = [...rakes.values()].map((each) => rakeColor(each, rakes));
        expect(colors).toEqual([rakeColors[0], '#123456', rakeColors[2]]);
    });

    it('of a new one is no other rake’s, as long as there are enough', () => {
        expect(freeColor(rakesOf(rakeColors[0], rakeColors[2]))).toBe(rakeColors[1]);
        expect(rakeColors).toContain(freeColor(rakesOf(...rakeColors)));
    });
});
