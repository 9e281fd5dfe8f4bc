import { describe, expect, it } from 'vitest';
import type { RakeRecord } from '../../protocol/messages.ts';
import { rakeColor, rakeColors } from './palette.ts';

function rakesOf(...colours: (string | undefined)[]): Map<string, RakeRecord> {
    return new Map(colours.map((colour, i) => [`r${i}`, { rake: `r${i}`, colour } as RakeRecord]));
}

describe('the colour of a rake', () => {
    it('is its own, or else one by its place', () => {
        const rakes = rakesOf(undefined, '#123456', '');
        const colors = [...rakes.values()].map((each) => rakeColor(each, rakes));
        expect(colors).toEqual([rakeColors[0], '#123456', rakeColors[2]]);
    });
});
