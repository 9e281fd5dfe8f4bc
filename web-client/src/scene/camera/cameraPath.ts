// A path of the camera through poses that were kept, for films: smooth, at each pose when its turn comes. What is looked at goes on a curve
// through the targets; the camera goes round it, its direction and the logarithm of its distance each on such a curve, so that a turn about
// a body keeps its distance instead of cutting through.
import type { Vec3 } from '../../protocol/messages.ts';
import { cross, dot, lengthOf, minus, plus, times, unit } from '../rake/rakeShape.ts';
import type { CameraPose } from './cameraControls.ts';

/** @param part from 0, the first pose, to 1, the last one. REQUIRES: at least one pose */
export function poseAlong(poses: readonly CameraPose[], part: number): CameraPose {
    const last = poses.length - 1;
    const at = Math.min(1, Math.max(0, part)) * last;
    const from = Math.min(Math.floor(at), Math.max(0, last - 1));
    const t = at - from;
    const pose = (i: number): CameraPose => poses[Math.min(last, Math.max(0, i))]!;
    const four = [pose(from - 1), pose(from), pose(from + 1), pose(from + 2)] as const;
    const offsets = four.map(({ position, target }) => minus(position, target)) as [Vec3, Vec3, Vec3, Vec3];
    const target = curve(four.map((each) => each.target) as typeof offsets, t);
    const [distance] = curve(offsets.map((each) => [Math.log(lengthOf(each)), 0, 0]) as typeof offsets, t);
    const direction = turn(offsets.map(unit) as typeof offsets, t);
    // Perspective cannot change bit by bit.
    return {
        position: plus(target, times(direction, Math.exp(distance))),
        target,
        orthographic: pose(Math.floor(at)).orthographic,
    };
}

/** A Catmull-Rom curve from the second of four points to the third. */
function curve([before, a, b, after]: readonly [Vec3, Vec3, Vec3, Vec3], t: number): Vec3 {
    const [p, q] = [times(minus(b, before), 0.5), times(minus(after, a), 0.5)];
    const [u, v] = [t * t * t, t * t];
    const ends = plus(times(a, 2 * u - 3 * v + 1), times(b, -2 * u + 3 * v));
    return plus(ends, plus(times(p, u - 2 * v + t), times(q, u - v)));
}

/** The same of directions; where the curve comes near the middle of the sphere, as between opposite ones, round it by an axis. */
function turn(four: readonly [Vec3, Vec3, Vec3, Vec3], t: number): Vec3 {
    const [, a, b] = four;
    if (dot(a, b) > -0.5) return unit(curve(four, t));
    // More than two thirds of half a turn: the arc, beginning and ending slowly.
    const angle = Math.acos(Math.max(-1, dot(a, b)));
    const across = cross(a, b);
    const axis = lengthOf(across) > 1e-6 ? unit(across) : unit(cross(a, Math.abs(a[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
    const eased = t * t * (3 - 2 * t) * angle;
    const side = cross(axis, a);
    return unit(plus(times(a, Math.cos(eased)), times(side, Math.sin(eased))));
}
