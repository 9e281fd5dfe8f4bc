// When a picture is drawn, and how sharp: when something changed and not otherwise, one animation frame for any number of requests, and the
// next one only when the GPU has finished the last, since a queue of frames would be a queue of delays. While things move it is rather
// quick than sharp; what stands still is worth the time.

/** @param finished to be called when it is done, or will not come @param changed false: only a better picture
 *  is wanted */
export type Draw = (finished: () => void, changed: boolean) => void;

export class FrameLoop {
    private readonly draw: Draw;
    private readonly schedule: (callback: () => void) => void;
    private readonly before: (() => void)[] = [];
    private requested = false;
    private changed = false;
    private another = false;
    private drawing = false;

    constructor(draw: Draw, schedule: (callback: () => void) => void = (callback) => requestAnimationFrame(callback)) {
        this.draw = draw;
        this.schedule = schedule;
    }

    /** Runs an action at the start of every frame. */
    beforeFrame(action: () => void): void {
        this.before.push(action);
    }

    /** Something has changed. */
    readonly request = (): void => {
        this.changed = true;
        this.requestBetter();
    };

    /** Asks for the same picture in better quality. */
    requestBetter(): void {
        if (this.requested) return;
        this.requested = true;
        if (!this.drawing) this.schedule(this.frame);
    }

    /** For what is done at the start of a frame, and is to go on in the next one. What it changes is in its
     *  own frame. */
    requestNext(): void {
        this.another = true;
    }

    private readonly frame = (): void => {
        this.drawing = true;
        for (const action of this.before) action();
        const changed = this.changed;
        this.requested = this.changed = this.another;
        this.another = false;
        this.draw(() => {
            this.drawing = false;
            if (this.requested) this.schedule(this.frame);
        }, changed);
    };
}

/**
 * Submitting a frame returns at once, so a latency taken without this would leave out the drawing itself. Calls back with
 * performance.now() at the moment all commands up to now are done, or with null when they never will be: the context is lost.
 */
export function whenDrawn(gl: WebGL2RenderingContext, done: (time: number | null) => void): void {
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (fence === null) {
        done(null);
        return;
    }
    gl.flush();
    const poll = (): void => {
        const status = gl.isContextLost() ? gl.WAIT_FAILED : gl.clientWaitSync(fence, 0, 0);
        if (status === gl.TIMEOUT_EXPIRED) {
            setTimeout(poll, 1);
            return;
        }
        gl.deleteSync(fence);
        done(status === gl.WAIT_FAILED ? null : performance.now());
    };
    poll();
}

/** So long after the last picture or touch nothing moves any more. */
export const restMs = 150;

/** Surfaces that change as often are played, or dragged by a user. */
const flowMs = 1000;

/** Whether things move in the picture. Times are those of performance.now(). */
export class Movement {
    private held = false;
    private last = Number.NEGATIVE_INFINITY;
    private changed = Number.NEGATIVE_INFINITY;

    /** A hand has taken hold of something in the picture, or let it go. */
    hold(held: boolean): void {
        this.held = held;
    }

    /** Something has been pushed, as the camera by a key or a wheel; more of that is likely to come. */
    stir(now: number): void {
        this.last = Math.max(this.last, now);
    }

    /** A surface is another now; the next picture shows it. */
    surfaceChanged(now: number): void {
        if (now - this.changed < flowMs) this.stir(now);
        this.changed = now;
    }

    /** A picture is on the screen. One alone is no movement; one that follows it closely is. */
    drawn(now: number): void {
        this.stir(now);
    }

    /** Returns whether a picture that begins now is one of a movement. */
    at(now: number): boolean {
        return this.held || now - this.last < restMs;
    }
}

/** Pixels drawn for one of CSS, along one side: below this nothing can be made out any more. */
export const leastRatio = 0.35;

/** A picture takes at most so long; the rest of 1/15 s goes by until the browser asks for the next one. */
export const limitMs = 50;
const shortMs = 0.4 * limitMs;
/** A single late picture says nothing. */
const slowPictures = 3;
const quickPictures = 8;
/** About a minute of them. */
const longestTrial = 1024;
/** Where pictures of the fewest pixels take longer, less is drawn; until they take less than half as long, and that lasts. */
export const sparingMs = 100;

/**
 * How sharp the picture is while things move: as sharp as it can be drawn in the time that 15 pictures a second leave, by what
 * the last ones took. Halves the pixels where they took too long; doubles them only where twice the time is still within the
 * limit, so that it does not go to and fro.
 */
export class MovingResolution {
    private readonly full: number;
    private readonly lastStep: number;
    /** Each halves the pixels. */
    private step: number;
    private took: number[] = [];
    private isSparing = false;
    /** Pictures since that became so, or ended. */
    private since = Number.POSITIVE_INFINITY;
    /** So many before it ends: twice as many each time that all was too much at once. */
    private trial = quickPictures;

    /** @param full ratio of a picture that stands still @param first ratio to begin with, until there are
     *  measurements */
    constructor(full: number, first: number) {
        this.full = full;
        this.lastStep = Math.max(0, Math.floor(2 * Math.log2(full / leastRatio)));
        this.step = Math.min(this.lastStep, Math.max(0, Math.round(2 * Math.log2(full / first))));
    }

    get ratio(): number {
        return this.full * 2 ** (-this.step / 2);
    }

    /** Fewer pixels do not help any more: what is drawn in several passes is drawn in one. */
    get sparing(): boolean {
        return this.isSparing;
    }

    /** A picture of this resolution was on the screen so many milliseconds after it was begun. */
    drawn(ms: number): void {
        this.took.push(ms);
        ++this.since;
        const slow = this.took.length >= slowPictures ? median(this.took.slice(-slowPictures)) : 0;
        if (slow > limitMs && this.step < this.lastStep) this.goTo(this.step + 1);
        else if (slow > sparingMs && !this.isSparing) {
            this.trial = this.since <= quickPictures ? Math.min(2 * this.trial, longestTrial) : quickPictures;
            this.spare(true);
        } else if (this.took.length >= quickPictures) {
            const usual = median(this.took);
            if (this.isSparing && usual < sparingMs / 2 && this.since >= this.trial) this.spare(false);
            else if (!this.isSparing && usual < shortMs) this.goTo(this.step - 1);
            else this.took.shift();
        }
    }

    private spare(on: boolean): void {
        this.isSparing = on;
        this.since = 0;
        this.took = [];
    }

    private goTo(step: number): void {
        this.step = Math.min(this.lastStep, Math.max(0, step));
        this.took = [];
    }
}

function median(values: readonly number[]): number {
    const sorted = [...values].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? 0;
}

/** Works like setTimeout and clearTimeout. */
export interface Timers {
    set(act: () => void, ms: number): unknown;
    clear(timer: unknown): void;
}

const browserTimers: Timers = {
    set: (act, ms) => setTimeout(act, ms),
    clear: (timer) => clearTimeout(timer as ReturnType<typeof setTimeout>),
};

/** Notices, once, when nothing has been drawn for a while and nothing is held: time for a picture that takes longer. */
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
