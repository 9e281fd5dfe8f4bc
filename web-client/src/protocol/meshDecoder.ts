// From frames back to states. Twin: protocol/wire/mesh_decoder.hpp; unlike there, an update is kept as bytes until all its
// frames are in, and then changes the one state in place: what is shown has been copied out of it.
import type { DracoPoints } from './dracoPoints.ts';
import { FrameError } from './frameError.ts';
import type { Lattice } from './lattice.ts';
import { type FrameHeader, type MeshFrame, readFrame, sameUpdate } from './meshFrame.ts';
import { applyEdit, readEdit, type TopologyEdit } from './wireEdit.ts';
import { type AttributeRange, WireMesh } from './wireMesh.ts';
import { maxFrameVertices, PointsReader } from './wirePoints.ts';

/** Of an update that is not whole yet. */
export const maxUpdateBytes = 256 << 20;

/** An update in pieces, as they come. */
class Collected {
    readonly header: FrameHeader;
    readonly ranges: readonly AttributeRange[];
    readonly points: Uint8Array[] = [];
    private readonly topologyPieces: Uint8Array[] = [];
    private topologyBytes = 0;
    private bytes = 0;

    constructor(header: FrameHeader, ranges: readonly AttributeRange[]) {
        this.header = header;
        this.ranges = ranges;
    }

    get frames(): number {
        return this.points.length;
    }

    add({ header, topology, points }: MeshFrame): void {
        this.topologyBytes += topology.length;
        this.bytes += topology.length + points.length;
        this.topologyPieces.push(topology);
        this.points.push(points);
        const left = header.topologySize - this.topologyBytes;
        if (left < 0 || (left > 0 && (points.length > 0 || this.frames === header.frameCount))) {
            throw new FrameError('the frames of a mesh update hold another topology than they announce');
        }
        if (this.bytes > maxUpdateBytes) throw new FrameError('a mesh update is too long');
    }

    topology(): Uint8Array {
        if (this.topologyPieces.length === 1) return this.topologyPieces[0]!;
        const whole = new Uint8Array(this.topologyBytes);
        let at = 0;
        for (const piece of this.topologyPieces) {
            whole.set(piece, at);
            at += piece.length;
        }
        return whole;
    }
}

/** A whole update that has been applied. */
export interface AppliedUpdate {
    header: FrameHeader;
    edit: TopologyEdit;
    cells: Int32Array; // those that are new: the replaced, then the added ones
    mesh: WireMesh;
}

/** Folds the frames of one surface, in order, into its states. */
export class MeshDecoder {
    private readonly points: PointsReader;
    private readonly lattice: Lattice;
    private readonly attributeCount: number | null;
    private header: FrameHeader | undefined;
    private update: Collected | undefined;
    private state: WireMesh | undefined;
    private surface: number | undefined;

    /**
     * `attributeCount`: how many attributes the frames carry; null: as many as each KEY has, because an edit of a surface's
     * fields changes them.
     */
    constructor(draco: DracoPoints, lattice: Lattice, attributeCount: number | null) {
        this.points = new PointsReader(draco);
        this.lattice = lattice;
        this.attributeCount = attributeCount;
    }

    /** Of the newest whole update. */
    get newest(): FrameHeader | undefined {
        return this.header;
    }

    /** The newest whole state; none while only a KEY is taken. The next update changes it. */
    get mesh(): WireMesh | undefined {
        return this.state;
    }

    /** The same surface goes on under another subscription, on another connection: an unfinished update is void. */
    continueAs(subscription: number): void {
        this.surface = subscription;
        this.update = undefined;
    }

    /**
     * Gives the update that the frame made whole. Throws FrameError when the frame is damaged or does not continue what
     * is there; after that only a frame that starts a KEY is taken.
     */
    fold(bytes: Uint8Array): AppliedUpdate | undefined {
        try {
            const frame = readFrame(bytes);
            const update = this.updateOf(frame);
            update.add(frame);
            this.update = update;
            if (update.frames < frame.header.frameCount) return undefined;
            this.update = undefined;
            return this.apply(update);
        } catch (error) {
            this.update = undefined;
            this.state = undefined;
            if (error instanceof RangeError) throw new FrameError('there is not enough memory for a mesh update');
            throw error;
        }
    }

    private updateOf({ header: h, ranges }: MeshFrame): Collected {
        const { update } = this;
        if (h.frameIndex > 0) {
            if (update === undefined || update.frames !== h.frameIndex || !sameUpdate(update.header, h)) {
                throw new FrameError(`frame ${h.frameIndex} of update ${h.seq} does not follow the one before`);
            }
            return update;
        }
        this.checkAgreement(h);
        if (h.key) this.checkKey(h);
        else this.checkDelta(h);
        return new Collected(h, ranges);
    }

    private checkAgreement(h: FrameHeader): void {
        const wanted = this.attributeCount ?? (h.key ? h.attributeCount : this.state?.codes.length);
        if (h.attributeCount !== wanted || h.latticeBits !== this.lattice.bits) {
            throw new FrameError('a mesh frame has other attributes or another lattice than agreed');
        }
        if (this.surface !== undefined && h.surface !== this.surface) {
            throw new FrameError(`a frame of subscription ${h.surface} came to ${this.surface}`);
        }
    }

    private checkKey(h: FrameHeader): void {
        const { header: newest } = this;
        if (newest !== undefined && (h.epoch < newest.epoch || (h.epoch === newest.epoch && h.seq < newest.seq))) {
            throw new FrameError(`update ${h.seq} of epoch ${h.epoch} came too late`);
        }
    }

    private checkDelta(h: FrameHeader): void {
        const { header: newest } = this;
        if (
            this.state === undefined ||
            this.update !== undefined ||
            newest === undefined ||
            h.epoch !== newest.epoch ||
            h.baseSeq !== newest.seq
        ) {
            throw new FrameError(`update ${h.seq} of epoch ${h.epoch} does not continue the mesh so far`);
        }
    }

    private apply(update: Collected): AppliedUpdate {
        const { header: h, ranges } = update;
        const mesh = h.key ? new WireMesh(h.latticeBits, ranges) : this.state!;
        this.state = undefined; // until all has gone well
        const before = { vertices: mesh.vertices, cells: mesh.cellCount };
        const edit = readEdit(update.topology(), before, h);
        if (edit.movedVertices.count + edit.addedVertices > maxFrameVertices * h.frameCount) {
            throw new FrameError('a mesh update announces more vertices than its frames can hold');
        }
        const cells = applyEdit(mesh, edit);
        this.points.begin(mesh, edit, h.history);
        for (const points of update.points) this.points.take(points);
        this.points.finish();
        if (mesh.stateSum() !== h.stateSum) throw new FrameError("the mesh does not match the server's checksum");
        this.header = h;
        this.surface = h.surface;
        this.state = mesh;
        return { header: h, edit, cells, mesh };
    }
}
