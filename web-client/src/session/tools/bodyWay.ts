// A way along a body, from a place on it to another: where a plane through both cuts its triangles; and the border of a part of it. What is
// found stands off the body by any distance. Triangles that meet have corners at the same places, not always the same ones.
import type { Vec3 } from '../../protocol/messages.ts';
import { across, cross, distance, dot, lengthOf, minus, plus, times, unit } from '../../scene/rake/rakeShape.ts';
import { alone, BodyEdges, cornerOf, type Triangles } from './bodyEdges.ts';

/** A place on a body, and which way it stands off: its length makes up for what a corner takes. */
export interface WayPoint {
    point: Vec3;
    off: Vec3;
}

/** Of one triangle, where the plane cuts it; each end is on an edge, which has a name. */
interface Cut {
    ends: readonly [Vec3, Vec3];
    edges: readonly [string, string];
    normal: Vec3;
}

/** A step of a way: through a triangle from one place to another. */
interface Piece {
    from: Vec3;
    to: Vec3;
    normal: Vec3;
}

/** Farther from the body, in parts of its size, a place is on none. */
const onBody = 1e-3;
/** Corners that stand out more than this, as the cosine between the normals, are gone round. */
const roundFrom = 0.5;

/** Whether something of the body lies there, where it is seen from an eye. */
export function liesOn(body: Triangles, at: Vec3, eye: Vec3): boolean {
    const normal = across(unit(minus(eye, at)));
    const found = nearest(cutsOf(body, normal, dot(normal, at)), at);
    return found !== null && found.apart <= onBody * sizeOf(body);
}

/**
 * Returns the shorter of the ways, on the side that `towards` points to at its beginning; null where the body has none in the plane through both
 * and `third`.
 */
export function wayAlong(body: Triangles, from: Vec3, to: Vec3, third: Vec3, towards: Vec3): WayPoint[] | null {
    const across = unit(cross(minus(to, from), minus(third, from)));
    if (lengthOf(across) === 0) return null;
    const cuts = cutsOf(body, across, dot(across, from));
    const [first, last] = [nearest(cuts, from), nearest(cuts, to)];
    if (first === null || last === null || Math.max(first.apart, last.apart) > onBody * sizeOf(body)) return null;
    if (first.cut === last.cut) return wayOf([{ from, to, normal: first.cut.normal }], across, towards);
    const beside = new Map<string, Cut[]>();
    for (const cut of cuts) for (const edge of cut.edges) beside.set(edge, [...(beside.get(edge) ?? []), cut]);
    const ways = [0, 1].flatMap((way) => walk(first.cut, last.cut, way as 0 | 1, beside, from, to) ?? []);
    const shortest = ways.sort((a, b) => a.length - b.length)[0];
    return shortest === undefined ? null : wayOf(shortest.pieces, across, towards);
}

/** Returns where it stands so far off. */
export function standOff(way: readonly WayPoint[], far: number): Vec3[] {
    return way.map(({ point, off }) => plus(point, times(off, far)));
}

/** Returns the points without those that lie within so much of a line between others (Douglas and Peucker), and at most so many. */
export function simplified(points: readonly Vec3[], within: number, most: number): Vec3[] {
    for (let slack = within; ; slack = Math.max(2 * slack, Number.EPSILON)) {
        const kept = kneesOf(points, slack);
        if (kept.length <= most) return kept;
    }
}

/**
 * Returns the longest border of some triangles, closed, on the side that `towards` points to at each place; says in words why there is none.
 * The triangles may be turned either way. @param inward it stands off as far into the triangles, too, as it does off them
 */
export function outlineOf(body: Triangles, towards: (at: Vec3) => Vec3, inward: boolean): WayPoint[] | string {
    const border = borderOf(body);
    if (border.length === 0) return 'The patch has no outline: it is closed.';
    const loop = longestLoop(border);
    if (loop.length === 0) return 'No closed outline was found.';
    const normals = loop.map(({ a, b, inside }) => cross(unit(minus(b, a)), inside));
    const way = loop.map(({ a, inside }, i): WayPoint => {
        const side = dot(normals[i]!, towards(a)) < 0 ? -1 : 1;
        const out = times(mitre(normals[i]!, normals.at(i - 1)!), side);
        return { point: a, off: inward ? plus(out, mitre(inside, loop.at(i - 1)!.inside)) : out };
    });
    return [...way, way[0]!];
}

/** An edge of one triangle only: the numbers of its ends and where they are, and the direction into the triangle. */
interface BorderEdge {
    from: number;
    to: number;
    a: Vec3;
    b: Vec3;
    inside: Vec3;
}

function borderOf(body: Triangles): BorderEdge[] {
    const edges = new BodyEdges(body);
    const border: BorderEdge[] = [];
    for (let i = 0; i < body.indices.length; ++i) {
        if (!edges.isThere(i) || edges.across(i) !== alone) continue;
        const [from, to] = edges.ends(i);
        border.push({ from, to, a: edges.at(from), b: edges.at(to), inside: edges.inside(i) });
    }
    return border;
}

/** Returns the edges in order, each from where the last one ends. Empty: nowhere do they close. */
function longestLoop(border: readonly BorderEdge[]): BorderEdge[] {
    const beside = new Map<number, BorderEdge[]>();
    const besideOf = (place: number): BorderEdge[] => beside.get(place) ?? beside.set(place, []).get(place)!;
    for (const edge of border) for (const place of [edge.from, edge.to]) besideOf(place).push(edge);
    const left = new Set(border);
    let [longest, most]: [BorderEdge[], number] = [[], 0];
    for (const { from: first } of border) {
        const path: BorderEdge[] = [];
        // Where on the path its places are.
        const met = new Map<number, number>();
        const leaving = (place: number): BorderEdge | undefined => besideOf(place).find((each) => left.has(each));
        for (let [at, edge] = [first, leaving(first)]; edge !== undefined; edge = leaving(at)) {
            left.delete(edge);
            met.set(at, path.length);
            path.push(edge.from === at ? edge : { ...edge, from: edge.to, to: edge.from, a: edge.b, b: edge.a });
            at = path.at(-1)!.to;
            const back = met.get(at);
            if (back === undefined) continue;
            const loop = path.splice(back);
            for (const { from } of loop) met.delete(from);
            const length = loop.reduce((sum, { a, b }) => sum + distance(a, b), 0);
            if (length > most) [longest, most] = [loop, length];
        }
    }
    return longest;
}

function cutsOf({ positions, indices }: Triangles, across: Vec3, at: number): Cut[] {
    const cuts: Cut[] = [];
    const beyond = (i: number): number => {
        const v = 3 * indices[i]!;
        return across[0] * positions[v]! + across[1] * positions[v + 1]! + across[2] * positions[v + 2]! - at;
    };
    for (let t = 0; t + 2 < indices.length; t += 3) {
        const off = [beyond(t), beyond(t + 1), beyond(t + 2)] as const;
        const sides = off.map((each) => each >= 0);
        if (sides[0] === sides[1] && sides[1] === sides[2]) continue;
        const corners = [0, 1, 2].map((k) => cornerOf(positions, indices[t + k]!));
        const normal = unit(cross(minus(corners[1]!, corners[0]!), minus(corners[2]!, corners[0]!)));
        if (lengthOf(normal) === 0) continue;
        const crossed = [0, 1, 2].filter((k) => sides[k] !== sides[(k + 1) % 3]);
        const [a, b] = crossed.map((k) => crossing(corners[k]!, corners[(k + 1) % 3]!, off[k]!, off[(k + 1) % 3]!));
        cuts.push({ ends: [a!.point, b!.point], edges: [a!.edge, b!.edge], normal });
    }
    return cuts;
}

/** The same from both triangles of an edge. */
function crossing(a: Vec3, b: Vec3, offA: number, offB: number): { point: Vec3; edge: string } {
    const [nameA, nameB] = [a.join(), b.join()];
    if (nameA > nameB) return crossing(b, a, offB, offA);
    return { point: plus(a, times(minus(b, a), offA / (offA - offB))), edge: `${nameA} ${nameB}` };
}

function nearest(cuts: readonly Cut[], to: Vec3): { cut: Cut; apart: number } | null {
    let found: { cut: Cut; apart: number } | null = null;
    for (const cut of cuts) {
        const apart = distance(to, closestOn(cut.ends[0], cut.ends[1], to));
        if (found === null || apart < found.apart) found = { cut, apart };
    }
    return found;
}

export function closestOn(a: Vec3, b: Vec3, to: Vec3): Vec3 {
    const along = minus(b, a);
    const square = dot(along, along);
    const part = square > 0 ? Math.min(1, Math.max(0, dot(minus(to, a), along) / square)) : 0;
    return plus(a, times(along, part));
}

/** Null where it comes to a border, or back. */
function walk(
    first: Cut,
    last: Cut,
    way: 0 | 1,
    beside: ReadonlyMap<string, readonly Cut[]>,
    from: Vec3,
    to: Vec3,
): { pieces: Piece[]; length: number } | null {
    const pieces: Piece[] = [];
    let [cut, at, out]: [Cut, Vec3, 0 | 1] = [first, from, way];
    let length = 0;
    const add = (next: Vec3): void => {
        if (distance(at, next) > 0) pieces.push({ from: at, to: next, normal: cut.normal });
        length += distance(at, next);
        at = next;
    };
    for (let step = 0; step <= beside.size; ++step) {
        add(cut.ends[out]);
        const edge = cut.edges[out];
        const both = beside.get(edge)!;
        if (both.length !== 2) return null;
        cut = both[0] === cut ? both[1]! : both[0]!;
        if (cut === first) return null;
        out = cut.edges[0] === edge ? 1 : 0;
        if (cut === last) {
            add(to);
            return { pieces, length };
        }
    }
    return null;
}

/** Whichever way the triangles are turned, the normals are all on one side of the way in its plane. */
function wayOf(pieces: readonly Piece[], across: Vec3, towards: Vec3): WayPoint[] {
    const left = ({ from, to, normal }: Piece): Vec3 =>
        dot(normal, cross(across, minus(to, from))) < 0 ? times(normal, -1) : normal;
    const side = dot(left(pieces[0]!), towards) < 0 ? -1 : 1;
    const normals = pieces.map((each) => times(left(each), side));
    const way: WayPoint[] = [{ point: pieces[0]!.from, off: normals[0]! }];
    pieces.forEach(({ from, to }, i) => {
        const [here, next] = [normals[i]!, normals[i + 1]];
        if (next === undefined) {
            way.push({ point: to, off: here });
            return;
        }
        const after = minus(pieces[i + 1]!.to, to);
        if (dot(here, next) < roundFrom && dot(after, here) < 0) {
            const tip = unit(minus(unit(minus(to, from)), unit(after)));
            way.push(...[here, tip, next].map((off) => ({ point: to, off })));
        } else way.push({ point: to, off: mitre(here, next) });
    });
    return way;
}

/** Is as far from both planes as 1 is long, but in the sharpest corners. */
export function mitre(a: Vec3, b: Vec3): Vec3 {
    return times(plus(a, b), 1 / Math.max(1 + dot(a, b), roundFrom));
}

function kneesOf(points: readonly Vec3[], within: number): Vec3[] {
    const kept = new Set([0, points.length - 1]);
    const spans: [number, number][] = [[0, points.length - 1]];
    for (let span = spans.pop(); span !== undefined; span = spans.pop()) {
        const [from, to] = span;
        let [far, at] = [within, -1];
        for (let i = from + 1; i < to; ++i) {
            const apart = distance(points[i]!, closestOn(points[from]!, points[to]!, points[i]!));
            if (apart > far) [far, at] = [apart, i];
        }
        if (at < 0) continue;
        kept.add(at);
        spans.push([from, at], [at, to]);
    }
    return points.filter((_, i) => kept.has(i));
}

function sizeOf({ positions }: Triangles): number {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < positions.length; ++i) {
        low[i % 3] = Math.min(low[i % 3]!, positions[i]!);
        high[i % 3] = Math.max(high[i % 3]!, positions[i]!);
    }
    return Math.hypot(...low.map((each, k) => high[k]! - each));
}
