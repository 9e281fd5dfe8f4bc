import { beforeEach, describe, expect, it } from 'vitest';
import { Stillness, type Timers } from './stillness.ts';

class Clock implements Timers {
    now = 0;
    private readonly waiting = new Map<number, { at: number; act: () => void }>();
    private count = 0;

    set(act: () => void, ms: number): number {
        this.waiting.set(++this.count, { at: this.now + ms, act });
        return this.count;
    }

    clear(timer: unknown): void {
        this.waiting.delete(timer as number);
    }

    pass(ms: number): void {
        this.now += ms;
        for (const [timer, { at, act }] of [...this.waiting]) {
            if (at > this.now) continue;
            this.waiting.delete(timer);
            act();
        }
    }
}

describe('stillness', () => {
    let clock: Clock;
    let reached: number;
    let stillness: Stillness;

    beforeEach(() => {
        clock = new Clock();
        reached = 0;
        stillness = new Stillness(() => ++reached, 300, clock);
    });

    it('is reached once, 300 ms after the last picture', () => {
        for (let i = 0; i < 10; ++i) {
            stillness.drawn(true);
            clock.pass(299);
        }
        expect(reached).toBe(0);
        clock.pass(1);
        expect(reached).toBe(1);
        clock.pass(10_000);
        expect(reached).toBe(1);
    });

    it('takes longer where that is asked for, and as long as ever after that', () => {
        stillness.drawn(true, 900);
        clock.pass(899);
        expect(reached).toBe(0);
        clock.pass(1);
        expect(reached).toBe(1);
        stillness.drawn(true);
        clock.pass(300);
        expect(reached).toBe(2);
    });

    it('is not waited for after a picture that cannot be better', () => {
        stillness.drawn(true);
        clock.pass(100);
        stillness.drawn(false);
        clock.pass(10_000);
        expect(reached).toBe(0);
    });

    it('is not reached while something is held, however long the hand rests, but 300 ms after it is let go', () => {
        stillness.drawn(true);
        clock.pass(200);
        stillness.hold(true);
        clock.pass(10_000);
        stillness.drawn(true);
        clock.pass(10_000);
        stillness.hold(false);
        clock.pass(299);
        expect(reached).toBe(0);
        clock.pass(1);
        expect(reached).toBe(1);
    });

    it('is not reached again by a press that draws nothing', () => {
        stillness.drawn(false);
        stillness.hold(true);
        stillness.hold(false);
        clock.pass(10_000);
        expect(reached).toBe(0);
    });
});
