// What dragging a handle does to a rake: from where the pointer was and is to the new shape, held to an axis or a grid if asked.
import { Vector3 } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { niceStep, shortNumber } from '../base/numbers.ts';
import type { ScreenPoint, View } from '../base/view.ts';
import { type Handle, positionOf } from './rakeHandles.ts';
import {
    circleOf,
    cross,
    distance,
    dot,
    middleOf,
    minus,
    normalOf,
    plus,
    type RakeShape,
    resized,
    tilted,
    times,
    translated,
    turnedBy,
    unit,
    withPoint,
} from './rakeShape.ts';

export interface Drag {
    handle: Handle;
    start: RakeShape;
    /** Where the handle was. */
    anchor: Vec3;
    pressed: ScreenPoint;
    /** From the pointer to the handle's centre: a press off the centre must not make it jump. */
    grab: ScreenPoint;
}

export interface Snap {
    /** Keep to an axis: to this one, or to the one that the movement is nearest to. */
    axis: Axis | 'nearest' | null;
    /** The spacing of the grid; null: no grid. */
    step: number | null;
}

export interface Dragged {
    shape: RakeShape;
    /** Where the handle is drawn meanwhile. */
    at: Vec3;
    /** Kept to, and from where. */
    axis: { axis: Axis; from: Vec3 } | null;
    /** What the snapping does, in words. */
    words: string;
}

const axisNames = ['x', 'y', 'z'] as const;

export function beginDrag(handle: Handle, start: RakeShape, pressed: ScreenPoint, view: View): Drag {
    const anchor = positionOf(handle, start, view);
    const centre = view.project(anchor) ?? pressed;
    return { handle, start, anchor, pressed, grab: { x: centre.x - pressed.x, y: centre.y - pressed.y } };
}

export function dragged(drag: Drag, pointer: ScreenPoint, view: View, snap: Snap): Dragged {
    const { handle, start } = drag;
    const target = { x: pointer.x + drag.grab.x, y: pointer.y + drag.grab.y };
    if (handle === 'rotate') return rotated(drag, target, view, snap);
    if (start.kind === 'circle' && handle === 1) return sized(drag, target, view, snap);
    if (start.kind === 'circle' && handle === 2) return tipped(drag, target, view);
    return moved(drag, pointer, target, view, snap);
}

function moved(drag: Drag, pointer: ScreenPoint, target: ScreenPoint, view: View, snap: Snap): Dragged {
    const { handle, start, anchor, pressed } = drag;
    const movement = { x: pointer.x - pressed.x, y: pointer.y - pressed.y };
    const axis = snap.axis === 'nearest' ? nearestAxis(anchor, movement, view) : snap.axis;
    let to = axis === null ? view.pointAtDepth(target, anchor) : alongAxis(anchor, axis, target, view);
    if (snap.step !== null) to = gridded(to, anchor, axis, snap.step);
    const shape = handle === 'middle' ? translated(start, minus(to, anchor)) : withPoint(start, handle as number, to);
    const words = [axis === null ? '' : `along ${axisNames[axis]}`, snap.step === null ? '' : `grid ${shortNumber(snap.step)}`];
    return {
        shape,
        at: to,
        axis: axis === null ? null : { axis, from: anchor },
        words: words.filter((each) => each !== '').join(', '),
    };
}

function gridded(to: Vec3, anchor: Vec3, axis: Axis | null, step: number): Vec3 {
    const snapped = onGrid(to, step);
    if (axis === null) return snapped;
    const point: Vec3 = [...anchor];
    point[axis] = snapped[axis];
    return point;
}

/** In the plane that faces the camera, so that the handle stays under the pointer. */
function rotated({ start, anchor }: Drag, target: ScreenPoint, view: View, snap: Snap): Dragged {
    const middle = middleOf(start);
    const at = view.pointAtDepth(target, middle);
    const [before, now] = [minus(anchor, middle), minus(at, middle)];
    const axis = towardsViewer(view);
    let angle = Math.atan2(dot(cross(before, now), axis), dot(before, now));
    const stepped = snap.axis !== null || snap.step !== null;
    if (stepped) angle = Math.round(angle / turnStep) * turnStep;
    const degrees = Math.round((angle * 180) / Math.PI);
    return { shape: turnedBy(start, axis, angle), at, axis: null, words: `${degrees}°${stepped ? ', steps of 15°' : ''}` };
}

/** In the circle's own plane, unless that is seen from its edge. */
function sized({ start, anchor }: Drag, target: ScreenPoint, view: View, snap: Snap): Dragged {
    const circle = circleOf(start);
    const [eye, further] = view.sightLine(target);
    const sight = unit(minus(further, eye));
    const normal = normalOf(circle);
    const slope = dot(normal, sight);
    let rim =
        Math.abs(slope) > 0.15
            ? plus(eye, times(sight, dot(normal, minus(circle.centre, eye)) / slope))
            : view.pointAtDepth(target, anchor);
    if (snap.step !== null) {
        const radius = Math.max(snap.step, toStep(distance(rim, circle.centre), snap.step));
        rim = plus(circle.centre, times(unit(minus(rim, circle.centre)), radius));
    }
    const words = `radius ${shortNumber(distance(rim, circle.centre))}`;
    return { shape: resized(start, rim), at: rim, axis: null, words };
}

/** Turns the circle like a ball. */
function tipped({ start, anchor }: Drag, target: ScreenPoint, view: View): Dragged {
    const { centre, radius } = circleOf(start);
    const shape = tilted(start, onBall({ centre, radius, anchor }, target, view));
    return { shape, at: shape.points[2] ?? anchor, axis: null, words: '' };
}

export interface Ball {
    centre: Vec3;
    radius: number;
    /** Where on it the handle was: on the near side, or the far one. */
    anchor: Vec3;
}

/** The point of a ball's surface under the pointer, on the side where the handle was; beside the ball the point of its rim that is
 *  nearest. */
export function onBall({ centre, radius, anchor }: Ball, target: ScreenPoint, view: View): Vec3 {
    const [eye, further] = view.sightLine(target);
    const sight = unit(minus(further, eye));
    const along = dot(minus(centre, eye), sight);
    const nearest = plus(eye, times(sight, along));
    const beside = distance(nearest, centre);
    const half = Math.sqrt(Math.max(0, radius * radius - beside * beside));
    const far = dot(minus(anchor, centre), sight) > 0 ? 1 : -1;
    return plus(nearest, times(sight, far * half));
}

/** Out of the screen. */
export function towardsViewer(view: View): Vec3 {
    return new Vector3().setFromMatrixColumn(view.camera.matrixWorld, 2).normalize().toArray();
}

export type Axis = 0 | 1 | 2;

const turnStep = Math.PI / 12;

/** Returns the spacing of a grid that divides the domain's longest side into twenty to forty. */
export function gridStep(bounds: readonly number[]): number {
    const sides = [0, 1, 2].map((axis) => (bounds[2 * axis + 1] ?? 1) - (bounds[2 * axis] ?? 0));
    return niceStep(Math.max(...sides) / 40);
}

export function onGrid(point: Vec3, step: number): Vec3 {
    return [toStep(point[0], step), toStep(point[1], step), toStep(point[2], step)];
}

function toStep(value: number, step: number): number {
    const rounded = Math.round(value / step) * step;
    // 3 * 0.1 is not 0.3; what the grid means is.
    return Number(rounded.toPrecision(12));
}

/** The axis through a point that a movement of the pointer is nearest to as it is seen; null where it has not
 *  moved. */
export function nearestAxis(from: Vec3, movement: ScreenPoint, view: View): Axis | null {
    let best: Axis | null = null;
    let least = Number.POSITIVE_INFINITY;
    for (const axis of [0, 1, 2] as const) {
        const seen = directionOnScreen(from, unitAxis(axis), view);
        if (seen === null) continue;
        const across = Math.abs(movement.x * seen.y - movement.y * seen.x);
        if (across < least) [best, least] = [axis, across];
    }
    return Math.hypot(movement.x, movement.y) > 0 ? best : null;
}

/** The point of the axis line through `from` whose picture is nearest to a canvas position. */
export function alongAxis(from: Vec3, axis: Axis, pointer: ScreenPoint, view: View): Vec3 {
    return alongLine(from, unitAxis(axis), pointer, view) ?? from;
}

/** The point of a line whose picture is nearest to a canvas position; null where the line points at the eye. */
export function alongLine(from: Vec3, direction: Vec3, pointer: ScreenPoint, view: View): Vec3 | null {
    const start = view.project(from);
    const seen = directionOnScreen(from, direction, view);
    if (start === null || seen === null) return null;
    const along = (pointer.x - start.x) * seen.x + (pointer.y - start.y) * seen.y;
    const foot = { x: start.x + along * seen.x, y: start.y + along * seen.y };
    // The line of sight through the foot meets the line.
    const [eye, further] = view.sightLine(foot);
    const sight = minus(further, eye);
    const normal = cross(sight, cross(direction, sight));
    const slope = dot(normal, direction);
    if (Math.abs(slope) < 1e-12 * dot(normal, normal) ** 0.5) return null;
    const t = dot(normal, minus(eye, from)) / slope;
    return Number.isFinite(t) ? plus(from, times(direction, t)) : null;
}

export function unitAxis(axis: Axis): Vec3 {
    return [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0];
}

/** Null where it points at the eye. */
function directionOnScreen(from: Vec3, direction: Vec3, view: View): ScreenPoint | null {
    const a = view.project(from);
    if (a === null) return null;
    const step = 40 * view.worldPerPx(from);
    const b = view.project(plus(from, times(direction, step)));
    if (b === null) return null;
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    return length < 2 ? null : { x: (b.x - a.x) / length, y: (b.y - a.y) / length };
}
