// The lines of a camera in space: from the eye to the corners of what it looks at, a quarter of the way
// there.
import { Vector3 } from 'three';
import type { CameraPlace, Vec3 } from '../../protocol/messages.ts';
import type { View } from '../base/view.ts';

/** Says how far its far side is, as a share of the way to the target. */
const reach = 0.25;
const aspect = 1.6;
const openingWithoutPerspective = 12;

/** Returns whether a camera is where the view's own is: its lines would be a frame round the picture. */
export function looksFromHere(view: View, { position, target }: CameraPlace): boolean {
    const reachOfEye = new Vector3(...position).distanceTo(new Vector3(...target));
    return new Vector3(...position).distanceTo(view.camera.position) < 0.02 * reachOfEye;
}

/** Eight segments, two points each. */
export function frustumSegments({ position, target, up, fov }: CameraPlace): Vec3[] {
    const eye = new Vector3(...position);
    const ahead = new Vector3(...target).sub(eye);
    const depth = ahead.length() * reach;
    if (!(depth > 0)) return [];
    ahead.normalize();
    const right = new Vector3().crossVectors(ahead, new Vector3(...up));
    // Looking along `up` there is no right: any will do.
    if (right.lengthSq() < 1e-12) right.crossVectors(ahead, new Vector3(1, 0, 0));
    right.normalize();
    const above = new Vector3().crossVectors(right, ahead);
    const half = depth * Math.tan(((fov ?? openingWithoutPerspective) * Math.PI) / 360);
    const corners = (
        [
            [-1, -1],
            [1, -1],
            [1, 1],
            [-1, 1],
        ] as const
    ).map(([x, y]) =>
        eye
            .clone()
            .addScaledVector(ahead, depth)
            .addScaledVector(right, x * half * aspect)
            .addScaledVector(above, y * half),
    );
    const segments: Vec3[] = [];
    corners.forEach((corner, i) => {
        const next = corners[(i + 1) % corners.length]!;
        segments.push(position, corner.toArray(), corner.toArray(), next.toArray());
    });
    return segments;
}
