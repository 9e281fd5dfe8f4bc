// What a picture begins with: whether this browser can draw, the light and the colours of the ground.
import { Color, DirectionalLight, Group, HemisphereLight, WebGLRenderer } from 'three';
import type { Layer, View } from './base/view.ts';

export interface Graphics {
    software: boolean;
}

/** Null without WebGL2. Software rendering is slow enough to deserve fewer pixels and samples. */
export function probeGraphics(): Graphics | null {
    const gl = document.createElement('canvas').getContext('webgl2');
    if (gl === null) return null;
    const extension = gl.getExtension('WEBGL_debug_renderer_info');
    const renderer: unknown = gl.getParameter(extension === null ? gl.RENDERER : extension.UNMASKED_RENDERER_WEBGL);
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    return { software: /swiftshader|llvmpipe|software/i.test(String(renderer)) };
}

export function createRenderer(canvas: HTMLCanvasElement, graphics: Graphics): WebGLRenderer {
    return new WebGLRenderer({ canvas, antialias: !graphics.software, powerPreference: 'high-performance' });
}

/** The light on bodies: from over the viewer's shoulder, like the light of the surfaces, and a little from the sky. */
export class Lights implements Layer {
    readonly object = new Group();
    private readonly key = new DirectionalLight(0xffffff, 3);

    constructor() {
        const sky = new HemisphereLight(0xdfe8ff, 0x5a6474, 1.1);
        sky.position.set(0, 0, 1);
        this.object.add(this.key, this.key.target, sky);
        // Pictures of some layers have all light as well: programs depend on how much there is.
        for (const light of [this.key, sky]) light.layers.enableAll();
    }

    update({ camera }: View): void {
        this.key.position.set(0.4, 0.6, 1).applyQuaternion(camera.quaternion);
    }
}

export interface PictureColours {
    background: Color;
    outline: Color;
}

/** The picture's own colours in dark and in light surroundings. */
export const pictureColours: Record<'dark' | 'light', PictureColours> = {
    dark: { background: new Color(0x0b1018), outline: new Color(0x6b7a90) },
    light: { background: new Color(0xf2f5f9), outline: new Color(0x7d8aa0) },
};
