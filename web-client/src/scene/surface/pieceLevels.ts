// Which values of s and t have a line, a ribbon or an arrow: the shader (piecesShader.ts) needs the largest
// of them, and how far apart they are.

/** Two neighbours are at least so far apart: the line between them is half-way, and one of them is nearer
 *  than `every` then. */
export function nearestApart(every: number): number {
    return every / Math.SQRT2;
}

/**
 * The largest power of two that a value with a line is a multiple of; as in files (core/surface/even_lines).
 * Where 0 is between both ends it has one itself, and the others begin a power later.
 */
export function coarsestPower(low: number, high: number): number {
    const largest = Math.max(Math.abs(low), Math.abs(high));
    if (!(high > low) || !Number.isFinite(largest)) return 1;
    let power = 2 ** Math.ceil(Math.log2(largest));
    for (let k = 0; k < 54; ++k, power /= 2) {
        const above = power * (Math.floor(low / power) + 1);
        if ((above === 0 ? power : above) < high) return low < 0 && high > 0 ? 2 * power : power;
    }
    return power;
}
