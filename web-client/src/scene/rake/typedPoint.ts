// A coordinate of a rake that is typed. One outside the domain stops at its edge alone: the other coordinates
// stay, where a rake that is clipped would move along itself.
import { rounding } from '../base/rounding.ts';
import type { Bounds } from '../domain/domainAxes.ts';
import { gripOf, type Handle } from './rakeHandles.ts';
import { movedHandle } from './rakeInteraction.ts';
import { fitted, type RakeShape } from './rakeShape.ts';
import type { Axis } from './snapping.ts';

export interface TypedPoint {
    shape: RakeShape;
    /** Where the coordinate is now, if that is not what was typed. */
    stoppedAt: number | null;
}

export function withCoordinate(shape: RakeShape, handle: Handle, axis: Axis, typed: number, bounds: Bounds): TypedPoint {
    const moved = movedTo(shape, handle, axis, typed, bounds);
    const at = coordinateOf(moved, handle, axis);
    const slack = rounding(bounds[2 * axis]!, bounds[2 * axis + 1]!);
    return { shape: moved, stoppedAt: Math.abs(at - typed) > slack ? at : null };
}

function movedTo(shape: RakeShape, handle: Handle, axis: Axis, typed: number, bounds: Bounds): RakeShape {
    const [low, high] = [bounds[2 * axis]!, bounds[2 * axis + 1]!];
    const kept = Math.min(high, Math.max(low, typed));
    if (shape.kind !== 'circle' && typeof handle === 'number') {
        // As typed, not as before plus the difference.
        const points = shape.points.map((point, i) => (i === handle ? (point.with(axis, kept) as typeof point) : point));
        return { kind: shape.kind, points };
    }
    const before = coordinateOf(shape, handle, axis);
    let by = kept - before;
    if (shape.kind !== 'circle') {
        // The whole rake moves, as far as all of it stays inside.
        const along = shape.points.map((point) => point[axis]);
        by = Math.max(Math.min(0, low - Math.min(...along)), Math.min(Math.max(0, high - Math.max(...along)), by));
    }
    const shift: [number, number, number] = [0, 0, 0];
    shift[axis] = by;
    return fitted(movedHandle(shape, handle, shift), bounds);
}

function coordinateOf(shape: RakeShape, handle: Handle, axis: Axis): number {
    return (typeof handle === 'number' ? shape.points[handle] : gripOf(shape))?.[axis] ?? 0;
}
