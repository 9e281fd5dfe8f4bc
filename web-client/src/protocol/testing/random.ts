// Chance that is the same on every run.

/** Numbers in 0 .. 2^32 - 1 (xorshift32). */
export function seededRandom(seed: number): () => number {
    let state = seed;
    return () => {
        state ^= state << 13;
        state ^= state >>> 17;
        state ^= state << 5;
        return state >>> 0;
    };
}
