// Which handles a rake has, where they are, and which of them is under the pointer.
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint, View } from '../base/view.ts';
import { between, curveOf, middleOf, plus, type RakeShape, times } from './rakeShape.ts';

/** Index of a point of the rake, the handle that moves all of them, or the one that turns them about their
 *  middle. */
export type Handle = number | 'middle' | 'rotate';

export interface PlacedHandle {
    handle: Handle;
    at: Vec3;
}

/** A finger is some 44 px wide (WCAG 2.5.5). */
export const hitRadiusPx = 22;
const lineHitPx = 10;
const stemPx = 52;
const longerStemsPx = [1, 1.5, 2].map((times) => times * stemPx);
/** With more points a handle for each would hide the rake. */
const maxPointHandles = 48;

export function hasPointHandles({ kind, points }: RakeShape): boolean {
    return kind !== 'points' && points.length <= maxPointHandles;
}

/** Those of points first. */
export function handlesOf(shape: RakeShape): Handle[] {
    const { kind, points } = shape;
    if (points.length < 2) return [];
    const ofPoints = hasPointHandles(shape) ? [...points.keys()] : [];
    // A circle's first point is its middle.
    return [...(kind === 'circle' ? ofPoints.slice(1) : ofPoints), 'middle', 'rotate'];
}

/** Returns the place of the handle that moves all: on the rake and, of a polyline, on none of its points. */
export function gripOf(shape: RakeShape): Vec3 {
    const { kind, points } = shape;
    if (kind !== 'polyline') return middleOf(shape);
    const i = Math.floor((points.length - 1) / 2);
    return between(points[i] ?? [0, 0, 0], points[i + 1] ?? points[i] ?? [0, 0, 0], 0.5);
}

export function positionOf(handle: Handle, shape: RakeShape, view: View): Vec3 {
    if (handle === 'middle') return gripOf(shape);
    if (handle === 'rotate') return stemEnd(shape, view);
    return shape.points[handle] ?? [0, 0, 0];
}

/** The end of a stem of constant length on the screen that stands off the rake's middle at right angles to
 *  it. */
function stemEnd(shape: RakeShape, view: View): Vec3 {
    const middle = middleOf(shape);
    const at = view.project(middle);
    if (at === null) return middle;
    const { x, y } = stemDirection(shape, view);
    const end = (length: number): ScreenPoint => ({ x: at.x + length * x, y: at.y + length * y });
    const points = hasPointHandles(shape) ? shape.points.map((point) => view.project(point)) : [];
    // Of a rake that is short on the screen, or seen along itself, beyond its points.
    const isClear = (length: number): boolean =>
        points.every((each) => each === null || Math.hypot(each.x - end(length).x, each.y - end(length).y) > hitRadiusPx);
    const isInside = (length: number): boolean => {
        const { x: across, y: down } = end(length);
        return Math.min(across, down, view.size.width - across, view.size.height - down) > hitRadiusPx;
    };
    const lengths = longerStemsPx.filter(isClear);
    // On the other side where it would be outside of a narrow picture.
    const length = lengths.find(isInside) ?? lengths.map((each) => -each).find(isInside) ?? lengths[0] ?? stemPx;
    return view.pointAtDepth(end(length), middle);
}

/** A circle's stem goes away from the rim's handles, where there is room. */
function stemDirection(shape: RakeShape, view: View): ScreenPoint {
    const { kind, points } = shape;
    const [from, to] = [view.project(points[0]!), view.project(points[kind === 'circle' ? 1 : points.length - 1]!)];
    if (from === null || to === null) return { x: 0, y: -1 };
    const along = { x: to.x - from.x, y: to.y - from.y };
    const length = Math.hypot(along.x, along.y);
    if (length < 1) return { x: 0, y: -1 };
    if (kind === 'circle') return { x: -along.x / length, y: -along.y / length };
    return { x: along.y / length, y: -along.x / length };
}

export function placedHandles(shape: RakeShape, view: View): PlacedHandle[] {
    return handlesOf(shape).map((handle) => ({ handle, at: positionOf(handle, shape, view) }));
}

/** The handle under a canvas position; the nearest one where their areas overlap. */
export function handleUnder(pointer: ScreenPoint, shape: RakeShape, view: View): Handle | null {
    let nearest: Handle | null = null;
    let nearestPx = hitRadiusPx;
    for (const { handle, at } of placedHandles(shape, view)) {
        const seen = view.project(at);
        if (seen === null) continue;
        const px = Math.hypot(seen.x - pointer.x, seen.y - pointer.y);
        if (px > nearestPx) continue;
        nearest = handle;
        nearestPx = px;
    }
    return nearest;
}

/** Returns how far a rake's curve is from a canvas position, in pixels; null where that is too far for a
 *  click to mean it. */
export function curveUnder(pointer: ScreenPoint, shape: RakeShape, view: View): number | null {
    let nearest = lineHitPx;
    let found = false;
    let before: ScreenPoint | null = null;
    for (const point of curveOf(shape)) {
        const at = view.project(point);
        if (at !== null && before !== null) {
            const px = distanceToSegment(pointer, before, at);
            if (px <= nearest) [nearest, found] = [px, true];
        }
        before = at;
    }
    return found ? nearest : null;
}

function distanceToSegment(p: ScreenPoint, a: ScreenPoint, b: ScreenPoint): number {
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    const squared = dx * dx + dy * dy;
    const along = squared === 0 ? 0 : ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared;
    const part = Math.min(1, Math.max(0, along));
    return Math.hypot(p.x - a.x - part * dx, p.y - a.y - part * dy);
}

/** Where a label for the rake goes: over its highest end as seen. */
export function labelPlace(shape: RakeShape, view: View): ScreenPoint | null {
    let highest: ScreenPoint | null = null;
    for (const point of [shape.points[0], shape.points.at(-1)]) {
        const at = point === undefined ? null : view.project(point);
        if (at !== null && (highest === null || at.y < highest.y)) highest = at;
    }
    return highest;
}

/** The two ends of the line through a point along an axis, at the walls of the domain. */
export function axisLine(through: Vec3, axis: 0 | 1 | 2, bounds: readonly number[]): [Vec3, Vec3] {
    const direction: Vec3 = [0, 0, 0];
    direction[axis] = 1;
    const end = (wall: number): Vec3 => plus(through, times(direction, wall - through[axis]));
    return [end(bounds[2 * axis] ?? 0), end(bounds[2 * axis + 1] ?? 0)];
}
