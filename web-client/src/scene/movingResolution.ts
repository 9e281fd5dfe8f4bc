// Decides how sharp the picture is while things move: as sharp as it can be drawn in the time that 15
// pictures a second leave, by what the last ones took. Halves the pixels where they took too long. Doubles
// them only where they took so little that twice the time is still within the limit, so that it does not go
// to and fro.

/** Pixels drawn for one of CSS, along one side: below this nothing can be made out any more. */
export const leastRatio = 0.35;

/** A picture takes at most so long; the rest of 1/15 s goes by until the browser asks for the next one. */
export const limitMs = 50;
const shortMs = 0.4 * limitMs;
/** A single late picture says nothing. */
const slowPictures = 3;
const quickPictures = 8;

export class MovingResolution {
    private readonly full: number;
    private readonly lastStep: number;
    /** Each halves the pixels. */
    private step: number;
    private took: number[] = [];

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

    /** A picture of this resolution was on the screen so many milliseconds after it was begun. */
    drawn(ms: number): void {
        this.took.push(ms);
        if (this.took.length >= slowPictures && median(this.took.slice(-slowPictures)) > limitMs) this.goTo(this.step + 1);
        else if (this.took.length >= quickPictures) {
            if (median(this.took) < shortMs) this.goTo(this.step - 1);
            else this.took.shift();
        }
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
