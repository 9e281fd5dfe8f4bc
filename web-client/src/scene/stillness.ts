// Tells, once, when nothing has been drawn for a while and nothing is held: time for a picture that takes
// longer.

/** Works like setTimeout and clearTimeout. */
export interface Timers {
    set(act: () => void, ms: number): unknown;
    clear(timer: unknown): void;
}

const browserTimers: Timers = {
    set: (act, ms) => setTimeout(act, ms),
    clear: (timer) => clearTimeout(timer as ReturnType<typeof setTimeout>),
};

export class Stillness {
    private readonly reached: () => void;
    private readonly restMs: number;
    private readonly timers: Timers;
    private pending: unknown = null;
    /** The last picture could be better. */
    private worth = false;
    private held = false;
    private waitMs = 0;

    /** @param restMs how long a while is */
    constructor(reached: () => void, restMs: number, timers: Timers = browserTimers) {
        this.reached = reached;
        this.restMs = restMs;
        this.timers = timers;
    }

    /** Something has been drawn that is worth a better picture, or is not. @param atLeastMs longer than
     *  usual, if need be */
    drawn(worth: boolean, atLeastMs = 0): void {
        this.worth = worth;
        this.waitMs = Math.max(this.restMs, atLeastMs);
        this.wait();
    }

    /** A hand that rests may move on at any moment, and must not find that picture under way. */
    hold(held: boolean): void {
        if (held === this.held) return;
        this.held = held;
        this.wait();
    }

    private wait(): void {
        if (this.pending !== null) this.timers.clear(this.pending);
        this.pending = this.worth && !this.held ? this.timers.set(this.end, this.waitMs) : null;
    }

    private readonly end = (): void => {
        this.pending = null;
        this.reached();
    };
}
