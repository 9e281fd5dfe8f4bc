// Tells, once, when nothing has been drawn for a while: time for a picture that takes longer.

const restMs = 300;

/** As setTimeout and clearTimeout. */
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
    private readonly timers: Timers;
    private pending: unknown = null;

    constructor(reached: () => void, timers: Timers = browserTimers) {
        this.reached = reached;
        this.timers = timers;
    }

    /** Something has been drawn that is worth a better picture, or is not. */
    drawn(worth: boolean): void {
        if (this.pending !== null) this.timers.clear(this.pending);
        this.pending = worth ? this.timers.set(this.end, restMs) : null;
    }

    private readonly end = (): void => {
        this.pending = null;
        this.reached();
    };
}
