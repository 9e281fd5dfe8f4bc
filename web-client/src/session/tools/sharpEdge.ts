// The sharp edge of a body near a place on it: where triangles that meet are turned against each other, or where a wall ends. It leads on both
// ways from there to where it ends, turns a corner or could go on in two ways, or back to where it began.
import type { Vec3 } from '../../protocol/messages.ts';
import { cross, distance, dot, lengthOf, minus, plus, times, unit } from '../../scene/rake/rakeShape.ts';
import { alone, BodyEdges, cornerOf, several, type Triangles } from './bodyEdges.ts';
import { closestOn, mitre, type WayPoint } from './bodyWay.ts';

/** Triangles that are turned more than 30 degrees against each other meet at a sharp edge, as they are drawn. */
const sharpBelow = Math.cos(Math.PI / 6);
/** An edge goes on in one that turns from it by less than 50 degrees: others only meet it. */
const straightFrom = Math.cos((50 * Math.PI) / 180);
/** So alike is the side of the flow from edge to edge, as a cosine: a step up is not followed by one down. */
const sameSide = 0.5;
/** So many boxes of a grid high or wide at most are the steps of what is not along its axes. */
const boxesOfStep = 3;
/** A rake in a corner stands off it no more than this times as far as off its sides. */
const mostOff = 2;

/** An edge on the way along it: from place to place, and which way the flow is. */
interface Step {
    from: number;
    to: number;
    along: Vec3;
    /** Of length 1. */
    off: Vec3;
    /** What `off` is to be multiplied by to be as far from the sides as 1 is long. */
    far: number;
}

/**
 * Says in words why there is none. @param within how far from the place it may be. @param stepped the body is made of the boxes of a grid: the
 * steps between them are no sharp edges
 */
export function sharpEdgeNear(body: Triangles, near: Vec3, eye: Vec3, within: number, stepped: boolean): WayPoint[] | string {
    const edges = new BodyEdges(body);
    const isEdge = (edge: number, other?: number): boolean => isSharp(edges, edge, other) && !(stepped && isStep(edges, edge));
    const first = nearest(edges, body, near, within, isEdge);
    if (first === null) {
        return stepped
            ? 'There is no sharp edge here, only steps of the grid.'
            : 'There is no sharp edge here. Click closer to one.';
    }
    const begun = stepAlong(edges, first, edges.ends(first)[0], (inside) => seenFrom(inside, minus(eye, near)));
    const onward = chain(edges, begun, isEdge);
    const isClosed = onward.at(-1)!.to === begun.from;
    const back = isClosed
        ? []
        : chain(edges, { ...begun, from: begun.to, to: begun.from, along: times(begun.along, -1) }, isEdge);
    const before = back.slice(1).map((step): Step => ({ ...step, from: step.to, to: step.from }));
    return wayOf(edges, [...before.reverse(), ...onward], isClosed);
}

/** Whether an edge is sharp; `other` is the same as one of the triangle across, if that is known. */
type IsEdge = (edge: number, other?: number) => boolean;

function nearest(edges: BodyEdges, { positions, indices }: Triangles, near: Vec3, within: number, isEdge: IsEdge): number | null {
    let [found, least]: [number | null, number] = [null, within];
    for (let t = 0; t + 2 < indices.length; t += 3) {
        if (!edges.isThere(t) || isBeyond(positions, indices, t, near, least)) continue;
        for (let edge = t; edge < t + 3; ++edge) {
            const other = edges.across(edge);
            // From the other triangle it is the same.
            if (other > edge || !isEdge(edge, other)) continue;
            const [from, to] = edges.ends(edge);
            const apart = distance(near, closestOn(cornerOf(positions, from), cornerOf(positions, to), near));
            if (apart < least) [found, least] = [edge, apart];
        }
    }
    return found;
}

/** The box round a triangle is farther than this. */
function isBeyond(p: ArrayLike<number>, indices: ArrayLike<number>, t: number, near: Vec3, far: number): boolean {
    for (let k = 0; k < 3; ++k) {
        const [a, b, c] = [p[3 * indices[t]! + k]!, p[3 * indices[t + 1]! + k]!, p[3 * indices[t + 2]! + k]!];
        // Also where one is no number.
        if (!(Math.min(a, b, c) - far <= near[k]! && near[k]! <= Math.max(a, b, c) + far)) return true;
    }
    return false;
}

function isSharp(edges: BodyEdges, edge: number, other = edges.across(edge)): boolean {
    if (other === several) return false;
    return other === alone || -dot(edges.inside(edge), edges.inside(other)) < sharpBelow;
}

/** One of its sides is few boxes high or wide, and ends where the body turns back as much. */
function isStep(edges: BodyEdges, edge: number): boolean {
    const other = edges.across(edge);
    if (other < 0) return false;
    const between = unit(plus(edges.inside(edge), edges.inside(other)));
    return [edge, other].some((side) => {
        const ahead = edges.inside(side);
        let at: number | undefined = side;
        for (let box = 0; box < boxesOfStep && at !== undefined; ++box) {
            const end: number | undefined = acrossBox(edges, at);
            if (end === undefined || edges.across(end) < 0) return false;
            const both: [number, number] = [end, edges.across(end)];
            const [one, two] = both.map((each) => edges.inside(each)) as [Vec3, Vec3];
            if (isSharp(edges, end)) return dot(between, unit(plus(one, two))) < -sameSide;
            at = dot(one, ahead) > sameSide ? both[0] : dot(two, ahead) > sameSide ? both[1] : undefined;
        }
        return false;
    });
}

/** The edge on the other side of a box's side, whose half the triangle of an edge is. */
function acrossBox(edges: BodyEdges, edge: number): number | undefined {
    const [a, b] = edges.ends(edge).map((place) => edges.at(place)) as [Vec3, Vec3];
    const along = minus(b, a);
    const little = 0.01 * lengthOf(along);
    return edges.edgesAt(edges.opposite(edge)).find((each) => {
        const [c, d] = edges.ends(each).map((place) => edges.at(place)) as [Vec3, Vec3];
        const [first, last] = dot(along, minus(d, c)) > 0 ? [c, d] : [d, c];
        const isBeside = Math.abs(dot(along, minus(first, a))) < little * lengthOf(along);
        return isBeside && distance(minus(last, first), along) < little;
    });
}

/** @param choose returns the side of the flow, as a direction, by the directions into the triangles */
function stepAlong(edges: BodyEdges, edge: number, from: number, choose: (inside: readonly Vec3[], along: Vec3) => Vec3): Step {
    const ends = edges.ends(edge);
    const to = ends[0] === from ? ends[1] : ends[0];
    const along = unit(minus(edges.at(to), edges.at(from)));
    const other = edges.across(edge);
    const inside = [edge, ...(other === alone ? [] : [other])].map((each) => edges.inside(each));
    const towards = choose(inside, along);
    const [one, two] = inside as [Vec3, Vec3?];
    if (two === undefined) {
        const normal = unit(cross(along, one));
        return { from, to, along, off: times(normal, dot(normal, towards) < 0 ? -1 : 1), far: 1 };
    }
    const between = unit(plus(one, two));
    if (dot(between, towards) <= 0) return { from, to, along, off: times(between, -1), far: 1 };
    const far = Math.min(mostOff, 2 / lengthOf(minus(one, two)));
    return { from, to, along, off: between, far };
}

/** An edge stands out to an eye that does not look into it from between the triangles. */
function seenFrom(inside: readonly Vec3[], eye: Vec3): Vec3 {
    const [one, two] = inside as [Vec3, Vec3?];
    if (two === undefined) return eye;
    const cosine = dot(one, two);
    const [a, b] = [dot(eye, one), dot(eye, two)];
    const between = a - cosine * b > 0 && b - cosine * a > 0;
    return times(plus(one, two), between ? 1 : -1);
}

function chain(edges: BodyEdges, begun: Step, isEdge: IsEdge): Step[] {
    const steps = [begun];
    const met = new Set([begun.from, begun.to]);
    for (;;) {
        const last = steps.at(-1)!;
        const others = edges.edgesAt(last.to).filter((edge) => !edges.ends(edge).includes(last.from) && isEdge(edge));
        const on = others
            .map((edge) => stepAlong(edges, edge, last.to, () => last.off))
            .filter(({ along, off }) => dot(last.along, along) >= straightFrom && dot(last.off, off) >= sameSide);
        const [next] = on;
        if (next === undefined || on.length > 1) return steps;
        // It leads back to where it began, or never did begin there.
        if (met.has(next.to)) return next.to === begun.from ? [...steps, next] : steps;
        met.add(next.to);
        steps.push(next);
    }
}

function wayOf(edges: BodyEdges, steps: readonly Step[], isClosed: boolean): WayPoint[] {
    const pointBetween = (place: number, a: Step, b: Step): WayPoint => ({
        point: edges.at(place),
        off: times(mitre(a.off, b.off), Math.max(a.far, b.far)),
    });
    const [first, last] = [steps[0]!, steps.at(-1)!];
    return [
        pointBetween(first.from, isClosed ? last : first, first),
        ...steps.slice(1).map((step, i) => pointBetween(step.from, steps[i]!, step)),
        pointBetween(last.to, last, isClosed ? first : last),
    ];
}
