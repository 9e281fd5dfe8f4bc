// How a surface looks: coloured by a scalar through the colour table, lit on both sides. The side
// turned away from the release direction is darker and less saturated, so that folds stay readable.
import {
    DataTexture,
    DoubleSide,
    LinearFilter,
    RGBAFormat,
    ShaderMaterial,
    SRGBColorSpace,
    UnsignedByteType,
    Vector2,
} from 'three';
import { colorTable, tableSize } from './colorMap.ts';

const vertexShader = `
attribute float scalar;
uniform vec2 range;
varying vec3 viewNormal;
varying vec3 viewPosition;
varying float fraction;

void main() {
    vec4 inView = modelViewMatrix * vec4(position, 1.0);
    viewPosition = inView.xyz;
    viewNormal = normalMatrix * normal;
    fraction = (scalar - range.x) / max(range.y - range.x, 1e-30);
    gl_Position = projectionMatrix * inView;
}`;

const fragmentShader = `
uniform sampler2D colors;
varying vec3 viewNormal;
varying vec3 viewPosition;
varying float fraction;

void main() {
    vec3 toViewer = normalize(-viewPosition);
    vec3 n = normalize(viewNormal);
    n = dot(n, toViewer) < 0.0 ? -n : n;
    float at = (clamp(fraction, 0.0, 1.0) * ${tableSize - 1}.0 + 0.5) / ${tableSize}.0;
    // The texture is declared sRGB: the sampler hands out linear values, ready for lighting.
    vec3 base = texture2D(colors, vec2(at, 0.5)).rgb;
    if (!gl_FrontFacing) {
        float grey = dot(base, vec3(0.2126, 0.7152, 0.0722));
        base = mix(base, vec3(grey), 0.15) * 0.8;
    }
    const vec3 key = vec3(0.286, 0.477, 0.831);
    float diffuse = 0.38 + 0.5 * max(dot(n, key), 0.0) + 0.24 * max(dot(n, toViewer), 0.0);
    vec3 halfway = normalize(key + toViewer);
    float shine = 0.07 * pow(max(dot(n, halfway), 0.0), 40.0);
    gl_FragColor = vec4(base * diffuse + vec3(shine), 1.0);
    #include <colorspace_fragment>
}`;

export function createSurfaceMaterial(): ShaderMaterial {
    return new ShaderMaterial({
        vertexShader,
        fragmentShader,
        uniforms: { range: { value: new Vector2(0, 1) }, colors: { value: colorTexture() } },
        side: DoubleSide,
    });
}

function colorTexture(): DataTexture {
    const texture = new DataTexture(colorTable(), tableSize, 1, RGBAFormat, UnsignedByteType);
    texture.colorSpace = SRGBColorSpace;
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.needsUpdate = true;
    return texture;
}
