// Flow texture: noise in space, smeared along the part of the velocity that is tangential to the surface (line integral convolution,
// Cabral and Leedom 1993, over so short a way that it is straight), as Laramee et al. 2004 and 2006 advect it in the picture. In
// space, so that it stays on the surface while the view turns, and is the same in every tile of a figure.
import { noiseSize } from './flowNoise.ts';

/** Along the flow; more make longer streaks, and each is a look-up. */
export const grainsAlong = 8;
/**
 * How often its own length a wave wanders before the next takes over. Together they go a whole number of lengths, so at most a sixteenth of
 * the speed is missing; over a longer way differences in speed would take a wave apart.
 */
const lengths = 8;
/** Pixels of a grain across the flow, at usual density; up to twice as much. */
const grainPx = 3;

const turns = Array.from({ length: grainsAlong }, (_, k) => {
    const angle = (2 * Math.PI * k) / grainsAlong;
    return `vec2(${Math.cos(angle).toFixed(6)}, ${Math.sin(angle).toFixed(6)})`;
});

export const flowTextureGlsl = `
uniform sampler2D noise;
// Whether it flows, for how much simulation time it has, and what is to be added where a field stands still.
uniform bool flowing;
uniform float flowTime;
uniform bool byItself;
uniform float flowed;
// That of most of the flow.
uniform float flowSpeed;

const vec2 turns[${grainsAlong}] = vec2[](${turns.join(', ')});
// No plane of a grid lies along an axis of the noise.
const mat3 aslant = mat3(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6);

/**
 * The weights along the way are a wave, which wanders with the flow (Cabral and Leedom's animation). Two of them take turns, each fading out
 * before differences in speed have taken it apart.
 */
vec2 waveAt(float speed, float along) {
    // At rest its crest is in the middle.
    if (!flowing) return vec2(-1.0, 0.0);
    float turn = ${lengths}.0 * along / flowSpeed;
    vec2 passed = fract((byItself ? flowed : flowTime) / turn + vec2(0.0, 0.5));
    float first = 1.0 - abs(2.0 * passed.x - 1.0);
    vec2 angle = 6.2831853 * passed * turn * speed / along;
    return first * vec2(cos(angle.x), sin(angle.x)) + (1.0 - first) * vec2(cos(angle.y), sin(angle.y));
}

/** @param at, way  in the plane of the noise. @param density  grains in a unit of length */
float smearedNoise(vec2 at, vec2 way, float speed, float density) {
    vec2 wave = waveAt(speed, ${grainsAlong}.0 / density);
    vec2 grain = way / ${noiseSize}.0;
    vec2 from = at * density / ${noiseSize}.0 - ${(grainsAlong - 1) / 2} * grain;
    // What would not move with the wave.
    float rest = flowing ? 0.0 : 1.0;
    float sum = 0.0;
    for (int k = 0; k < ${grainsAlong}; ++k) {
        float weight = rest + wave.x * turns[k].x - wave.y * turns[k].y;
        sum += weight * (textureLod(noise, from + float(k) * grain, 0.0).r - 0.5);
    }
    // The mean of so much noise hardly leaves the middle.
    return clamp(0.5 + (4.5 - 1.5 * rest) * sum / ${grainsAlong}.0, 0.0, 1.0);
}

/** Which of the three planes of the axes a surface lies in most: noise of one plane takes half as long to look up as that of a cube. */
vec2 inPlane(vec3 of, vec3 normalHere) {
    vec3 facing = abs(aslant * normalHere);
    vec3 turned = aslant * of;
    return facing.x > max(facing.y, facing.z) ? turned.yz : facing.y > facing.z ? turned.zx : turned.xy;
}

/** What is left of the colour, on a surface with this normal, where a pixel is so wide. */
float flowTexture(vec3 at, vec3 normalHere, vec3 velocity, float pixelWidth) {
    vec3 tangential = velocity - dot(velocity, normalHere) * normalHere;
    float speed = length(tangential);
    float whole = length(velocity);
    // Where the flow goes through the surface rather than along it there is no direction to show (Laramee et al. 2004).
    float shown = whole > 0.0 ? smoothstep(0.1, 0.3, speed / whole) : 0.0;
    if (shown <= 0.0) return 1.0;
    vec2 way = inPlane(tangential / speed, normalHere);
    vec2 place = inPlane(at, normalHere);
    vec2 level = levelOf(pixelWidth, ${grainPx}.0 / lineDensity);
    // Two sizes of grain are looked up in a narrow band only.
    level.y = smoothstep(0.3, 0.7, level.y);
    float grain = level.y < 1.0 ? smearedNoise(place, way, speed, level.x) : 0.0;
    if (level.y > 0.0) grain = mix(grain, smearedNoise(place, way, speed, 2.0 * level.x), level.y);
    return mix(1.0, mix(0.35, 1.25, grain), shown);
}`;
