// Draws when something changed and not otherwise: one animation frame for any number of requests.

export class FrameLoop {
    private readonly draw: (time: number) => void;
    private readonly before: (() => void)[] = [];
    private requested = false;

    constructor(draw: (time: number) => void) {
        this.draw = draw;
    }

    /** Runs an action at the start of every frame. */
    beforeFrame(action: () => void): void {
        this.before.push(action);
    }

    readonly request = (): void => {
        if (this.requested) return;
        this.requested = true;
        requestAnimationFrame((time) => {
            this.requested = false;
            for (const action of this.before) action();
            this.draw(time);
        });
    };
}
