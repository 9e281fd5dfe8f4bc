// The others in the picture: where they look from, as the lines of their camera, and what they point at, each in their colour and with
// their name; at the edge of the picture, on the way there from the middle, for what lies outside it.
import { Color, Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';
import type { CameraPlace, Participant, Vec3 } from '../../protocol/messages.ts';
import { Labels } from '../base/labels.ts';
import type { Layer, ScreenPoint, View } from '../base/view.ts';
import { tintOf, WideLines } from '../base/wideLines.ts';

const pointerRadiusPx = 6;
const nameGapPx = 14;
/** The buttons of view and tools are above and to the right. */
const hintInsets = { left: 8, right: 112, top: 48, bottom: 8 };
const frustumWidthPx = 1.5;

/** What is drawn of one person. */
class Figure {
    readonly object = new Group();
    participant: Participant;
    readonly pointer: Mesh<SphereGeometry, MeshBasicMaterial>;
    readonly frustum = new WideLines({ width: frustumWidthPx, hidden: true });

    constructor(participant: Participant, sphere: SphereGeometry) {
        this.participant = participant;
        const overEverything = { depthTest: false, depthWrite: false, transparent: true };
        this.pointer = new Mesh(sphere, new MeshBasicMaterial(overEverything));
        this.pointer.renderOrder = 30;
        this.object.add(this.pointer, this.frustum.object);
        this.become(participant);
    }

    become(participant: Participant): void {
        this.participant = participant;
        const colour = new Color(participant.colour);
        this.pointer.material.color = colour;
        const { camera, pointer } = participant;
        const segments = camera === undefined || camera === null ? [] : frustumSegments(camera);
        this.pointer.visible = pointer !== undefined && pointer !== null;
        this.frustum.set(segments.flat(), Array.from({ length: segments.length / 2 }, () => tintOf(colour)).flat());
    }

    dispose(): void {
        this.pointer.material.dispose();
        this.frustum.dispose();
    }
}

export class PeopleLayer implements Layer {
    readonly object = new Group();
    readonly notForFigures = true;
    private readonly labels: Labels;
    private readonly sphere = new SphereGeometry(1, 16, 12);
    private readonly figures = new Map<string, Figure>();

    constructor(layer: HTMLElement) {
        this.labels = new Labels(layer);
    }

    /** All but the person at this page, and the one whose view it takes: their camera would fill the
     *  picture. */
    set(people: readonly Participant[]): void {
        const here = new Set(people.map(({ participant }) => participant));
        for (const [id, figure] of this.figures) {
            if (here.has(id)) continue;
            this.figures.delete(id);
            this.object.remove(figure.object);
            figure.dispose();
        }
        for (const person of people) {
            const known = this.figures.get(person.participant);
            if (known !== undefined) {
                known.become(person);
                continue;
            }
            const figure = new Figure(person, this.sphere);
            this.figures.set(person.participant, figure);
            this.object.add(figure.object);
        }
    }

    update(view: View): void {
        this.labels.begin();
        for (const { participant, pointer, frustum } of this.figures.values()) {
            const { pointer: pointsAt = null, camera = null } = participant;
            const eye = camera !== null && !looksFromHere(view, camera) ? camera.position : null;
            frustum.object.visible = eye !== null;
            frustum.update(view);
            if (pointsAt !== null) {
                pointer.position.set(...pointsAt);
                pointer.scale.setScalar(view.worldPerPx(pointsAt) * pointerRadiusPx);
                this.name(view, pointsAt, participant);
            }
            if (eye !== null) this.name(view, eye, participant);
            this.hint(
                view,
                [pointsAt, eye].filter((place) => place !== null),
                participant,
            );
        }
        this.labels.end();
    }

    /** A user of whom nothing is in the picture, at the edge of it: towards what they point at, else where
     *  they look from. */
    private hint(view: View, places: readonly Vec3[], { name, colour }: Participant): void {
        const hints = places.map((place) => edgeHint(view, place, hintInsets));
        const [hint] = hints;
        if (hint === undefined || hint === null || hints.includes(null)) return;
        const { at, share, towards } = hint;
        const arrow = arrowTowards(towards);
        const label = this.labels.place(at, towards.x < 0 ? `${arrow} ${name}` : `${name} ${arrow}`, 'person', share);
        label.style.borderColor = colour;
    }

    private name(view: View, at: Vec3, { name, colour }: Participant): void {
        const seen = view.project(at);
        if (seen === null) return;
        const label = this.labels.place({ x: seen.x, y: seen.y - nameGapPx }, name, 'person');
        label.style.borderColor = colour;
    }
}

/** How far its far side is, as a share of the way to the target. */
const reach = 0.25;
const aspect = 1.6;
const openingWithoutPerspective = 12;

/** Returns whether a camera is where the view's own is: its lines would be a frame round the picture. */
export function looksFromHere(view: View, { position, target }: CameraPlace): boolean {
    const reachOfEye = new Vector3(...position).distanceTo(new Vector3(...target));
    return new Vector3(...position).distanceTo(view.camera.position) < 0.02 * reachOfEye;
}

/**
 * The lines of a camera in space: from the eye to the corners of what it looks at, a quarter of the way there. Eight segments,
 * two points each.
 */
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

/** How far from the edges, in CSS pixels. */
export interface Insets {
    left: number;
    right: number;
    top: number;
    bottom: number;
}

export interface EdgeHint {
    at: ScreenPoint;
    /** How far along what the insets leave, from the left and from the top: words held there by the same
     *  share of theirs lie in it. */
    share: ScreenPoint;
    /** On the screen, to the right and down; of length 1. */
    towards: ScreenPoint;
}

/**
 * The shortest turn for what is behind the camera. Null for what is in the picture. REQUIRES: the middle of the picture lies
 * between the insets.
 */
export function edgeHint(view: View, point: Vec3, { left, right, top, bottom }: Insets): EdgeHint | null {
    const { width, height } = view.size;
    const middle = { x: width / 2, y: height / 2 };
    const seen = view.project(point);
    if (seen !== null && seen.x >= 0 && seen.x <= width && seen.y >= 0 && seen.y <= height) return null;
    const towards = seen === null ? turnTo(view, point) : unit(seen.x - middle.x, seen.y - middle.y);
    const reach = Math.min(
        (middle.x - (towards.x < 0 ? left : right)) / Math.max(Math.abs(towards.x), 1e-9),
        (middle.y - (towards.y < 0 ? top : bottom)) / Math.max(Math.abs(towards.y), 1e-9),
    );
    const at = { x: middle.x + reach * towards.x, y: middle.y + reach * towards.y };
    const share = { x: (at.x - left) / (width - left - right), y: (at.y - top) / (height - top - bottom) };
    return { at, share, towards };
}

/** Behind the camera nothing is projected: which way to turn says where it is beside the line of sight. */
function turnTo(view: View, point: Vec3): ScreenPoint {
    const { x, y } = new Vector3(...point).applyMatrix4(view.camera.matrixWorldInverse);
    return unit(x, -y);
}

/** Exactly behind, any turn is as short: downwards. */
function unit(x: number, y: number): ScreenPoint {
    const length = Math.hypot(x, y);
    return length > 1e-9 ? { x: x / length, y: y / length } : { x: 0, y: 1 };
}

/** The arrow of eight that points there best. */
export function arrowTowards({ x, y }: ScreenPoint): string {
    const eighth = Math.round((Math.atan2(y, x) * 4) / Math.PI);
    return '→↘↓↙←↖↑↗'[(eighth + 8) % 8]!;
}
