// The rake in the scene: a line, a handle at each of its points and one in the middle that moves
// them all. Handles keep their size on the screen and are drawn over everything, because a handle
// that cannot be seen cannot be dragged.
import {
    CanvasTexture,
    CylinderGeometry,
    Group,
    Mesh,
    MeshBasicMaterial,
    Sprite,
    SpriteMaterial,
    SRGBColorSpace,
    Vector3,
} from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import type { Layer, ScreenPoint, View } from '../view.ts';
import { middleOf } from './rakeDrag.ts';

export const handleRadiusPx = 12;
export const hitRadiusPx = 18;
const linePx = 3;

/** Index of a point of the rake, or the handle that moves all of them. */
export type Handle = number | 'middle';

export class RakeWidget implements Layer {
    readonly object = new Group();
    private points: Vec3[] = [];
    private readonly textures = { end: handleTexture(false), middle: handleTexture(true) };
    private readonly segments: Mesh[] = [];
    private readonly handles = new Map<Handle, Sprite>();
    private highlighted: Handle | null = null;
    private readonly lineMaterial = new MeshBasicMaterial({ color: 0xffffff });
    // Where the line is behind something it still shows through, faintly.
    private readonly hiddenLineMaterial = new MeshBasicMaterial({
        color: 0xffffff,
        transparent: true,
        opacity: 0.35,
        depthTest: false,
        depthWrite: false,
    });
    private readonly lineGeometry = new CylinderGeometry(1, 1, 1, 8, 1, true);

    setPoints(points: readonly Vec3[]): void {
        if (points.length !== this.points.length) this.rebuild(points.length);
        this.points = points.map((point) => [...point] as Vec3);
        this.object.visible = points.length > 0;
    }

    getPoints(): Vec3[] {
        return this.points.map((point) => [...point] as Vec3);
    }

    /** Where a handle is, in world coordinates. */
    positionOf(handle: Handle): Vec3 {
        return handle === 'middle' ? middleOf(this.points) : (this.points[handle] ?? [0, 0, 0]);
    }

    handleNames(): Handle[] {
        return [...this.handles.keys()];
    }

    setHighlighted(handle: Handle | null): boolean {
        const changed = handle !== this.highlighted;
        this.highlighted = handle;
        return changed;
    }

    /** The handle under a canvas position; the nearest one where their areas overlap. */
    handleAt(pointer: ScreenPoint, view: View): Handle | null {
        let nearest: Handle | null = null;
        let nearestPx = hitRadiusPx;
        for (const handle of this.handles.keys()) {
            const at = view.project(this.positionOf(handle));
            if (at === null) continue;
            const px = Math.hypot(at.x - pointer.x, at.y - pointer.y);
            if (px > nearestPx) continue;
            nearest = handle;
            nearestPx = px;
        }
        return nearest;
    }

    /** Brings the drawn objects in line with points and camera; called before every frame. */
    update(view: View): void {
        for (const [handle, sprite] of this.handles) {
            const at = this.positionOf(handle);
            sprite.position.set(...at);
            const grown = handle === this.highlighted ? 1.25 : 1;
            sprite.scale.setScalar(view.worldPerPx(at) * 2 * (handleRadiusPx + 1) * grown);
        }
        const copies = this.segments.length / Math.max(1, this.points.length - 1);
        this.segments.forEach((segment, i) => {
            const k = Math.floor(i / copies);
            const [a, b] = [this.points[k], this.points[k + 1]];
            if (a === undefined || b === undefined) return;
            placeSegment(segment, a, b, view.worldPerPx(middleOf([a, b])) * linePx * 0.5);
        });
    }

    private rebuild(count: number): void {
        this.object.clear();
        this.segments.length = 0;
        for (const sprite of this.handles.values()) sprite.material.dispose();
        this.handles.clear();
        for (let k = 0; k + 1 < count; ++k) {
            this.addSegment(this.hiddenLineMaterial, 9);
            this.addSegment(this.lineMaterial, 10);
        }
        for (let k = 0; k < count; ++k) this.addHandle(k);
        if (count > 1) this.addHandle('middle');
    }

    private addSegment(material: MeshBasicMaterial, order: number): void {
        const segment = new Mesh(this.lineGeometry, material);
        segment.renderOrder = order;
        segment.frustumCulled = false;
        this.segments.push(segment);
        this.object.add(segment);
    }

    private addHandle(handle: Handle): void {
        const material = new SpriteMaterial({
            map: handle === 'middle' ? this.textures.middle : this.textures.end,
            depthTest: false,
            depthWrite: false,
            toneMapped: false,
        });
        const sprite = new Sprite(material);
        sprite.renderOrder = 20;
        this.handles.set(handle, sprite);
        this.object.add(sprite);
    }
}

const up = new Vector3(0, 1, 0);

function placeSegment(segment: Mesh, a: Vec3, b: Vec3, radius: number): void {
    const from = new Vector3(...a);
    const along = new Vector3(...b).sub(from);
    const length = along.length();
    segment.position.copy(from).addScaledVector(along, 0.5);
    segment.scale.set(radius, Math.max(length, 1e-12), radius);
    if (length > 0) segment.quaternion.setFromUnitVectors(up, along.divideScalar(length));
}

/** End handles are discs, the middle one is a ring with a cross: they do different things. */
function handleTexture(middle: boolean): CanvasTexture {
    const size = 64;
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = size;
    const pen = canvas.getContext('2d');
    if (pen !== null) {
        const centre = size / 2;
        disc(pen, centre, 31, 'rgba(8, 12, 20, 0.85)');
        disc(pen, centre, 27, '#ffffff');
        disc(pen, centre, 20, middle ? '#111927' : '#ff7a45');
        if (middle) {
            pen.fillStyle = '#ffffff';
            pen.fillRect(centre - 11, centre - 3, 22, 6);
            pen.fillRect(centre - 3, centre - 11, 6, 22);
        }
    }
    const texture = new CanvasTexture(canvas);
    texture.colorSpace = SRGBColorSpace;
    return texture;
}

function disc(pen: CanvasRenderingContext2D, centre: number, radius: number, fill: string): void {
    pen.fillStyle = fill;
    pen.beginPath();
    pen.arc(centre, centre, radius, 0, 2 * Math.PI);
    pen.fill();
}
