// The mathematics of dragging a handle: it moves in the plane through its start that faces the
// camera, so that it stays exactly under the pointer whatever the camera's distance.
import { type Camera, Vector3 } from 'three';
import type { Vec3 } from '../protocol/messages.ts';

/** A place on the canvas in CSS pixels from its top left corner. */
export interface ScreenPoint {
    x: number;
    y: number;
}

export interface ScreenSize {
    width: number;
    height: number;
}

/** Canvas position of a point in world coordinates; null behind the camera. */
export function projectToScreen(point: Vec3, camera: Camera, size: ScreenSize): ScreenPoint | null {
    const view = new Vector3(...point).applyMatrix4(camera.matrixWorldInverse);
    if (view.z >= 0) return null;
    const clip = view.applyMatrix4(camera.projectionMatrix);
    return { x: (clip.x * 0.5 + 0.5) * size.width, y: (0.5 - clip.y * 0.5) * size.height };
}

/** Where the ray through a canvas position meets the camera-facing plane through `anchor`. */
export function dragInViewPlane(
    pointer: ScreenPoint,
    anchor: Vec3,
    camera: Camera,
    size: ScreenSize,
): Vec3 {
    const depth = new Vector3(...anchor).applyMatrix4(camera.matrixWorldInverse).z;
    const ray = new Vector3(
        (pointer.x / size.width) * 2 - 1,
        1 - (pointer.y / size.height) * 2,
        0.5,
    ).applyMatrix4(camera.projectionMatrixInverse);
    const hit = ray.multiplyScalar(depth / ray.z).applyMatrix4(camera.matrixWorld);
    return [hit.x, hit.y, hit.z];
}

/** All points moved by the same amount, so that the rake keeps its shape. */
export function translate(points: readonly Vec3[], by: Vec3): Vec3[] {
    return points.map(([x, y, z]) => [x + by[0], y + by[1], z + by[2]]);
}

export function difference(a: Vec3, b: Vec3): Vec3 {
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

/** The middle between the first and the last point: where the handle that moves all of them sits. */
export function middleOf(points: readonly Vec3[]): Vec3 {
    const first = points[0] ?? [0, 0, 0];
    const last = points[points.length - 1] ?? first;
    return [(first[0] + last[0]) / 2, (first[1] + last[1]) / 2, (first[2] + last[2]) / 2];
}
