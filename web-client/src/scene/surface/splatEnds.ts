// Where discs end: at the border of the surface, by lines in the plane of each. A vertex on the border has two
// through its middle; one more may pass beside it, of a side opposite to it, or where a triangle is cut.
import { borderOf, cutLevel } from '../../mesh/meshChange.ts';

export interface SplatSurface {
    positions: Float32Array;
    normals: Float32Array;
    indices: Uint32Array;
    vertices: number;
}

/** Half axes, xyz a disc. */
export interface SplatAxes {
    u: Float32Array;
    v: Float32Array;
}

export interface SplatEnds {
    /** Four a disc, of the lines through its middle: directions into the surface, in the frame in which the
     *  disc is the circle of radius 1; 0: none. */
    through: Float32Array;
    /** Four a disc, of the line beside: its direction, how far away it is, and 1 where the surface is what
     *  either of the lines through the middle leaves, 0 where both do. */
    beside: Float32Array;
}

/** Discs go so far beyond their lines, so that rounding leaves no pixels open: a part of their radius. */
export const endSlack = 0.004;

type Point = readonly [number, number, number];

/** @param levels  where triangles are cut: meshChange.ts; null: nowhere */
export function splatEnds(surface: SplatSurface, axes: SplatAxes, levels: ArrayLike<number> | null): SplatEnds {
    const { indices, vertices } = surface;
    const ends = new Ends(surface, axes);
    const border = borderOf((use) => {
        for (let i = 0; i < indices.length; ++i) use(indices[i]!, indices[next(i)]!);
    }, vertices);
    /** Where in the indices a side begins that one triangle has so far. */
    const open = new Map<number, number>();
    for (let i = 0; i < indices.length; ++i) {
        const [from, to] = [indices[i]!, indices[next(i)]!];
        if (border[from] === 0 || border[to] === 0) continue;
        const side = Math.min(from, to) * vertices + Math.max(from, to);
        if (open.has(side)) open.delete(side);
        else open.set(side, i);
    }
    for (const i of open.values()) ends.addSide(indices[i]!, indices[next(i)]!, indices[next(next(i))]!);
    if (levels !== null) for (let i = 0; i < indices.length; i += 3) ends.addCut(indices.subarray(i, i + 3), levels);
    return ends.found();
}

function next(i: number): number {
    return i % 3 === 2 ? i - 2 : i + 1;
}

class Ends {
    private readonly surface: SplatSurface;
    private readonly axes: SplatAxes;
    private readonly beside: Float32Array;
    /** Of each vertex on the border, by the lines through it: the other end of the side, and the line. */
    private readonly sides = new Map<number, { to: number; line: readonly [number, number, number] }[]>();

    constructor(surface: SplatSurface, axes: SplatAxes) {
        [this.surface, this.axes] = [surface, axes];
        this.beside = new Float32Array(4 * surface.vertices);
        for (let v = 0; v < surface.vertices; ++v) this.beside[4 * v + 2] = 1;
    }

    /** A side on the border, and the third corner of its triangle. */
    addSide(a: number, b: number, inner: number): void {
        const inwards = this.inwards(this.at(a), this.at(b), this.at(inner));
        for (const [v, to] of [
            [a, b],
            [b, a],
        ] as const) {
            const known = this.sides.get(v) ?? [];
            known.push({ to, line: this.onDisc(v, inwards) });
            this.sides.set(v, known);
        }
        this.addBeside(inner, this.at(a), inwards);
    }

    /** A triangle of which a part is drawn: it ends where levels between its corners pass the one of cuts. */
    addCut(corners: Uint32Array, levels: ArrayLike<number>): void {
        const over = [...corners].filter((v) => levels[v]! > cutLevel);
        if (over.length === 0 || over.length === 3) return;
        const apex = over.length === 1 ? over[0]! : [...corners].find((v) => levels[v]! <= cutLevel)!;
        const [p, q] = [...corners]
            .filter((v) => v !== apex)
            .map((v) => {
                const part = (cutLevel + 0.5 - levels[apex]!) / (levels[v]! - levels[apex]!);
                return along(this.at(apex), part, difference(this.at(v), this.at(apex)));
            });
        const towards = this.inwards(p!, q!, this.at(apex));
        const inwards = over.length === 1 ? along([0, 0, 0], -1, towards) : towards;
        for (const v of corners) this.addBeside(v, p!, inwards);
    }

    found(): SplatEnds {
        const through = new Float32Array(4 * this.surface.vertices);
        for (const [v, sides] of this.sides) {
            const [first, second] = sides;
            // Parts that meet in one vertex have more: their discs stay whole.
            if (sides.length !== 2 || first === undefined || second === undefined) continue;
            through.set([first.line[0], first.line[1], second.line[0], second.line[1]], 4 * v);
            const toSecond = this.onDisc(v, difference(this.at(second.to), this.at(v)), true);
            if (toSecond[0] * first.line[0] + toSecond[1] * first.line[1] < 0) this.beside[4 * v + 3] = 1;
        }
        return { through, beside: this.beside };
    }

    /** Keeps the line that leaves least of the disc. */
    private addBeside(v: number, on: Point, inwards: Point): void {
        const [x, y, length] = this.onDisc(v, inwards);
        if (length === 0) return;
        const away = dot(difference(this.at(v), on), inwards) / length;
        if (away < this.beside[4 * v + 2]!) this.beside.set([x, y, away], 4 * v);
    }

    /** Across p to q, towards a third point. */
    private inwards(p: Point, q: Point, towards: Point): Point {
        const side = difference(q, p);
        const squared = dot(side, side);
        const way = difference(towards, p);
        return squared > 0 ? along(way, -dot(way, side) / squared, side) : way;
    }

    private at(v: number): Point {
        const { positions } = this.surface;
        return [positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!];
    }

    /** The direction of a line's normal in the frame of a disc, of length 1, and its length there; or that of a
     *  point. */
    private onDisc(v: number, way: Point, ofPoint = false): [number, number, number] {
        const [x, y] = [this.axes.u, this.axes.v].map((axis) => {
            const half: Point = [axis[3 * v]!, axis[3 * v + 1]!, axis[3 * v + 2]!];
            const size = dot(half, half);
            return dot(way, half) / (ofPoint && size > 0 ? size : 1);
        }) as [number, number];
        const length = Math.hypot(x, y);
        return length > 0 ? [x / length, y / length, length] : [0, 0, 0];
    }
}

function difference(a: Point, b: Point): Point {
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function along(from: Point, part: number, way: Point): Point {
    return [from[0] + part * way[0], from[1] + part * way[1], from[2] + part * way[2]];
}

function dot(a: Point, b: Point): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
