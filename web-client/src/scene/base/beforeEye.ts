// What shaders of lines share.
/** Cuts a line where it passes the eye: what is behind it has no place on the screen. */
export const beforeEyeShader = /* glsl */ `
uniform bool parallelRays;
uniform float nearest;

void keepBeforeEye(inout vec4 a, inout vec4 b) {
    if (parallelRays) return;
    if (a.z > -nearest && b.z < -nearest) a = mix(a, b, (-nearest - a.z) / (b.z - a.z));
    if (b.z > -nearest && a.z < -nearest) b = mix(b, a, (-nearest - b.z) / (a.z - b.z));
}
`;
