// The shape of a rake: what its points mean, the curve they stand for, and what moves, turns and changes
// them. Twin of the seeding curve: core/surface/rake.cpp.
import type { RakeKind, Vec3 } from '../../protocol/messages.ts';

export interface RakeShape {
    kind: RakeKind;
    /** Line: its ends; polyline and points: in order; circle: centre and two points of the rim. */
    points: readonly Vec3[];
}

type Bounds = readonly [number, number, number, number, number, number];

const pieces = 96;

/** A circle's radius and the directions that span its plane. */
export interface Circle {
    centre: Vec3;
    radius: number;
    u: Vec3;
    v: Vec3;
}

export function circleOf({ points }: RakeShape): Circle {
    const [centre = [0, 0, 0], a = [1, 0, 0], b = [0, 1, 0]] = points;
    const u = unit(minus(a, centre));
    const toB = minus(b, centre);
    const v = unit(minus(toB, times(u, dot(u, toB))));
    // Where the points lie on a line, as they may while a user types them, any plane is as good.
    return { centre, radius: distance(a, centre), u, v: dot(v, v) > 0.5 ? v : across(u) };
}

export function circleShape({ centre, radius, u, v }: Circle): RakeShape {
    return { kind: 'circle', points: [centre, plus(centre, times(u, radius)), plus(centre, times(v, radius))] };
}

export function normalOf({ u, v }: Circle): Vec3 {
    return cross(u, v);
}

/** The curve as it is drawn: a circle in pieces, closed. */
export function curveOf(shape: RakeShape): readonly Vec3[] {
    if (shape.kind !== 'circle' || shape.points.length < 3) return shape.points;
    const { centre, radius, u, v } = circleOf(shape);
    return Array.from({ length: pieces + 1 }, (_, i) => {
        const angle = (2 * Math.PI * i) / pieces;
        return plus(centre, plus(times(u, radius * Math.cos(angle)), times(v, radius * Math.sin(angle))));
    });
}

/** Returns what the rake turns about: half-way along a line, the centre of a circle, the mean of a curve's
 *  length. */
export function middleOf({ kind, points }: RakeShape): Vec3 {
    const first = points[0] ?? [0, 0, 0];
    if (kind === 'circle') return first;
    let sum: Vec3 = [0, 0, 0];
    let length = 0;
    for (let i = 1; i < points.length; ++i) {
        const [a, b] = [points[i - 1]!, points[i]!];
        const piece = distance(a, b);
        sum = plus(sum, times(between(a, b, 0.5), piece));
        length += piece;
    }
    return length > 0 ? times(sum, 1 / length) : first;
}

/** All points moved by the same amount, so that the rake keeps its shape. */
export function translated(shape: RakeShape, by: Vec3): RakeShape {
    return { kind: shape.kind, points: shape.points.map((point) => plus(point, by)) };
}

/** Turned about its middle. */
export function turnedBy(shape: RakeShape, axis: Vec3, angle: number): RakeShape {
    const middle = middleOf(shape);
    return {
        kind: shape.kind,
        points: shape.points.map((point) => plus(middle, turned(minus(point, middle), axis, angle))),
    };
}

export function withPoint(shape: RakeShape, index: number, point: Vec3): RakeShape {
    return { kind: shape.kind, points: shape.points.map((each, i) => (i === index ? point : each)) };
}

/** A circle whose first rim point is where it is put; its plane is kept as far as that allows. */
export function resized(shape: RakeShape, rim: Vec3): RakeShape {
    const circle = circleOf(shape);
    const radius = distance(rim, circle.centre);
    if (!(radius > 0)) return shape;
    const u = times(minus(rim, circle.centre), 1 / radius);
    const inPlane = minus(circle.v, times(u, dot(u, circle.v)));
    // Dragged along its own second direction, the circle keeps its plane and turns in it.
    const v = dot(inPlane, inPlane) > 1e-6 ? unit(inPlane) : unit(cross(normalOf(circle), u));
    return circleShape({ ...circle, radius, u, v });
}

/** A circle turned about its centre the shortest way to where its second rim point lies in the direction of
 *  `towards`. */
export function tilted(shape: RakeShape, towards: Vec3): RakeShape {
    const circle = circleOf(shape);
    const to = unit(minus(towards, circle.centre));
    const axis = cross(circle.v, to);
    const sine = Math.hypot(...axis);
    if (dot(to, to) < 0.5 || sine < 1e-12) return shape;
    const angle = Math.atan2(sine, dot(circle.v, to));
    return circleShape({ ...circle, u: turned(circle.u, times(axis, 1 / sine), angle), v: to });
}

/** A circle moved, and if need be made smaller, so that it lies in the domain: the server would cut it
 *  open. */
export function fitted(shape: RakeShape, bounds: Bounds): RakeShape {
    if (shape.kind !== 'circle') return shape;
    const circle = circleOf(shape);
    const { u, v } = circle;
    const centre: Vec3 = [...circle.centre];
    let radius = circle.radius;
    const reach = ([0, 1, 2] as const).map((k) => Math.hypot(u[k], v[k]));
    const inside = 1 - 1e-9;
    reach.forEach((each, k) => {
        const half = (bounds[2 * k + 1]! - bounds[2 * k]!) / 2;
        if (each * radius > half) radius = (half / each) * inside;
    });
    for (const k of [0, 1, 2] as const) {
        const margin = reach[k]! * radius;
        centre[k] = Math.min(bounds[2 * k + 1]! - margin, Math.max(bounds[2 * k]! + margin, centre[k]));
    }
    const same = radius === circle.radius && centre.every((each, k) => each === circle.centre[k]);
    return same ? shape : circleShape({ ...circle, centre, radius });
}

/** A further point of a polyline, half-way from a point to the next; at the end, as far on as the last piece
 *  is long. */
export function withPointAfter({ points }: RakeShape, index: number): RakeShape {
    const here: Vec3 = points[index] ?? [0, 0, 0];
    const next = points[index + 1];
    const before = points[index - 1] ?? here;
    const added = next === undefined ? plus(here, minus(here, before)) : between(here, next, 0.5);
    return { kind: 'polyline', points: [...points.slice(0, index + 1), added, ...points.slice(index + 1)] };
}

/** Null where too few would be left. */
export function withoutPoint({ kind, points }: RakeShape, index: number): RakeShape | null {
    if (points.length <= 2) return null;
    return { kind, points: points.filter((_, i) => i !== index) };
}

/** Returns the same rake as another kind, in the same place; a circle stands across `flow`, as far as it can
 *  and contain the line. */
export function asKind(shape: RakeShape, kind: RakeKind, flow: Vec3): RakeShape {
    if (kind === shape.kind) return shape;
    const middle = middleOf(shape);
    if (kind === 'circle') {
        const first: Vec3 = shape.points[0] ?? middle;
        const last: Vec3 = shape.points.at(-1) ?? middle;
        const radius = Math.max(distance(first, last), distance(first, middle)) / 4;
        const along = unit(minus(last, first));
        const u = dot(along, along) > 0.5 ? along : across(flow);
        const v = unit(cross(flow, u));
        return circleShape({ centre: middle, radius, u, v: dot(v, v) > 0.5 ? v : across(u) });
    }
    const points = shape.kind === 'circle' ? diameterOf(shape) : shape.points;
    if (kind === 'line') return { kind, points: [points[0] ?? middle, points.at(-1) ?? middle] };
    const a: Vec3 = points[0] ?? middle;
    const b: Vec3 = points[1] ?? middle;
    return { kind, points: points.length > 2 ? points : [a, between(a, b, 0.5), b] };
}

function diameterOf(shape: RakeShape): Vec3[] {
    const { centre, radius, u } = circleOf(shape);
    return [plus(centre, times(u, -radius)), plus(centre, times(u, radius))];
}

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
function turned(a: Vec3, axis: Vec3, angle: number): Vec3 {
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
