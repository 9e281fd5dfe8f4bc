// Holds a dragged point to an axis or to a grid.
import type { Vec3 } from '../../protocol/messages.ts';
import { niceStep } from '../base/ticks.ts';
import type { ScreenPoint, View } from '../base/view.ts';
import { cross, dot, minus, plus, times } from './vec3.ts';

export type Axis = 0 | 1 | 2;

export const turnStep = Math.PI / 12;

/** Returns the spacing of a grid that divides the domain's longest side into twenty to forty. */
export function gridStep(bounds: readonly number[]): number {
    const sides = [0, 1, 2].map((axis) => (bounds[2 * axis + 1] ?? 1) - (bounds[2 * axis] ?? 0));
    return niceStep(Math.max(...sides) / 40);
}

export function onGrid(point: Vec3, step: number): Vec3 {
    return [toStep(point[0], step), toStep(point[1], step), toStep(point[2], step)];
}

export function toStep(value: number, step: number): number {
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
        const seen = axisOnScreen(from, axis, view);
        if (seen === null) continue;
        const across = Math.abs(movement.x * seen.y - movement.y * seen.x);
        if (across < least) [best, least] = [axis, across];
    }
    return Math.hypot(movement.x, movement.y) > 0 ? best : null;
}

/** The point of the axis line through `from` whose picture is nearest to a canvas position. */
export function alongAxis(from: Vec3, axis: Axis, pointer: ScreenPoint, view: View): Vec3 {
    const start = view.project(from);
    const seen = axisOnScreen(from, axis, view);
    if (start === null || seen === null) return from;
    const along = (pointer.x - start.x) * seen.x + (pointer.y - start.y) * seen.y;
    const foot = { x: start.x + along * seen.x, y: start.y + along * seen.y };
    // The line of sight through the foot meets the axis.
    const [eye, further] = view.sightLine(foot);
    const sight = minus(further, eye);
    const direction = unitAxis(axis);
    const normal = cross(sight, cross(direction, sight));
    const slope = dot(normal, direction);
    if (Math.abs(slope) < 1e-12 * dot(normal, normal) ** 0.5) return from;
    const t = dot(normal, minus(eye, from)) / slope;
    return Number.isFinite(t) ? plus(from, times(direction, t)) : from;
}

export function unitAxis(axis: Axis): Vec3 {
    return [axis === 0 ? 1 : 0, axis === 1 ? 1 : 0, axis === 2 ? 1 : 0];
}

/** Null where the axis points at the eye. */
function axisOnScreen(from: Vec3, axis: Axis, view: View): ScreenPoint | null {
    const a = view.project(from);
    if (a === null) return null;
    const step = 40 * view.worldPerPx(from);
    const b = view.project(plus(from, times(unitAxis(axis), step)));
    if (b === null) return null;
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    return length < 2 ? null : { x: (b.x - a.x) / length, y: (b.y - a.y) / length };
}
