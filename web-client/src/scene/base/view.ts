// The camera and the canvas together: between places in space and places on the screen.
import { type Object3D, type OrthographicCamera, type PerspectiveCamera, Vector3 } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';

/** Canvas position in CSS pixels, from the top left. */
export interface ScreenPoint {
    x: number;
    y: number;
}

export interface ScreenSize {
    width: number;
    height: number;
}

/** A part of a picture, in its pixels; may reach beyond it. */
export interface Part extends ScreenSize {
    x: number;
    y: number;
}

export type SceneCamera = PerspectiveCamera | OrthographicCamera;

/** A place that a layer shows. */
export interface SeenPoint {
    point: Vec3;
    /** From the eye; without perspective, from the plane of the camera. */
    distance: number;
}

/** What is drawn beside the surfaces: brought in line with camera and canvas before every frame. */
export interface Layer {
    readonly object: Object3D;
    /** True of what people work with, as pointers of others: no part of a figure. */
    readonly notForFigures?: boolean;
    update(view: View): void;
    /** Returns what of it people point at, at a canvas position. */
    pick?(view: View, at: ScreenPoint): SeenPoint | null;
}

/** Is valid for one frame or one event; a snapshot of neither. REQUIRES: the camera's matrices are up to
 *  date. */
export class View {
    readonly camera: SceneCamera;
    readonly size: ScreenSize;
    /** What of it is drawn at once: less where a picture is drawn in tiles. */
    readonly drawnSize: ScreenSize;
    /** Pixels for one of CSS, along one side. */
    readonly pixelRatio: number;

    constructor(camera: SceneCamera, size: ScreenSize, drawnSize = size, pixelRatio = 1) {
        this.camera = camera;
        this.size = size;
        this.drawnSize = drawnSize;
        this.pixelRatio = pixelRatio;
    }

    get eye(): Vec3 {
        return this.camera.position.toArray();
    }

    get isParallel(): boolean {
        return isOrthographic(this.camera);
    }

    /** Where the rays come from: the eye, or without perspective a place far away behind it. */
    get outside(): Vec3 {
        const { camera, eye } = this;
        if (!isOrthographic(camera)) return eye;
        const back = new Vector3(0, 0, 1).applyQuaternion(camera.quaternion).multiplyScalar(1e4 * camera.far);
        return back.add(camera.position).toArray();
    }

    /** Null behind a camera with perspective. */
    project(point: Vec3): ScreenPoint | null {
        return projectToScreen(point, this.camera, this.size);
    }

    /** The point under a canvas position at the depth of `anchor`: on the plane through it that faces the
     *  camera. */
    pointAtDepth(pointer: ScreenPoint, anchor: Vec3): Vec3 {
        const depth = new Vector3(...anchor).project(this.camera).z;
        return this.unproject(pointer, depth);
    }

    /** Two points of the line of sight through a canvas position: on the near plane, and further away. */
    sightLine(pointer: ScreenPoint): [Vec3, Vec3] {
        return [this.unproject(pointer, -1), this.unproject(pointer, 0.5)];
    }

    /** As of a SeenPoint. */
    distanceTo(point: Vec3): number {
        if (!this.isParallel) return new Vector3(...point).distanceTo(this.camera.position);
        return -new Vector3(...point).applyMatrix4(this.camera.matrixWorldInverse).z;
    }

    /** Returns how long a CSS pixel is at a place in space. */
    worldPerPx(at: Vec3): number {
        const { camera } = this;
        if (isOrthographic(camera)) return (camera.top - camera.bottom) / camera.zoom / this.size.height;
        const depth = -new Vector3(...at).applyMatrix4(camera.matrixWorldInverse).z;
        return (Math.max(depth, camera.near) * 2 * Math.tan((camera.fov * Math.PI) / 360)) / this.size.height;
    }

    private unproject(pointer: ScreenPoint, depth: number): Vec3 {
        const { width, height } = this.size;
        const clip = new Vector3((pointer.x / width) * 2 - 1, 1 - (pointer.y / height) * 2, depth);
        return clip.unproject(this.camera).toArray();
    }
}

/** Canvas position of a point in world coordinates; null behind the camera, which without perspective sees
 *  there too. */
export function projectToScreen(point: Vec3, camera: SceneCamera, size: ScreenSize): ScreenPoint | null {
    const view = new Vector3(...point).applyMatrix4(camera.matrixWorldInverse);
    if (view.z >= 0 && !isOrthographic(camera)) return null;
    const clip = view.applyMatrix4(camera.projectionMatrix);
    return { x: (clip.x * 0.5 + 0.5) * size.width, y: (0.5 - clip.y * 0.5) * size.height };
}

export function isOrthographic(camera: SceneCamera): camera is OrthographicCamera {
    return 'isOrthographicCamera' in camera;
}
