// Draws what is there for its depth alone; colours are of no interest.
import type { Camera, Scene, WebGLRenderer } from 'three';

/** Into the target that is set. @param layer of what; without it, of everything */
export function drawDepth(renderer: WebGLRenderer, scene: Scene, camera: Camera, layer = 0): void {
    const prepare = scene.onBeforeRender;
    scene.onBeforeRender = () => undefined;
    const { color } = renderer.state.buffers;
    color.setMask(false);
    color.setLocked(true);
    camera.layers.set(layer);
    renderer.render(scene, camera);
    camera.layers.set(0);
    color.setLocked(false);
    color.setMask(true);
    scene.onBeforeRender = prepare;
}
