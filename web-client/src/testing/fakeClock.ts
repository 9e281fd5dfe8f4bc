// A clock for tests: time passes only when told to.
import type { Clock, Timer } from '../connection/clock.ts';

export class FakeClock implements Clock {
    private time = 0;
    private nextTimer = 1;
    private readonly timers = new Map<Timer, { at: number; action: () => void }>();

    now(): number {
        return this.time;
    }

    after(delayMs: number, action: () => void): Timer {
        const timer = this.nextTimer++;
        this.timers.set(timer, { at: this.time + delayMs, action });
        return timer;
    }

    cancel(timer: Timer): void {
        this.timers.delete(timer);
    }

    random(): number {
        return 1;
    }

    /** Lets time pass, timers firing in order, and what they start being settled in between. */
    async pass(milliseconds: number): Promise<void> {
        const end = this.time + milliseconds;
        for (;;) {
            const due = [...this.timers].filter(([, { at }]) => at <= end);
            const [next] = due.sort(([, a], [, b]) => a.at - b.at);
            if (next === undefined) break;
            const [timer, { at, action }] = next;
            this.timers.delete(timer);
            this.time = at;
            action();
            await settled();
        }
        this.time = end;
        await settled();
    }
}

export async function settled(): Promise<void> {
    for (let i = 0; i < 10; ++i) await Promise.resolve();
}
