// Stripes and lines in the surface's own coordinates s and t. Their spacing follows the screen: of the powers
// of two it takes the two next to the wanted spacing and fades from one to the other (adaptive stripes,
// Hummel et al., IRIS, 2010).

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
