// Notices a worker that hangs, from outside: it is asked every second and has two to answer. Bytes that make
// a decoder run for ever can then cost one worker, not the page.
import type { Clock, Timer } from '../connection/clock.ts';

const askEveryMs = 1000;
export const answerWithinMs = 2000;

export interface WatchdogOptions {
    clock: Clock;
    ask: () => void;
    onHang: () => void;
}

export class Watchdog {
    private readonly options: WatchdogOptions;
    private timer: Timer | null = null;
    private askedAt: number | null = null;

    constructor(options: WatchdogOptions) {
        this.options = options;
    }

    /** From the first sign of life on: loading may take its time. */
    heard(): void {
        this.askedAt = null;
        if (this.timer === null) this.wait();
    }

    /** The worker is replaced; the new one is heard first. */
    stop(): void {
        if (this.timer !== null) this.options.clock.cancel(this.timer);
        this.timer = null;
        this.askedAt = null;
    }

    private wait(): void {
        const { clock } = this.options;
        const due = clock.now() + askEveryMs;
        this.timer = clock.after(askEveryMs, () => this.check(clock.now() - due));
    }

    private check(lateMs: number): void {
        const { clock, ask, onHang } = this.options;
        const now = clock.now();
        // This page itself stood still, as when the computer slept: an answer may be waiting to be heard.
        if (this.askedAt !== null && lateMs > askEveryMs) this.askedAt = now;
        if (this.askedAt !== null && now - this.askedAt >= answerWithinMs) {
            this.stop();
            onHang();
            return;
        }
        if (this.askedAt === null) {
            this.askedAt = now;
            ask();
        }
        this.wait();
    }
}
