import { describe, expect, it } from 'vitest';
import { Gestures } from './gestures.ts';

describe('what a slider sends', () => {
    it('is one act while it moves, and another after a pause or of another slider', () => {
        const gestures = new Gestures();
        const names = [0, 400, 1300, 2200].map((at) => gestures.slid('length', at));
        expect(new Set(names).size).toBe(1);
        expect(gestures.slid('length', 3300)).not.toBe(names[0]);
        const other = gestures.slid('from', 3400);
        expect(gestures.slid('from', 3500)).toBe(other);
        expect(gestures.slid('length', 3600)).not.toBe(other);
    });

    it('is one act as long as it is held, however long the hand rests', () => {
        const gestures = new Gestures();
        gestures.press();
        const name = gestures.slid('length', 0);
        expect(gestures.slid('length', 60_000)).toBe(name);
        gestures.release();
        expect(gestures.slid('length', 120_000)).not.toBe(name);
    });

    it('is one act too when it is held again at once, and the hand rests then', () => {
        const gestures = new Gestures();
        gestures.press();
        const name = gestures.slid('length', 0);
        gestures.release();
        gestures.press();
        expect(gestures.slid('length', 500)).toBe(name);
        expect(gestures.slid('length', 60_000)).toBe(name);
    });
});

describe('what a button sends', () => {
    it('is an act for each press, and one for all repeats of a key that is held', () => {
        const gestures = new Gestures();
        const names = [0, 1, 2].map((at) => {
            gestures.press();
            const first = gestures.pressed('rake r1 shape', at);
            expect(gestures.pressed('rake r1 shape', at + 500)).toBe(first);
            gestures.release();
            return first;
        });
        expect(new Set(names).size).toBe(3);
        expect(gestures.pressed('rake r1 shape', 4)).not.toBe(gestures.pressed('rake r1 shape', 5));
    });
});

describe('what plays', () => {
    it('goes with the act of its user that came last, and not with the one before it', () => {
        const gestures = new Gestures();
        const before = gestures.slid('length', 0);
        const playing = gestures.begin();
        expect(playing).not.toBe(before);
        expect(gestures.current).toBe(playing);
        const slid = gestures.slid('length', 100);
        expect(slid).not.toBe(before);
        expect(gestures.current).toBe(slid);
    });
});
