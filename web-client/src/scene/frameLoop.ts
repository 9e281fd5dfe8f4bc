// Draws when something changed and not otherwise: one animation frame for any number of requests, and
// the next one only when the GPU has finished the last. A queue of frames would be a queue of delays.

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
