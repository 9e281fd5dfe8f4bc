// The point blocks of an update: residuals of the vertices that moved or came, put into the mesh as they are read.
// protocol/wire/README.md, Points. Twin: protocol/wire/wire_points.hpp.
import { ByteReader } from './bytes.ts';
import type { DracoPoints } from './dracoPoints.ts';
import { FrameError } from './frameError.ts';
import { roomFor } from './room.ts';
import type { Run } from './runs.ts';
import type { TopologyEdit } from './wireEdit.ts';
import type { Channel, WireMesh } from './wireMesh.ts';
import { append, appendPredictors, assumeChanges, changePredictor, move, movePredictors, takeChanges } from './wirePredict.ts';

export const maxFrameVertices = 1 << 16;

const maxTolerance = 32767;

/** What the vertices of a block are. */
const kinds = { moved: 0, appended: 1, changes: 2 } as const;

interface Block {
    kind: number;
    count: number;
    coded: boolean[]; // by channel: the position or change, then the attributes
    predictors: number[];
    scales: number[]; // what a residual of 1 stands for
    still: boolean[]; // by channel: a code that stays as it is
}

/** Vertices of one kind that have not come yet, in order. */
class Expected {
    private readonly runs: readonly Run[];
    private run = 0;
    private at: number;
    left: number;

    constructor(runs: readonly Run[]) {
        this.runs = runs;
        this.at = runs[0]?.begin ?? 0;
        this.left = runs.reduce((sum, { begin, end }) => sum + end - begin, 0);
    }

    /** The next `count`, at most `left`, piece by piece: `take(from, to, how many before)`. */
    next(count: number, take: (from: number, to: number, done: number) => void): void {
        this.left -= count;
        for (let done = 0; done < count;) {
            const { end } = this.runs[this.run]!;
            const to = Math.min(end, this.at + count - done);
            take(this.at, to, done);
            done += to - this.at;
            this.at = to;
            if (to === end) {
                ++this.run;
                this.at = this.runs[this.run]?.begin ?? 0;
            }
        }
    }
}

/** Room for the residuals of one block, kept because it is needed for each. */
class ResidualRoom {
    private room: Int32Array[] = [];

    of(channel: number, numbers: number): Int32Array {
        this.room[channel] = roomFor(this.room[channel] ?? new Int32Array(0), numbers);
        return this.room[channel].subarray(0, numbers);
    }
}

export class PointsReader {
    private readonly draco: DracoPoints;
    private readonly room = new ResidualRoom();
    private mesh!: WireMesh;
    private channels: readonly Channel[] = [];
    private expected: readonly Expected[] = [];
    private stayed = 0;

    constructor(draco: DracoPoints) {
        this.draco = draco;
    }

    /** The topology has been applied to the mesh; what comes is the points of the same update. */
    begin(mesh: WireMesh, edit: TopologyEdit, hasHistory: boolean): void {
        this.mesh = mesh;
        this.channels = [mesh.position, ...mesh.codes];
        this.stayed = mesh.vertices - edit.addedVertices;
        const appended = { begin: this.stayed, end: mesh.vertices };
        const filled = (run: Run): Run[] => (run.end > run.begin ? [run] : []);
        this.expected = [
            new Expected(edit.movedVertices.all),
            new Expected(filled(appended)),
            new Expected(hasHistory ? filled({ begin: 0, end: mesh.vertices }) : []),
        ];
    }

    /** All blocks of one frame. Throws FrameError; the mesh is then unusable. */
    take(bytes: Uint8Array): void {
        const reader = new ByteReader(bytes);
        let vertices = 0;
        while (!reader.atEnd) {
            const block = this.readBlock(reader);
            vertices += block.count;
            if (vertices > maxFrameVertices) throw new FrameError('a mesh frame holds too many vertices');
            const escapes = this.readResiduals(reader, block);
            block.still = block.coded.map((coded, i) => {
                const unmoved = block.kind === kinds.moved && i > 0 && block.predictors[i] === 0;
                return unmoved && !coded && escapes === 0;
            });
            this.apply(block);
        }
    }

    /** Throws FrameError unless everything has come. */
    finish(): void {
        if (this.expected.some(({ left }) => left > 0)) throw new FrameError('a mesh update ends before its last vertex');
        if (this.stayed > 0) assumeChanges(this.mesh.position.change, this.mesh.neighbours, this.stayed, this.mesh.vertices);
    }

    private readBlock(reader: ByteReader): Block {
        const kind = reader.byte();
        const count = reader.varint();
        const channels = reader.byte();
        const used = kind === kinds.changes ? 1 : this.channels.length;
        const current = this.expected.findIndex(({ left }) => left > 0);
        if (kind !== current || count === 0 || count > this.expected[kind]!.left || count > maxFrameVertices) {
            throw new FrameError('a mesh frame holds other vertices than those that are expected');
        }
        if (channels >= 1 << used) throw new FrameError('a mesh frame holds attributes that were not announced');
        const indices = Array.from({ length: used }, (_, i) => i);
        const predictors = indices.map(() => this.readPredictor(reader, kind));
        const scales = indices.map(() => (kind === kinds.changes ? 1 : readScale(reader)));
        return { kind, count, coded: indices.map((i) => (channels & (1 << i)) !== 0), predictors, scales, still: [] };
    }

    private readPredictor(reader: ByteReader, kind: number): number {
        const predictor = reader.byte();
        const known = kind === kinds.moved ? movePredictors : appendPredictors;
        if (kind === kinds.changes ? predictor !== changePredictor : predictor >= known) {
            throw new FrameError(`a mesh frame needs the unknown predictor ${predictor}`);
        }
        return predictor;
    }

    /** How many vertices have residuals of their own. */
    private readResiduals(reader: ByteReader, { count, coded }: Block): number {
        const rooms = coded.map((_, i) => this.room.of(i, count * this.channels[i]!.components));
        const escaped: { vertex: number; residuals: number[] }[] = [];
        let vertex = 0;
        for (let left = reader.varint(); left > 0; --left, ++vertex) {
            vertex += reader.varint();
            if (vertex >= count) throw new FrameError('a mesh frame holds a residual of a vertex that is not in its block');
            const length = this.channels.slice(0, coded.length).reduce((sum, { components }) => sum + components, 0);
            escaped.push({ vertex, residuals: Array.from({ length }, () => reader.signed()) });
        }
        const bytes = reader.take(reader.varint());
        const used = coded.flatMap((isCoded, i) => (isCoded ? [i] : []));
        if ((used.length === 0) !== (bytes.length === 0)) {
            throw new FrameError('a mesh frame announces residuals without bytes for them');
        }
        coded.forEach((isCoded, i) => isCoded || rooms[i]!.fill(0));
        if (used.length > 0) {
            const components = used.map((i) => this.channels[i]!.components);
            this.draco.decode(
                bytes,
                count,
                components,
                used.map((i) => rooms[i]!),
            );
        }
        for (const { vertex: at, residuals } of escaped) {
            let next = 0;
            rooms.forEach((room, i) => {
                const { components } = this.channels[i]!;
                for (let k = 0; k < components; ++k) room[at * components + k] = residuals[next++]!;
            });
        }
        return escaped.length;
    }

    private apply(block: Block): void {
        const { neighbours, position } = this.mesh;
        this.expected[block.kind]!.next(block.count, (from, to, at) => {
            if (block.kind === kinds.changes) {
                const values = this.room.of(0, block.count * 3);
                takeChanges(position.change, neighbours, from, to, { values, at, scale: 1 });
                return;
            }
            this.channels.forEach((channel, i) => {
                const values = this.room.of(i, block.count * channel.components);
                if (block.still[i]) return;
                const residuals = { values, at, scale: block.scales[i]! };
                const predictor = block.predictors[i]!;
                if (block.kind === kinds.moved) move(channel, neighbours, predictor, from, to, residuals);
                else append(channel, neighbours, predictor, from, to, residuals, this.stayed);
            });
        });
    }
}

function readScale(reader: ByteReader): number {
    const tolerance = reader.varint();
    if (tolerance > maxTolerance) throw new FrameError('a mesh frame has a tolerance over the limit');
    return 2 * tolerance + 1;
}
