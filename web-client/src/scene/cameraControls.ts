// The camera: orbit, pan and zoom with the mouse, views that show the whole domain.
import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Vec3 } from '../protocol/messages.ts';
import { type Bounds, centreOf } from './domainAxes.ts';

/** From the domain towards the camera. */
export type ViewName = 'oblique' | 'x' | 'y' | 'z';

const viewDirections: Record<ViewName, Vec3> = {
    oblique: [-0.42, -0.8, 0.43],
    x: [-1, 0, 0],
    y: [0, -1, 0],
    // Not quite straight down: an orbit whose pole is the line of sight would be undefined.
    z: [0, -0.0005, 1],
};

/** The part of the picture that the domain fills; the rest is room for the numbers. */
const filled = 0.84;

export class CameraControls {
    readonly camera = new PerspectiveCamera(30, 1, 0.01, 1000);
    private readonly orbit: OrbitControls;
    private bounds: Bounds = [-1, 1, -1, 1, -1, 1];

    /** @param onHold the view has been taken or let go */
    constructor(requestFrame: () => void, onHold: (held: boolean) => void) {
        this.camera.up.set(0, 0, 1);
        this.orbit = new OrbitControls(this.camera);
        this.orbit.zoomToCursor = true;
        this.orbit.addEventListener('change', requestFrame);
        this.orbit.addEventListener('start', () => onHold(true));
        this.orbit.addEventListener('end', () => onHold(false));
    }

    /** Starts to listen; whoever must see a press first has to listen before. */
    connect(canvas: HTMLCanvasElement): void {
        this.orbit.connect(canvas);
    }

    setAspect(aspect: number): void {
        this.camera.aspect = aspect;
        this.camera.updateProjectionMatrix();
    }

    setBounds(bounds: Bounds): void {
        this.bounds = bounds;
        this.show('oblique');
    }

    /** Looks along a named direction from where the whole domain is visible. */
    show(view: ViewName): void {
        const centre = new Vector3(...centreOf(this.bounds));
        const towards = new Vector3(...viewDirections[view]).normalize();
        const distance = fittingDistance(this.bounds, towards, this.camera);
        this.place(
            centre.clone().addScaledVector(towards, distance).toArray() as Vec3,
            centre.toArray() as Vec3,
        );
    }

    place(position: Vec3, target: Vec3): void {
        this.camera.position.set(...position);
        this.orbit.target.set(...target);
        const size = diagonal(this.bounds);
        this.camera.near = size * 0.002;
        this.camera.far = size * 20;
        this.orbit.maxDistance = size * 10;
        this.orbit.minDistance = size * 0.005;
        this.camera.updateProjectionMatrix();
        this.orbit.update();
        this.camera.updateMatrixWorld();
    }

    get target(): Vec3 {
        return this.orbit.target.toArray() as Vec3;
    }
}

export function diagonal(bounds: Bounds): number {
    return Math.hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
}

/** The nearest distance of the camera from the centre at which every corner is in the picture. */
export function fittingDistance(
    bounds: Bounds,
    towards: Vector3,
    camera: PerspectiveCamera,
): number {
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
