// Tells whether things move in the picture. What is drawn while they do is drawn again soon, and should
// rather be quick than sharp; what stands still is worth the time.

/** So long after the last picture or touch nothing moves any more. */
export const restMs = 150;

/** Surfaces that change as often are played, or dragged by a user. */
const flowMs = 1000;

/** Times are those of performance.now(). */
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
