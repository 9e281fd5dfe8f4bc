// Where on a rake a pointer is: on its curve, or on the disc of a round one.
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint, View } from '../base/view.ts';
import { curveUnder } from './rakeHandles.ts';
import { circleOf, curveOf, normalOf, type RakeShape } from './rakeShape.ts';
import { distance, dot, minus, plus, times, unit } from './vec3.ts';

/** Seen more from the edge than this, a disc is a line. */
const flattest = 0.02;

/** Null where the pointer is not on it. */
export function placeUnder(pointer: ScreenPoint, shape: RakeShape, view: View): Vec3 | null {
    const [eye, further] = view.sightLine(pointer);
    const sight = unit(minus(further, eye));
    if (curveUnder(pointer, shape, view) !== null) return nearestOfCurve(curveOf(shape), eye, sight);
    return shape.kind === 'circle' ? placeOnDisc(shape, eye, sight) : null;
}

function placeOnDisc(shape: RakeShape, eye: Vec3, sight: Vec3): Vec3 | null {
    const circle = circleOf(shape);
    const normal = normalOf(circle);
    const slope = dot(normal, sight);
    if (Math.abs(slope) < flattest) return null;
    const point = plus(eye, times(sight, dot(normal, minus(circle.centre, eye)) / slope));
    return distance(point, circle.centre) <= circle.radius ? point : null;
}

/** The point of a curve that is nearest to a line of sight. */
function nearestOfCurve(curve: readonly Vec3[], eye: Vec3, sight: Vec3): Vec3 | null {
    let nearest: Vec3 | null = null;
    let least = Number.POSITIVE_INFINITY;
    for (let i = 1; i < curve.length; ++i) {
        const point = nearestOfPiece(curve[i - 1]!, curve[i]!, eye, sight);
        const away = minus(point, eye);
        const beside = distance(away, times(sight, dot(away, sight)));
        if (beside < least) [nearest, least] = [point, beside];
    }
    return nearest;
}

function nearestOfPiece(a: Vec3, b: Vec3, eye: Vec3, sight: Vec3): Vec3 {
    const along = minus(b, a);
    const from = minus(a, eye);
    // Of both, what is across the line of sight.
    const across = minus(along, times(sight, dot(along, sight)));
    const beside = minus(from, times(sight, dot(from, sight)));
    const squared = dot(across, across);
    const part = squared > 0 ? Math.min(1, Math.max(0, -dot(beside, across) / squared)) : 0;
    return plus(a, times(along, part));
}
