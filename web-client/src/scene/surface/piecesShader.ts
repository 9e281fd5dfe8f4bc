// Pieces of a surface instead of all of it: lines, ribbons and arrows, at even distances in units of length
// (McLoughlin, Laramee, Zhang, Easy Integral Surfaces, 2009). The same values have lines as in files of them
// (core/surface/even_lines): multiples of the smallest power of two that lie far enough apart there.

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
