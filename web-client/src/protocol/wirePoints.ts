// The points of an update: residuals of the vertices that moved or came, block by block put into the mesh as
// they are read. protocol/wire/FORMAT.md, Points. Twin: protocol/wire/wire_points.hpp.
import { type Numbers, unzigzag } from './bytes.ts';
import type { DracoPoints } from './dracoPoints.ts';
import { FrameError } from './frameError.ts';
import { maxBlockVertices } from './meshFrame.ts';
import { roomFor } from './room.ts';
import { thingsIn } from './runs.ts';
import type { TopologyEdit } from './wireEdit.ts';
import type { WireMesh } from './wireMesh.ts';
import { append, changePredictor, changeSeries, move, predictorsOf, type Series } from './wirePredict.ts';

const maxTolerance = 32767;

/** Describes what a block says of one of its channels. */
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
        this.readSort(numbers, channels, predictorsOf.moved, thingsIn(edit.movedVertices), (i, some, coding) => {
            const { predictor, residuals, scale, still } = coding;
            if (still && predictor === 0 && i > 0) return; // such a code stays as it is
            move(channels[i]!, neighbours, predictor, some, residuals, scale);
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
