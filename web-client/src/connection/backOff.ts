// Says how long to wait before the next attempt to connect: doubling from 250 ms to 5 s, each wait drawn
// from its upper half so that many clients of one restarted server do not return in step.

export const firstWaitMs = 250;
export const longestWaitMs = 5000;

export class BackOff {
    private failures = 0;
    private readonly random: () => number;

    constructor(random: () => number) {
        this.random = random;
    }

    nextWaitMs(): number {
        const ceiling = Math.min(longestWaitMs, firstWaitMs * 2 ** this.failures);
        ++this.failures;
        return ceiling * (0.5 + 0.5 * this.random());
    }

    reset(): void {
        this.failures = 0;
    }
}
