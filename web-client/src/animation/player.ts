// Which step is on the screen and which is wanted: plays, pauses, goes to a step. A step that is far away is reached over several
// frames, so that the page answers meanwhile.

export interface PlayedSteps {
    readonly count: number;
    readonly current: number;
    approach(step: number): boolean;
    awayFrom(step: number): number;
}

export interface PlayerOptions {
    steps: PlayedSteps;
    /** In milliseconds. */
    now: () => number;
    /** A step is there. */
    onStep: (step: number) => void;
    /** So many steps have to be decoded before what is wanted is there. */
    onAway: (steps: number) => void;
    onPlaying: (playing: boolean) => void;
}

/** Of decoding, in a frame. */
const budgetMs = 12;
/** Of the whole, if no step is shown longer or shorter than that. */
const playMs = 12_000;
const [shortestMs, longestMs] = [33, 400];

export class Player {
    speed = 1;
    private readonly options: PlayerOptions;
    private readonly stepMs: number;
    private wanted = 0;
    private shown = -1;
    private shownAt = -Infinity;
    private isPlaying = false;

    constructor(options: PlayerOptions) {
        this.options = options;
        this.stepMs = Math.min(longestMs, Math.max(shortestMs, playMs / options.steps.count));
    }

    get step(): number {
        return this.wanted;
    }

    get playing(): boolean {
        return this.isPlaying;
    }

    /** From the first step on again, if the last one is shown. */
    play(): void {
        if (this.options.steps.count < 2) return;
        if (this.wanted === this.options.steps.count - 1) this.wanted = 0;
        this.setPlaying(true);
    }

    pause(): void {
        this.setPlaying(false);
    }

    /** Pauses as well. */
    goTo(step: number): void {
        this.setPlaying(false);
        this.wanted = Math.max(0, Math.min(this.options.steps.count - 1, Math.round(step)));
    }

    /** Called before every frame, once the last one is on the screen. */
    frame(): void {
        const { steps, now, onStep, onAway } = this.options;
        const begun = now();
        if (this.isPlaying && this.shown === this.wanted && begun - this.shownAt >= this.stepMs / this.speed) {
            if (this.wanted + 1 < steps.count) ++this.wanted;
            else this.setPlaying(false);
        }
        if (this.shown === this.wanted) return;
        let there = steps.approach(this.wanted);
        while (!there && now() - begun < budgetMs) there = steps.approach(this.wanted);
        onAway(there ? 0 : steps.awayFrom(this.wanted));
        if (!there) return;
        this.shown = this.wanted;
        this.shownAt = begun;
        onStep(this.shown);
    }

    private setPlaying(playing: boolean): void {
        if (playing === this.isPlaying) return;
        this.isPlaying = playing;
        this.options.onPlaying(playing);
    }
}
