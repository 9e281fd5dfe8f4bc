// Stripes, lines and pieces of a surface by its own coordinates s and t. The spacing of stripes follows the screen: of the powers of two
// they take the two next to the wanted spacing and fade from one to the other (adaptive stripes, Hummel et al., IRIS, 2010). Pieces (lines,
// ribbons and arrows instead of all of the surface) have even distances in units of length (McLoughlin, Laramee, Zhang, Easy Integral
// Surfaces, 2009), at the same values as lines in files of them (core/surface/even_lines): multiples of the smallest power of two that lie
// far enough apart there.

/** Width of a pair of stripes in pixels, at usual density; up to twice as much. */
export const stripePeriodPx = 22;

export const patternGlsl = `
uniform int lines;
uniform float lineDensity;
// Where t is 0 for the pattern, and +1 or -1: the way it flows.
uniform vec2 patternT;

/** Frequency (a power of two) and how far it is on the way to the next one, for a change of c by \`rate\` a
 *  pixel. */
vec2 levelOf(float rate, float periodPx) {
    float wanted = -log2(max(rate, 1e-30) * periodPx * pixelRatio);
    float level = floor(wanted);
    return vec2(exp2(level), smoothstep(0.25, 0.75, wanted - level));
}

/** Light and dark halves of every unit, their borders as wide as a pixel. */
float halves(float x, float rate) {
    return clamp(0.5 + (0.25 - abs(fract(x) - 0.5)) / max(rate, 1e-6), 0.0, 1.0);
}

/** Returns how much of a pixel lies to one side of an edge that is so many pixels away from its middle. */
float beyond(float distance) {
    return clamp(distance + 0.5, 0.0, 1.0);
}

float thinLine(float x, float rate) {
    float away = abs(fract(x - 0.5) - 0.5) / max(rate, 1e-6);
    return beyond(1.1 * pixelRatio - away) - beyond(-1.1 * pixelRatio - away);
}

float stripesAt(float c, float rate) {
    vec2 level = levelOf(rate, ${stripePeriodPx}.0 / lineDensity);
    float f = level.x;
    return mix(halves(c * f, rate * f), halves(c * 2.0 * f, rate * 2.0 * f), level.y);
}

float linesAt(float c, float rate) {
    vec2 level = levelOf(rate, ${stripePeriodPx}.0 / lineDensity);
    float f = level.x;
    return max(thinLine(c * f, rate * f), level.y * thinLine(c * 2.0 * f, rate * 2.0 * f));
}

/** Returns what is left of the colour. */
float pattern(vec2 place, mat2 slope) {
    if (lines == 0) return 1.0;
    vec2 c = vec2(place.x, (place.y - patternT.x) * patternT.y);
    vec2 rate = vec2(
        length(vec2(slope[0].x, slope[1].x)),
        length(vec2(slope[0].y, slope[1].y)) * abs(patternT.y)
    );
    float left = 1.0;
    if (lines == 1) left = mix(0.5, 1.0, stripesAt(c.y, rate.y));
    else if (lines == 2) left = mix(0.5, 1.0, stripesAt(c.x, rate.x));
    else if (lines == 3) left = 1.0 - 0.75 * max(linesAt(c.x, rate.x), linesAt(c.y, rate.y));
    else if (lines == 4) {
        float odd = (2.0 * stripesAt(c.x, rate.x) - 1.0) * (2.0 * stripesAt(c.y, rate.y) - 1.0);
        left = mix(0.45, 1.0, 0.5 + 0.5 * odd);
    }
    return left;
}`;

export const piecesGlsl = `
uniform int pieces;
// Lengths: neighbours are at least so far apart; of ribbons and of arrows' heads.
uniform float pieceNear;
uniform float pieceWidth;
// Of s and of t: the least, the greatest, the largest power of two that a line is at a multiple of, and what
// c is counted from.
uniform vec4 pieceS;
uniform vec4 pieceT;
uniform bool rakeCloses;

/** Returns, for all values that may have a line, how far those apart are that have one where a unit is so
 *  long. */
float apartFor(float unit, vec4 levels) {
    return min(exp2(ceil(log2(pieceNear / max(unit, 1e-20)))), levels.z);
}

/** A value's nearest multiple. Beside the last column of a closed rake lies its first. */
float nearestValue(float c, float apart, vec4 levels) {
    return round((c + levels.w) / apart) * apart - levels.w;
}

bool isInside(float value, float unit, vec4 levels, bool wraps) {
    bool between = value > levels.x && value < levels.y;
    // The line at the seam is the last to be left out: a whole unit lies between it and itself.
    return wraps ? fract(value) != 0.0 || unit >= 2.0 * pieceNear : between;
}

/** Returns for one parameter whether this is on a line, or on a ribbon. */
bool isOnLine(float c, float rate, float unit, vec4 levels, bool wraps, bool ribbon) {
    float value = nearestValue(c, apartFor(unit, levels), levels);
    if (!isInside(value, unit, levels, wraps)) return false;
    float away = abs(c - value);
    return ribbon ? away * unit < 0.5 * pieceWidth : away < 1.1 * pixelRatio * rate;
}

/** In widths: a shaft two long and a third wide, behind a head one long and one wide. */
bool isInArrow(float across, float along) {
    float half_ = along < 2.0 ? 1.0 / 6.0 : 0.5 * (3.0 - along);
    return along >= 0.0 && along < 3.0 && abs(across) < half_;
}

bool isOnArrow(vec2 c, mat2 slope, vec2 unit, mat2 unitSlope, mat2x3 way, vec3 velocity) {
    vec3 through = cross(way[0], way[1]);
    float area = dot(through, through);
    vec3 along = velocity - through * (dot(velocity, through) / max(area, 1e-30));
    float speed = length(along);
    if (!(speed > 0.0) || determinant(slope) == 0.0) return false;
    along /= speed;
    vec3 across = cross(through * inversesqrt(area), along);
    mat2 pixelsFor = inverse(slope);
    vec2 apart = vec2(apartFor(unit.x, pieceS), apartFor(unit.y, pieceT));
    for (int k = 0; k < 9; ++k) {
        vec2 step = min(apart * exp2(vec2(k % 3 - 1, k / 3 - 1)), vec2(pieceS.z, pieceT.z));
        vec2 anchor = vec2(nearestValue(c.x, step.x, pieceS), nearestValue(c.y, step.y, pieceT));
        vec2 pixels = pixelsFor * (anchor - c);
        // Whether it is there depends on how long units are in its middle: else a part of it would be.
        vec2 there = unit + unitSlope * pixels;
        bvec2 far = lessThan(step * there, vec2(pieceNear));
        if ((far.x && step.x < pieceS.z) || (far.y && step.y < pieceT.z)) continue;
        if (!isInside(anchor.x, there.x, pieceS, rakeCloses) || !isInside(anchor.y, there.y, pieceT, false)) continue;
        vec3 away = -(way * pixels) / pieceWidth;
        if (isInArrow(dot(away, across), dot(away, along) + 1.5)) return true;
    }
    return false;
}

/** @param c s and t; \`slope\` and \`unitSlope\` how c and the lengths of their units change over a pixel,
 *  \`way\` how the place does */
bool isBetweenPieces(vec2 c, mat2 slope, vec2 unit, mat2 unitSlope, mat2x3 way, vec3 velocity) {
    if (pieces == 0) return false;
    if (pieces == 5) return !isOnArrow(c, slope, unit, unitSlope, way, velocity);
    bool ofSeed = pieces == 2 || pieces == 4;
    bool ribbon = pieces > 2;
    vec2 rate = vec2(length(vec2(slope[0].x, slope[1].x)), length(vec2(slope[0].y, slope[1].y)));
    return ofSeed
        ? !isOnLine(c.x, rate.x, unit.x, pieceS, rakeCloses, ribbon)
        : !isOnLine(c.y, rate.y, unit.y, pieceT, false, ribbon);
}`;

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
