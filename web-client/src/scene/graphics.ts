// Tells whether and how well this browser can draw.

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
