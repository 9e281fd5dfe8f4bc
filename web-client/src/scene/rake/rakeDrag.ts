// Applies what dragging a handle does to a rake: from where the pointer was and is to the new shape, held to
// an axis or a grid if asked.
import { Vector3 } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { shortNumber } from '../base/numbers.ts';
import type { ScreenPoint, View } from '../base/view.ts';
import { type Handle, positionOf } from './rakeHandles.ts';
import { circleOf, middleOf, normalOf, type RakeShape, resized, tilted, translated, turnedBy, withPoint } from './rakeShape.ts';
import { alongAxis, type Axis, nearestAxis, onGrid, toStep, turnStep } from './snapping.ts';
import { cross, distance, dot, minus, plus, times, unit } from './vec3.ts';

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
    /** Is the spacing of the grid; null: no grid. */
    step: number | null;
}

export interface Dragged {
    shape: RakeShape;
    /** Where the handle is drawn meanwhile. */
    at: Vec3;
    /** Kept to, and from where. */
    axis: { axis: Axis; from: Vec3 } | null;
    /** Holds what the snapping does, in words. */
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
    const kept: Vec3 = [...anchor];
    kept[axis] = snapped[axis];
    return kept;
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

/** Turns the circle like a ball: the handle stays on the sphere round the circle, under the pointer while
 *  that is over the sphere. */
function tipped({ start, anchor }: Drag, target: ScreenPoint, view: View): Dragged {
    const { centre, radius } = circleOf(start);
    const [eye, further] = view.sightLine(target);
    const sight = unit(minus(further, eye));
    const along = dot(minus(centre, eye), sight);
    const nearest = plus(eye, times(sight, along));
    const beside = distance(nearest, centre);
    const half = Math.sqrt(Math.max(0, radius * radius - beside * beside));
    // On the side where the handle was: far or near.
    const far = dot(minus(anchor, centre), sight) > 0 ? 1 : -1;
    const shape = tilted(start, plus(nearest, times(sight, far * half)));
    return { shape, at: shape.points[2] ?? anchor, axis: null, words: '' };
}

/** Out of the screen. */
export function towardsViewer(view: View): Vec3 {
    return new Vector3().setFromMatrixColumn(view.camera.matrixWorld, 2).normalize().toArray();
}
