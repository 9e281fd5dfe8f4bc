// The shader of the surfaces, one text for five programs: the first draws; PLAIN does so without planes,
// windows, painting, stripes and outlines, which most surfaces have none of, at half the cost; BLENDED adds
// to the weighted targets of transparency.ts; PEELED draws one of its layers; the pick
// writes what is where (surfacePick.ts). Looks differ in uniforms, and the flow texture in programs with it
// (TEXTURED) in which it stands or moves (FLOWING): a software renderer computes what no pixel takes.
import { cutLevel } from '../../mesh/meshChange.ts';
import { flowTextureGlsl, flowVertexGlsl } from './flowTexture.ts';
import { patternGlsl, piecesGlsl } from './patternShader.ts';
import { screenDoorGlsl } from './renderPasses.ts';
import { endSlack } from './splatEnds.ts';
import { tableSize } from './colourMap.ts';

/** Across x, y and z, and a slice. */
export const mostClipPlanes = 4;

export const vertexShader = `
attribute vec2 seed;
#ifdef SPLATS
// Of a disc: its half axes, a corner of the square round it, and where it ends (splatEnds.ts).
attribute vec3 axisU;
attribute vec3 axisV;
attribute vec2 corner;
attribute vec4 endsThrough;
attribute vec4 endBeside;
out vec2 onDisc;
flat out vec4 through;
flat out vec4 beside;
#endif
attribute float scalar;
attribute float stretch;
#ifndef SPLATS
attribute float cut;
attribute float interval;
#endif
// What a fixed grid cannot resolve: what shape takes away of smoke, and how far sides leave the plane of the
// vertex.
attribute vec2 unresolved;
attribute float flowX;
attribute float flowY;
attribute float flowZ;
attribute vec2 unit;
uniform int source;
uniform vec2 ageOf;
uniform bool fixedGrid;
out vec3 viewNormal;
out vec3 viewPosition;
out vec3 worldPosition;
out vec2 place;
// What colours, age, stretching, whether it is cut.
out vec4 values;
out vec3 flow;
// How long units of s and t are on the surface.
out vec2 unitLength;
out vec2 hidden;
// How far interpolating between stored times puts it off.
out float off;
// s once more, with its jump on the other side of a closed rake.
out float turned;
#ifdef TEXTURED
${flowVertexGlsl}
#endif
// What is drawn in several programs has to be at the same depth in all.
invariant gl_Position;

void main() {
#ifdef SPLATS
    vec3 at = position + corner.x * axisU + corner.y * axisV;
    onDisc = corner;
    through = endsThrough;
    beside = endBeside;
#else
    vec3 at = position;
#endif
    vec4 inWorld = modelMatrix * vec4(at, 1.0);
    vec4 inView = viewMatrix * inWorld;
    worldPosition = inWorld.xyz;
    viewPosition = inView.xyz;
    viewNormal = normalMatrix * normal;
    place = seed;
    float age = ageOf.x + ageOf.y * seed.y;
    float value = source == 1 ? scalar : source == 2 ? seed.x : age;
#ifdef SPLATS
    values = vec4(value, age, stretch, 0.0);
    off = 0.0; // sixteen attributes are all that there may be
#else
    values = vec4(value, age, stretch, cut);
    off = interval;
#endif
    flow = vec3(flowX, flowY, flowZ);
    unitLength = unit;
    hidden = fixedGrid ? unresolved : vec2(0.0);
    turned = fract(seed.x + 0.5) + 0.5;
#ifdef TEXTURED
    placeInFlow(worldPosition, normal, vec3(flowX, flowY, flowZ));
#endif
    gl_Position = projectionMatrix * inView;
}`;

const declarations = `
in vec3 viewNormal;
in vec3 viewPosition;
in vec3 worldPosition;
in vec2 place;
in vec4 values;
in vec3 flow;
in vec2 unitLength;
#ifdef SPLATS
in vec2 onDisc;
flat in vec4 through;
flat in vec4 beside;
#endif
in vec2 hidden;
in float off;
in float turned;
uniform int source;
// Of the picture for one of CSS: spacing and widths are meant in these.
uniform float pixelRatio;
uniform vec4 window;
uniform vec4 clip[${mostClipPlanes}];
uniform bool painting;
uniform float faded;
uniform vec2 maskT;
uniform sampler2D mask;
uniform float opacity;

bool isLeftOut() {
#ifdef SPLATS
    if (dot(onDisc, onDisc) > 1.0) return true;
    vec2 inside = vec2(dot(onDisc, through.xy), dot(onDisc, through.zw));
    float least = beside.w > 0.5 ? max(inside.x, inside.y) : min(inside.x, inside.y);
    return min(least, dot(onDisc, beside.xy) + beside.z) < -${endSlack};
#else
    return values.w > ${cutLevel}.5;
#endif
}

${piecesGlsl}

/** s and t, and how they change over a pixel, also where the s of a closed rake begins again. */
vec2 seamless(out mat2 slope) {
    slope = mat2(dFdx(place), dFdy(place));
    vec2 other = vec2(dFdx(turned), dFdy(turned));
    if (!rakeCloses || abs(other.x) + abs(other.y) >= abs(slope[0].x) + abs(slope[1].x)) return place;
    slope[0].x = other.x;
    slope[1].x = other.y;
    return vec2(turned, place.y);
}

/** It lies between the pieces that are shown, if not all of it is. */
bool isBetween(vec2 seeds, mat2 slope) {
    mat2 unitSlope = mat2(dFdx(unitLength), dFdy(unitLength));
    return isBetweenPieces(seeds, slope, unitLength, unitSlope, mat2x3(dFdx(worldPosition), dFdy(worldPosition)), flow);
}

bool isCut() {
    bvec2 early = lessThan(vec2(place.x, values.y), window.xz);
    bvec2 late = greaterThan(vec2(place.x, values.y), window.yw);
    bool cut = isLeftOut() || any(early) || any(late);
    for (int i = 0; i < ${mostClipPlanes}; ++i) cut = cut || dot(clip[i].xyz, worldPosition) > clip[i].w;
    return cut;
}

/** Returns what the painter has left of the opacity. */
float revealed() {
    if (!painting) return 1.0;
    float at = (place.y - maskT.x) * maskT.y;
    return mix(faded, 1.0, step(0.5, texture(mask, vec2(place.x, at)).r));
}`;

const shading = `
uniform sampler2D colours;
uniform vec3 constant;
uniform vec2 range;
uniform bool inverted;
uniform bool logarithmic;
uniform bool root;
uniform float bands;
uniform int backSide;
uniform bool silhouettes;
uniform float hatchAbove;
uniform bool angleOpacity;
uniform float smoke;
uniform bool stretchKnown;
uniform float areaPerSeed;
uniform float ageSpan;

vec3 baseColour() {
    if (source == 0) return constant;
    // No number, or none that has a logarithm. That of zero lies below every range.
    if (isnan(values.x) || isinf(values.x) || (logarithmic && values.x < 0.0)) return vec3(0.2);
    float value = logarithmic ? (values.x > 0.0 ? log(values.x) : range.x) : values.x;
    if (root) value = sign(value) * sqrt(abs(value));
    float fraction = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
    if (bands > 1.0) fraction = min(floor(fraction * bands), bands - 1.0) / (bands - 1.0);
    if (inverted) fraction = 1.0 - fraction;
    float at = (fraction * ${tableSize - 1}.0 + 0.5) / ${tableSize}.0;
    // The texture is declared sRGB: the sampler hands out linear values, ready for lighting.
    return texture(colours, vec2(at, 0.5)).rgb;
}

vec3 backColour(vec3 base) {
    float grey = dot(base, vec3(0.2126, 0.7152, 0.0722));
    if (backSide == 1) return mix(base, vec3(grey), 0.15) * 0.8;
    if (backSide == 2) return mix(vec3(grey), vec3(0.93, 0.36, 0.12), 0.72) * (0.45 + 0.75 * grey);
    return base;
}

/** Oblique lines where it may be off by more than that, or by no one knows how much. */
vec3 hatched(vec3 base) {
    if (hatchAbove >= 1e30 || off <= hatchAbove) return base;
    float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) / (7.0 * max(pixelRatio, 0.7)));
    return base * (stripe < 0.3 ? 0.3 : 1.0);
}

/** Light from over the viewer's shoulder, on both sides. */
vec3 lit(vec3 base, vec3 n, vec3 toViewer) {
    const vec3 key = vec3(0.286, 0.477, 0.831);
    float diffuse = 0.38 + 0.5 * max(dot(n, key), 0.0) + 0.24 * max(dot(n, toViewer), 0.0);
    float shine = 0.07 * pow(max(dot(n, normalize(key + toViewer)), 0.0), 40.0);
    return base * diffuse + vec3(shine);
}

/**
 * Returns what is left of the smoke where the surface has been stretched, and with time; and of that which a
 * fixed grid can resolve (after von Funck et al. 2008: the product of density, shape, curvature and fading).
 */
float density(float seedsPerPixel, float areaPerPixel) {
    float known = exp2(-values.z);
    float guessed = seedsPerPixel * areaPerSeed / max(areaPerPixel, 1e-30);
    float thinned = clamp(stretchKnown ? known : guessed, 0.02, 1.5);
    vec2 resolved = clamp(1.0 - hidden, 0.0, 1.0);
    return thinned * resolved.x * resolved.y * clamp(1.0 - values.y / ageSpan, 0.0, 1.0);
}

float opacityAt(float facing, float seedsPerPixel, float areaPerPixel) {
    // As of a thin layer: what passes falls with the way through it.
    float thickness = -log(1.0 - min(opacity, 0.995));
    if (angleOpacity) thickness /= max(facing, 0.06);
    if (smoke > 0.0) thickness *= mix(1.0, density(seedsPerPixel, areaPerPixel), smoke);
    return (1.0 - exp(-thickness)) * revealed();
}`;

const main = `
uniform bool doors;
${screenDoorGlsl}
void main() {
    vec3 toViewer = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-viewPosition);
    vec3 n = normalize(viewNormal);
    n = dot(n, toViewer) < 0.0 ? -n : n;
    float facing = dot(n, toViewer);
#ifndef PLAIN
    // Differences between pixels come before anything is thrown away.
    mat2 slope;
    vec2 seeds = seamless(slope);
    bool between = isBetween(seeds, slope);
    float facingSlope = fwidth(facing);
    vec3 flatNormal = cross(dFdx(viewPosition), dFdy(viewPosition));
    float areaPerPixel = length(flatNormal);
    float flatFacing = abs(dot(flatNormal, toViewer)) / max(areaPerPixel, 1e-30);
    if (between || isCut()) discard;
#else
    if (isLeftOut()) discard;
#endif
#ifdef TRANSPARENT
    if (isPeeledOff()) discard;
#endif
    vec3 base = hatched(baseColour());
    if (!gl_FrontFacing) base = backColour(base);
#ifdef TEXTURED
    base *= flowTexture(facing);
#endif
#ifdef PLAIN
    drawn = linearToOutputTexel(vec4(lit(base, n, toViewer), 1.0));
#else
    base *= pattern(seeds, slope);
    vec3 colour = lit(base, n, toViewer);
    float outlined = 0.0;
    if (silhouettes) {
        outlined = 1.0 - smoothstep(1.0, 2.4, facing / max(facingSlope * max(pixelRatio, 0.7), 0.004));
        // Where the surface itself faces the eye, only its normals turn: at a crease, which is no outline.
        outlined *= 1.0 - smoothstep(0.45, 0.65, flatFacing);
    }
    colour *= 1.0 - 0.9 * outlined;
#ifdef TRANSPARENT
    float alpha = max(opacityAt(facing, abs(determinant(slope)), areaPerPixel), outlined * revealed());
    if (alpha < 0.002) discard;
#ifdef PEELED
    layer = vec4(sRGBTransferOETF(vec4(clamp(colour, 0.0, 1.0), 1.0)).rgb * alpha, alpha);
#else
    float depth = clamp((-viewPosition.z - depthRange.x) / (depthRange.y - depthRange.x), 0.0, 1.0);
    float weight = 0.02 + 60.0 * pow(1.0 - depth, 5.0);
    sum = vec4(colour * alpha * weight, alpha);
    weights = vec4(alpha * weight, 0.0, 0.0, 1.0);
#endif
#else
    if (doors ? !isThere(opacityAt(facing, abs(determinant(slope)), areaPerPixel), gl_FrontFacing ? ivec2(0) : ivec2(2, 1)) : revealed() < 0.5) discard;
    drawn = linearToOutputTexel(vec4(colour, 1.0));
#endif
#endif
}`;

const pickMain = `
uniform float pickId;
layout(location = 0) out vec4 point;
layout(location = 1) out vec4 numbers;

void main() {
    mat2 slope;
    vec2 seeds = seamless(slope);
    if (isBetween(seeds, slope) || isCut() || (respectPaint && revealed() < 0.02)) discard;
    point = vec4(worldPosition, pickId);
    numbers = vec4(place, values.x, -viewPosition.z);
}`;

const outputs = `
#ifdef BLENDED
#define TRANSPARENT
uniform vec2 depthRange;
layout(location = 0) out vec4 sum;
layout(location = 1) out vec4 weights;
#elif defined(PEELED)
#define TRANSPARENT
uniform sampler2D opaqueDepth;
layout(location = 0) out vec4 layer;
#else
layout(location = 0) out vec4 drawn;
#endif
#ifdef TRANSPARENT
uniform bool peeling;
uniform sampler2D nearer;

/** Returns whether it belongs to a layer that has been drawn, or is behind something opaque (for BLENDED the
 *  test of depth knows). */
bool isPeeledOff() {
    ivec2 at = ivec2(gl_FragCoord.xy);
#ifdef PEELED
    if (gl_FragCoord.z > texelFetch(opaqueDepth, at, 0).r) return true;
#endif
    return peeling && gl_FragCoord.z <= texelFetch(nearer, at, 0).r;
}
#endif
`;

export const fragmentShader = [
    declarations,
    shading,
    patternGlsl,
    '#ifdef TEXTURED',
    flowTextureGlsl,
    '#endif',
    outputs,
    main,
].join('\n');
export const pickFragmentShader = `${declarations}\nuniform bool respectPaint;\n${pickMain}`;
