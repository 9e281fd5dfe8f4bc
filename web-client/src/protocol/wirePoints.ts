// The points of an update: the predictors, which are what both ends expect of a vertex, and the residuals of the vertices that moved or
// came, put into the mesh block by block as they are read. protocol/wire/FORMAT.md, Points. Twins: protocol/wire/wire_points.hpp,
// wire_residuals.hpp. Sums are exact in double precision and cut to 32 bits once, which is to wrap.
import { FrameError, type Numbers, thingsIn, unzigzag } from './bytes.ts';
import type { DracoPoints } from './dracoPoints.ts';
import { maxBlockVertices } from './meshFrame.ts';
import type { TopologyEdit } from './wireEdit.ts';
import { type Neighbours, none, roomFor, type WireMesh } from './wireMesh.ts';

const maxTolerance = 32767;

/** What a block says of one of its channels. */
interface Coding {
    predictor: number;
    scale: number; // what a residual of 1 stands for
    residuals: Int32Array;
    still: boolean; // all residuals are 0
}

export class PointsReader {
    private readonly draco: DracoPoints;
    private readonly rooms: Int32Array[] = []; // for residuals, a channel each
    private rest: Uint8Array = new Uint8Array(0); // of the Draco blocks

    constructor(draco: DracoPoints) {
        this.draco = draco;
    }

    /** All points of an update whose topology has been applied to the mesh. Throws FrameError; the mesh is
     *  then unusable. */
    read(mesh: WireMesh, edit: TopologyEdit, numbers: Numbers): void {
        const { neighbours, vertices } = mesh;
        const stayed = vertices - edit.addedVertices;
        this.rest = numbers.rest;
        const channels: Series[] = [mesh.position, ...mesh.codes];
        this.readSort(numbers, channels, predictorsOf.moved, thingsIn(edit.movedVertices), (i, block, coding) => {
            const { predictor, residuals, scale, still } = coding;
            if (still && predictor === 0 && i > 0) return; // such a code stays as it is
            move(channels[i]!, neighbours, predictor, block, residuals, scale);
        });
        channels.push(changeSeries(mesh.position));
        const added = thingsIn({ all: [{ begin: stayed, end: vertices }], count: edit.addedVertices });
        this.readSort(numbers, channels, predictorsOf.appended, added, (i, some, { predictor, residuals, scale }) => {
            append(channels[i]!, neighbours, predictor, some, residuals, scale, stayed);
        });
        if (numbers.left > 0 || this.rest.length > 0) throw new FrameError('a mesh update goes on after its last vertex');
    }

    private readSort(
        numbers: Numbers,
        channels: readonly Series[],
        predictors: number,
        vertices: Int32Array,
        apply: (channel: number, vertices: Int32Array, coding: Coding) => void,
    ): void {
        for (let at = 0; at < vertices.length;) {
            const count = numbers.next(Math.min(vertices.length - at, maxBlockVertices));
            if (count === 0) throw new FrameError('a mesh update holds a block without vertices');
            const some = vertices.subarray(at, (at += count));
            this.readBlock(numbers, channels, predictors, count).forEach((coding, i) => apply(i, some, coding));
        }
    }

    private readBlock(numbers: Numbers, channels: readonly Series[], predictors: number, count: number): Coding[] {
        const bits = numbers.next(2 ** channels.length - 1);
        const codings = channels.map(({ components, isChange }, i): Coding => {
            const room = roomFor(this.rooms[i] ?? new Int32Array(0), count * components);
            this.rooms[i] = room;
            const predictor = isChange === true ? changePredictor : numbers.next(predictors - 1);
            const scale = isChange === true ? 1 : 2 * numbers.next(maxTolerance) + 1;
            const residuals = room.subarray(0, count * components).fill(0);
            return { predictor, scale, residuals, still: (bits & (1 << i)) === 0 };
        });
        const escapes = numbers.next(count);
        const length = channels.reduce((sum, { components }) => sum + components, 0);
        const escaped = numbers.take(escapes * (length + 1));
        const bytes = bits === 0 ? 0 : numbers.next(this.rest.length);
        const coded = channels.flatMap(({ components }, i) => (codings[i]!.still ? [] : [{ i, components }]));
        if (coded.length > 0) {
            const components = coded.map((channel) => channel.components);
            const into = coded.map(({ i }) => codings[i]!.residuals);
            this.draco.decode(this.rest.subarray(0, bytes), count, components, into);
        }
        this.rest = this.rest.subarray(bytes);
        for (let at = 0, vertex = 0; at < escaped.length; ++vertex) {
            vertex += escaped[at++]!;
            if (vertex >= count) throw new FrameError('a mesh update holds a residual of a vertex that is not in its block');
            for (const [i, { components: n }] of channels.entries()) {
                for (let k = 0; k < n; ++k) codings[i]!.residuals[n * vertex + k] = unzigzag(escaped[at++]!);
            }
        }
        if (escapes > 0) for (const coding of codings) coding.still = false;
        return codings;
    }
}

const predictorsOf = { moved: 4, appended: 6 } as const;
/** Predicts the changes of appended vertices. */
const changePredictor = 4;

const largestChange = 1 << 20;

/** What is predicted: the positions, the codes of an attribute, or the changes of appended
 *  vertices. */
export interface Series {
    components: number;
    first: number; // values are first .. last
    last: number;
    values: Int32Array; // x
    change: Int32Array; // d, by this update
    changeBefore: Int32Array; // h; empty where it counts as 0
    isChange?: boolean;
}

function changeSeries({ change }: { change: Int32Array }): Series {
    const range = { first: -largestChange, last: largestChange };
    return { components: 3, ...range, values: change, change, changeBefore: change, isChange: true };
}

function clamp(value: number, first: number, last: number): number {
    const wrapped = value | 0;
    return wrapped < first ? first : wrapped > last ? last : wrapped;
}

/** Vertices that moved; each residual in `r` counts `scale`. */
function move(series: Series, near: Neighbours, predictor: number, vertices: Int32Array, r: Int32Array, scale: number): void {
    const { components: n, first, last, values: x, change: d, changeBefore: h } = series;
    const { highest, lowest, beside, beside2, opposite } = near;
    const remembers = h.length > 0;
    for (let j = 0, next = 0; j < vertices.length; ++j) {
        const v = vertices[j]!;
        const i = n * v;
        const a = n * highest[v]!;
        const b = n * lowest[v]!;
        const p = n * beside[v]!;
        const q = n * beside2[v]!;
        const o = n * opposite[v]!;
        for (let k = 0; k < n; ++k, ++next) {
            let change: number;
            if (a < 0 || predictor === 0) change = remembers ? h[i + k]! : 0;
            else if (predictor === 3 && o >= 0) change = (d[p + k]! + d[q + k]! - d[o + k]!) | 0;
            else if (predictor === 2 && remembers) change = h[i + k]! + ((d[a + k]! - h[a + k]! + d[b + k]! - h[b + k]!) >> 1);
            else change = (d[a + k]! + d[b + k]!) >> 1;
            const before = x[i + k]!;
            const after = clamp(before + change + Math.imul(r[next]!, scale), first, last);
            x[i + k] = after;
            d[i + k] = after - before;
        }
    }
}

/** Appended vertices; the first `stayed` of the mesh were there before the update. */
function append(
    { components: n, first, last, values: x, change: d }: Series,
    { highest, lowest, beside, beside2, opposite }: Neighbours,
    predictor: number,
    vertices: Int32Array,
    r: Int32Array,
    scale: number,
    stayed: number,
): void {
    for (let j = 0, next = 0; j < vertices.length; ++j) {
        const v = vertices[j]!;
        let p = highest[v]!;
        let q = p;
        let o = none;
        let isOld = false;
        if (p < 0) p = q = v - 1;
        else if (predictor === 1) p = q = lowest[v]!;
        else if (predictor === 2) o = highest[p]!;
        else if (predictor === 3 && beside[v]! >= 0) [p, q, o] = [beside[v]!, beside2[v]!, opposite[v]!];
        else if (predictor === 4) q = lowest[v]!;
        else if (predictor === 5 && lowest[v]! < stayed) [p, isOld] = [lowest[v]!, true];
        for (let k = 0; k < n; ++k, ++next) {
            let expected = 0;
            if (p < 0) expected = 0;
            else if (isOld) expected = x[n * p + k]! - d[n * p + k]!;
            else if (o < 0) expected = (x[n * p + k]! + x[n * q + k]!) >> 1;
            else expected = x[n * p + k]! + x[n * q + k]! - x[n * o + k]!;
            x[n * v + k] = clamp(expected + Math.imul(r[next]!, scale), first, last);
        }
    }
}
