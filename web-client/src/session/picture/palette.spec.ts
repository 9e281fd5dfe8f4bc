import { describe, expect, it } from 'vitest';
import type { RakeRecord } from '../../protocol/messages.ts';
import { rakeOf } from '../../testing/records.ts';
import { rakeColour, rakeColours } from './palette.ts';

function rakesOf(...colours: (string | undefined)[]): Map<string, RakeRecord> {
    return new Map(colours.map((colour, i) => [`r${i}`, rakeOf(`r${i}`, { colour })]));
}

describe('the colour of a rake', () => {
    it('is its own, or else one by its place', () => {
        const rakes = rakesOf(undefined, '#123456', '');
        const colours = [...rakes.values()].map((each) => rakeColour(each, rakes));
        expect(colours).toEqual([rakeColours[0], '#123456', rakeColours[2]]);
    });
});
