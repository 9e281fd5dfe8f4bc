// Points and vectors as triples: what a rake's geometry needs of them.
import type { Vec3 } from '../../protocol/messages.ts';

export function plus(a: Vec3, b: Vec3): Vec3 {
    return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function minus(a: Vec3, b: Vec3): Vec3 {
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function times(a: Vec3, factor: number): Vec3 {
    return [a[0] * factor, a[1] * factor, a[2] * factor];
}

export function dot(a: Vec3, b: Vec3): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vec3, b: Vec3): Vec3 {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function lengthOf(a: Vec3): number {
    return Math.hypot(a[0], a[1], a[2]);
}

export function distance(a: Vec3, b: Vec3): number {
    return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Zero stays zero. */
export function unit(a: Vec3): Vec3 {
    const length = lengthOf(a);
    return length > 0 ? times(a, 1 / length) : [0, 0, 0];
}

export function between(a: Vec3, b: Vec3, part: number): Vec3 {
    return [a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part, a[2] + (b[2] - a[2]) * part];
}

/** A vector turned about an axis of length one, counterclockwise as seen from its tip (Rodrigues). */
export function turned(a: Vec3, axis: Vec3, angle: number): Vec3 {
    const along = times(axis, dot(axis, a) * (1 - Math.cos(angle)));
    const across = times(cross(axis, a), Math.sin(angle));
    return plus(plus(times(a, Math.cos(angle)), across), along);
}

/** Some direction at right angles to one of length one. */
export function across(direction: Vec3): Vec3 {
    const axes: Vec3[] = [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
    ];
    const [least = [1, 0, 0]] = axes.sort((a, b) => Math.abs(dot(a, direction)) - Math.abs(dot(b, direction)));
    return unit(minus(least, times(direction, dot(least, direction))));
}
