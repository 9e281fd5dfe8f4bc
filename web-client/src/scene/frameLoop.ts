// Draws when something changed and not otherwise: one animation frame for any number of requests, and
// the next one only when the GPU has finished the last. A queue of frames would be a queue of delays.

/** Draws, and calls `finished` when the picture is done or will not come. */
export type Draw = (finished: () => void) => void;

export class FrameLoop {
    private readonly draw: Draw;
    private readonly schedule: (callback: () => void) => void;
    private readonly before: (() => void)[] = [];
    private requested = false;
    private drawing = false;

    constructor(draw: Draw, schedule: (callback: () => void) => void = (callback) => requestAnimationFrame(callback)) {
        this.draw = draw;
        this.schedule = schedule;
    }

    /** Runs an action at the start of every frame. */
    beforeFrame(action: () => void): void {
        this.before.push(action);
    }

    readonly request = (): void => {
        if (this.requested) return;
        this.requested = true;
        if (!this.drawing) this.schedule(this.frame);
    };

    private readonly frame = (): void => {
        this.requested = false;
        this.drawing = true;
        for (const action of this.before) action();
        this.draw(() => {
            this.drawing = false;
            if (this.requested) this.schedule(this.frame);
        });
    };
}
