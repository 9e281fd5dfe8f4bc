import { describe, expect, it } from 'vitest';
import { turnByKey } from './viewKeys.ts';

function did(key: string, shiftKey = false): [string, ...number[]][] {
    const heard: [string, ...number[]][] = [];
    const controls = {
        turn: (...by: number[]) => void heard.push(['turn', ...by.map((angle) => Math.round((angle * 180) / Math.PI))]),
        pan: (...by: number[]) => void heard.push(['pan', ...by]),
        zoom: (factor: number) => void heard.push(['zoom', factor]),
    };
    expect(turnByKey({ key, shiftKey }, controls)).toBe(heard.length > 0);
    return heard;
}

describe('keys for the camera', () => {
    it('turn by arrows, move by arrows with Shift, and zoom', () => {
        expect(did('ArrowRight')).toEqual([['turn', 5, 0]]);
        expect(did('ArrowDown')).toEqual([['turn', 0, -5]]);
        expect(did('ArrowLeft', true)).toEqual([['pan', -0.05, 0]]);
        expect(did('ArrowUp', true)).toEqual([['pan', 0, 0.05]]);
        for (const key of ['+', '=']) expect(did(key)).toEqual([['zoom', 1.15]]);
        expect(did('-')).toEqual([['zoom', 1 / 1.15]]);
    });

    it('leave all others alone', () => {
        for (const key of ['a', 'Enter', ' ', 'PageUp', 'Tab', 'constructor']) expect(did(key)).toEqual([]);
    });
});
