// Says what counts as the end of a range of coordinates or times: core/base/rounding.hpp says why, and is the
// same for the server.

/** Returns how far beyond an end of a range a number still means that end. */
export function rounding(low: number, high: number): number {
    const roundings = 2 ** -22 * Math.max(Math.abs(low), Math.abs(high));
    return high > low ? Math.min(roundings, 1e-5 * (high - low)) : roundings;
}
