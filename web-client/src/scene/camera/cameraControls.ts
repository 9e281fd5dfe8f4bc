// The camera: orbit, pan and zoom with the mouse, in perspective or without; views that show the whole
// domain.
import { OrthographicCamera, PerspectiveCamera, Quaternion, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Vec3 } from '../../protocol/messages.ts';
import type { SceneCamera } from '../base/view.ts';
import { type Bounds, centreOf } from '../domain/domainAxes.ts';

/** From the domain towards the camera; oblique: as shows most of it. */
export type ViewName = 'oblique' | 'x' | 'y' | 'z' | '-x' | '-y' | '-z';

const viewDirections: Record<ViewName, Vec3> = {
    oblique: [-0.42, -0.8, 0.43],
    x: [-1, 0, 0],
    y: [0, -1, 0],
    // Not quite straight down: an orbit whose pole is the line of sight would be undefined.
    z: [0, -0.0005, 1],
    '-x': [1, 0, 0],
    '-y': [0, 1, 0],
    '-z': [0, -0.0005, -1],
};

/** The part of its shorter other side below which a domain is a slab, as of a plane flow. */
const slab = 0.15;

/** From where a slab is seen straight on; nothing for domains that are none. */
function straightOn(bounds: Bounds): ViewName | undefined {
    const sides = [0, 1, 2].map((k) => bounds[2 * k + 1]! - bounds[2 * k]!);
    const [thin, shorter] = sides.toSorted((a, b) => a - b) as Vec3;
    return thin < slab * shorter ? (['-x', 'y', 'z'] as const)[sides.indexOf(thin)] : undefined;
}

/** Where the camera is and what it looks at; without perspective, what is seen is what would be at the
 *  target's distance. */
export interface CameraPose {
    position: Vec3;
    target: Vec3;
    orthographic: boolean;
}

const upwards: Vec3 = [0, 0, 1];

/** The poles of a Spherical are on y. */
const zToY = new Quaternion().setFromUnitVectors(new Vector3(...upwards), new Vector3(0, 1, 0));
/** Straight from above, what is to the right would be undefined. */
const poleGap = 0.0005;

export interface CameraControlsOptions {
    requestFrame: () => void;
    /** The view has been taken or released. */
    onHold: (held: boolean) => void;
    /** A user turns, moves or zooms it bit by bit, other than by `place`. */
    onTurn: () => void;
}

export class CameraControls {
    private readonly perspective = new PerspectiveCamera(30, 1, 0.01, 1000);
    private readonly parallel = new OrthographicCamera(-1, 1, 1, -1, 0.01, 1000);
    private readonly orbit: FineOrbit;
    private moved: (() => void)[] = [];
    private readonly onTurn: () => void;
    private bounds: Bounds = [-1, 1, -1, 1, -1, 1];
    private orthographic = false;
    /** The camera follows another user's just now. */
    private led = false;
    private placing = false;
    /** No user has moved it since it showed a new domain by itself. */
    private untouched = false;
    /** What it shows by itself while no user has moved it. */
    private shownPart: Bounds | null = null;
    /** Width of the picture on the page over its height, as `resized` was last told. The cameras' own changes with
     *  what is drawn: a figure, or a frame of the new size before the page tells of it. */
    private aspect = 1;
    /** The same when the camera was last placed or moved. */
    private placedAspect = 1;

    constructor({ requestFrame, onHold, onTurn }: CameraControlsOptions) {
        this.onTurn = onTurn;
        for (const camera of [this.perspective, this.parallel]) camera.up.set(...upwards);
        this.orbit = new FineOrbit(this.perspective);
        this.orbit.zoomToCursor = true;
        this.orbit.addEventListener('change', () => {
            if (!this.led) for (const listener of this.moved) listener();
            if (!this.placing) {
                this.placedAspect = this.aspect;
                this.untouched = false;
                onTurn();
            }
            requestFrame();
        });
        this.orbit.addEventListener('start', () => {
            this.untouched = false;
            onHold(true);
        });
        this.orbit.addEventListener('end', () => onHold(false));
    }

    /** The one that sees the picture; another object once the projection is another. */
    get camera(): SceneCamera {
        return this.orthographic ? this.parallel : this.perspective;
    }

    /** Vertical opening of the perspective, in degrees. */
    get fov(): number {
        return this.perspective.fov;
    }

    get target(): Vec3 {
        return this.orbit.target.toArray();
    }

    get pose(): CameraPose {
        const target = this.target;
        const position = this.camera.position.clone();
        // Without perspective a nearer look is a larger scale.
        if (this.orthographic) {
            position.sub(this.orbit.target).divideScalar(this.parallel.zoom).add(this.orbit.target);
        }
        return { position: position.toArray(), target, orthographic: this.orthographic };
    }

    /** Starts to listen; a tool that must see a press first has to listen before. */
    connect(canvas: HTMLCanvasElement): void {
        this.orbit.connect(canvas);
    }

    /** Called when the camera has been moved, but for `follow`. */
    onMove(listener: () => void): () => void {
        this.moved.push(listener);
        return () => (this.moved = this.moved.filter((each) => each !== listener));
    }

    /** Of what is drawn next, on the page or aside. */
    setAspect(aspect: number): void {
        this.perspective.aspect = aspect;
        this.perspective.updateProjectionMatrix();
        const half = this.parallel.top;
        this.parallel.left = -half * aspect;
        this.parallel.right = half * aspect;
        this.parallel.updateProjectionMatrix();
    }

    /**
     * The picture on the page has another shape: what was seen in its width stays in it. A figure, which has
     * a shape of its own, is drawn from where the camera is.
     */
    resized(aspect: number): void {
        const before = this.aspect;
        this.aspect = aspect;
        this.setAspect(aspect);
        if (aspect === before) return;
        if (this.untouched && this.shownPart !== null) {
            this.offer(this.shownPart);
            return;
        }
        const { placedAspect } = this;
        const away = Math.max(1, placedAspect / aspect) / Math.max(1, placedAspect / before);
        if (away === 1) return;
        const { target } = this.orbit;
        const position = this.offset().multiplyScalar(away).add(target).toArray();
        this.place({ position, target: target.toArray(), orthographic: this.orthographic });
        this.placedAspect = placedAspect;
    }

    setBounds(bounds: Bounds): void {
        this.bounds = bounds;
        this.show('oblique');
        this.shownPart = bounds;
        this.untouched = true;
    }

    /** The picture holds more, or less: shows all of it, unless a user has moved the camera. */
    widen(bounds: Bounds): void {
        if (bounds.every((each, k) => each === this.bounds[k])) return;
        this.bounds = bounds;
        if (!this.offer(bounds)) this.follow(this.pose);
    }

    /** Shows this part of the domain as it would show all of it, unless a user has moved it. False: it has
     *  been. Of a slab all stays in view. */
    offer(part: Bounds): boolean {
        if (!this.untouched) return false;
        this.lookAt(straightOn(this.bounds) === undefined ? part : this.bounds, 'oblique');
        this.shownPart = part;
        this.untouched = true;
        return true;
    }

    setOrthographic(orthographic: boolean): void {
        this.place({ ...this.pose, orthographic });
    }

    /** Looks along a named direction from where the whole domain is visible. */
    show(view: ViewName): void {
        this.lookAt(this.bounds, view);
    }

    private lookAt(box: Bounds, view: ViewName): void {
        const centre = new Vector3(...centreOf(box));
        const from = view === 'oblique' ? (straightOn(this.bounds) ?? view) : view;
        const towards = new Vector3(...viewDirections[from]).normalize();
        const distance = fittingDistance(box, towards, this.perspective);
        const position = centre.clone().addScaledVector(towards, distance).toArray();
        this.place({ position, target: centre.toArray(), orthographic: this.orthographic });
    }

    place({ position, target, orthographic }: CameraPose): void {
        this.untouched = false;
        this.placedAspect = this.aspect;
        this.orthographic = orthographic;
        const { camera } = this;
        camera.position.set(...position);
        this.orbit.object = camera;
        this.orbit.target.set(...target);
        const size = diagonal(this.bounds);
        camera.near = size * 0.002;
        camera.far = size * 20;
        this.orbit.maxDistance = size * 10;
        this.orbit.minDistance = size * 0.005;
        if (orthographic) this.scaleParallel(camera.position.distanceTo(this.orbit.target), size);
        camera.updateProjectionMatrix();
        // Tells of itself where the orbit sees a change; a change of projection it does not see.
        this.placing = !this.led;
        if (!this.orbit.update() && !this.led) for (const listener of this.moved) listener();
        this.placing = false;
        camera.updateMatrixWorld();
    }

    /** Round the target, as if the picture were dragged: so many radians to the right, and upwards. */
    turn(right: number, up: number): void {
        const { target } = this.orbit;
        const place = new Spherical().setFromVector3(this.offset().applyQuaternion(zToY));
        place.theta -= right;
        place.phi = Math.min(Math.PI - poleGap, Math.max(poleGap, place.phi + up));
        this.move(new Vector3().setFromSpherical(place).applyQuaternion(zToY.clone().invert()).add(target), target);
    }

    /** Moves what is seen by parts of the height of the picture. */
    pan(right: number, up: number): void {
        const { camera, orbit } = this;
        const offset = this.offset();
        const height = 2 * offset.length() * Math.tan((this.perspective.fov * Math.PI) / 360);
        const by = new Vector3(-right, -up, 0).multiplyScalar(height).applyQuaternion(camera.quaternion);
        this.move(offset.add(orbit.target).add(by), orbit.target.clone().add(by));
    }

    /** Towards the target; less than 1: away from it. */
    zoom(factor: number): void {
        const { target } = this.orbit;
        this.move(this.offset().divideScalar(factor).add(target), target);
    }

    /** From the target to where the camera is, or would be with perspective. */
    private offset(): Vector3 {
        return new Vector3(...this.pose.position).sub(this.orbit.target);
    }

    private move(position: Vector3, target: Vector3): void {
        this.place({ position: position.toArray(), target: target.toArray(), orthographic: this.orthographic });
        this.onTurn();
    }

    /** Takes the pose of another user: nothing is told that this camera has moved. */
    follow(pose: CameraPose): void {
        this.led = true;
        this.place(pose);
        this.led = false;
    }

    /** Shows things as large as the perspective shows what is at `distance`. */
    private scaleParallel(distance: number, size: number): void {
        const { parallel } = this;
        const half = distance * Math.tan((this.perspective.fov * Math.PI) / 360);
        parallel.zoom = 1;
        parallel.top = half;
        parallel.bottom = -half;
        parallel.right = half * this.aspect;
        parallel.left = -parallel.right;
        // Nothing of the domain may be cut off because the camera is near it.
        parallel.near = -10 * size;
    }
}

/** A part of the distance to the target: far less than a pixel. */
const leastMovement = 1e-6;

/**
 * Orbit controls for domains of any size: three's own tell of no movement shorter than a thousandth of a unit, which in a
 * domain of micrometres is every one, so that nothing would be drawn again.
 */
export class FineOrbit extends OrbitControls {
    /** Not there while three's constructor runs. */
    private reported?: { position: Vector3; target: Vector3 };

    override update(deltaTime?: number | null): boolean {
        const changed = super.update(deltaTime);
        const { position } = this.object;
        const { target } = this;
        this.reported ??= { position: new Vector3(Infinity), target: new Vector3() };
        const least = leastMovement * position.distanceTo(target);
        const moved = this.reported.position.distanceTo(position) > least || this.reported.target.distanceTo(target) > least;
        if (!changed && !moved) return false;
        this.reported.position.copy(position);
        this.reported.target.copy(target);
        if (!changed) this.dispatchEvent({ type: 'change' });
        return true;
    }
}

/** The part of the picture that the domain fills; the rest is room for the numbers. */
const filled = 0.84;

export function diagonal(bounds: Bounds): number {
    return Math.hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
}

/** The nearest distance of the camera from the centre at which every corner is in the picture. */
function fittingDistance(bounds: Bounds, towards: Vector3, camera: PerspectiveCamera): number {
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
