// From how far a camera sees a whole box.
import { type PerspectiveCamera, Vector3 } from 'three';
import { type Bounds, centreOf } from '../domain/domainAxes.ts';

/** The part of the picture that the domain fills; the rest is room for the numbers. */
const filled = 0.84;

export function diagonal(bounds: Bounds): number {
    return Math.hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
}

/** The nearest distance of the camera from the centre at which every corner is in the picture. */
export function fittingDistance(bounds: Bounds, towards: Vector3, camera: PerspectiveCamera): number {
    const right = new Vector3().crossVectors(camera.up, towards).normalize();
    const above = new Vector3().crossVectors(towards, right);
    const tangentY = Math.tan((camera.fov * Math.PI) / 360) * filled;
    const tangentX = tangentY * camera.aspect;
    const centre = new Vector3(...centreOf(bounds));
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
        const offset = new Vector3(
            bounds[corner & 1] ?? 0,
            bounds[2 + ((corner >> 1) & 1)] ?? 0,
            bounds[4 + ((corner >> 2) & 1)] ?? 0,
        ).sub(centre);
        const depth = offset.dot(towards);
        distance = Math.max(
            distance,
            depth + Math.abs(offset.dot(right)) / tangentX,
            depth + Math.abs(offset.dot(above)) / tangentY,
        );
    }
    return distance;
}
