// From frames back to states. Twin: protocol/wire/mesh_decoder.hpp; unlike there, an update is kept as bytes
// until all its frames are in, and then changes the one state in place: what is shown has been copied out of
// it.
import { FrameError, Numbers } from './bytes.ts';
import type { DracoPoints } from './dracoPoints.ts';
import type { Lattice } from './lattice.ts';
import { type FrameHeader, readFrame, sameUpdate } from './meshFrame.ts';
import { applyEdit, type TopologyEdit } from './wireEdit.ts';
import { type AttributeRange, WireMesh } from './wireMesh.ts';
import { PointsReader } from './wirePoints.ts';

/** Limits the bytes of an update that is not whole yet. */
const maxUpdateBytes = 256 << 20;

/** Memory with room for so many times the vertices of the next state is given back. */
const largestRoom = 4;

/** An update in pieces, as they come. */
interface Collected {
    header: FrameHeader; // of frame 0
    pieces: Uint8Array[];
    bytes: number;
}

/** A whole update that has been applied. */
export interface AppliedUpdate {
    header: FrameHeader;
    edit: TopologyEdit;
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
     * `attributeCount`: how many attributes the frames carry; null: as many as each KEY has, because an edit
     * of a surface's fields changes them.
     */
    constructor(draco: DracoPoints, lattice: Lattice, attributeCount: number | null) {
        this.points = new PointsReader(draco);
        this.lattice = lattice;
        this.attributeCount = attributeCount;
    }

    /** Returns the header of the newest whole update. */
    get newest(): FrameHeader | undefined {
        return this.header;
    }

    /** The newest whole state; none while only a KEY is taken. The next update changes it. */
    get mesh(): WireMesh | undefined {
        return this.state;
    }

    /** Continues the same surface under another subscription, on another connection: an unfinished update is
     *  void. */
    continueAs(subscription: number): void {
        this.surface = subscription;
        this.update = undefined;
    }

    /** Goes on from another whole state of the same surface, which is this decoder's own from now on; from none: with a KEY. */
    beginAgain(from?: { header: FrameHeader; mesh: WireMesh }): void {
        this.header = from?.header;
        this.state = from?.mesh;
        this.update = undefined;
    }

    /**
     * Gives the update that the frame made whole. Throws FrameError when the frame is damaged or does not
     * continue what is there; after that only a frame that starts a KEY is taken.
     */
    fold(bytes: Uint8Array): AppliedUpdate | undefined {
        try {
            const { header, body } = readFrame(bytes);
            const update = header.frameIndex > 0 ? this.continued(header) : this.begun(header);
            update.pieces.push(body);
            update.bytes += body.length;
            if (update.bytes > maxUpdateBytes) throw new FrameError('a mesh update is too long');
            this.update = update;
            if (update.pieces.length < header.frameCount) return undefined;
            this.update = undefined;
            return this.apply(update);
        } catch (error) {
            this.update = undefined;
            this.state = undefined;
            if (error instanceof RangeError) throw new FrameError('there is not enough memory for a mesh update');
            throw error;
        }
    }

    private continued(h: FrameHeader): Collected {
        const { update } = this;
        if (update?.pieces.length !== h.frameIndex || !sameUpdate(update.header, h)) {
            throw new FrameError(`frame ${h.frameIndex} of update ${h.seq} does not follow the one before`);
        }
        return update;
    }

    private begun(h: FrameHeader): Collected {
        const { header: newest, state, update } = this;
        const wanted = this.attributeCount ?? (h.key ? h.attributeCount : state?.codes.length);
        if (h.attributeCount !== wanted || h.latticeBits !== this.lattice.bits) {
            throw new FrameError('a mesh frame has other attributes or another lattice than agreed');
        }
        if (this.surface !== undefined && h.surface !== this.surface) {
            throw new FrameError(`a frame of subscription ${h.surface} came to ${this.surface}`);
        }
        const late = newest !== undefined && (h.epoch < newest.epoch || (h.epoch === newest.epoch && h.seq < newest.seq));
        if (h.key && late) throw new FrameError(`update ${h.seq} of epoch ${h.epoch} came too late`);
        const follows = state !== undefined && update === undefined && h.epoch === newest?.epoch && h.seq === newest.seq + 1;
        if (!h.key && !follows) throw new FrameError(`update ${h.seq} of epoch ${h.epoch} does not continue the mesh so far`);
        return { header: h, pieces: [], bytes: 0 };
    }

    private apply(update: Collected): AppliedUpdate {
        const { header: h } = update;
        const numbers = new Numbers(joined(update));
        const mesh = h.key ? this.emptied(numbers, h) : this.state!;
        if (mesh.ranges.some(({ gaps }, i) => gaps !== hasGaps(h, i))) {
            throw new FrameError('a mesh update has other gaps than the one before');
        }
        this.state = undefined; // until all has gone well
        const edit = applyEdit(mesh, numbers, h);
        this.points.read(mesh, edit, numbers);
        if (mesh.stateSum() !== h.stateSum) throw new FrameError("the mesh does not match the server's checksum");
        this.header = h;
        this.surface = h.surface;
        this.state = mesh;
        return { header: h, edit, mesh };
    }

    /** The state that a KEY begins with. */
    private emptied(numbers: Numbers, h: FrameHeader): WireMesh {
        const ranges = readRanges(numbers, h);
        const { state } = this;
        return new WireMesh(
            h.latticeBits,
            ranges,
            state !== undefined && state.room <= largestRoom * h.vertices ? state : undefined,
        );
    }
}

function joined({ pieces, bytes }: Collected): Uint8Array {
    if (pieces.length === 1) return pieces[0]!;
    const whole = new Uint8Array(bytes);
    let at = 0;
    for (const piece of pieces) {
        whole.set(piece, at);
        at += piece.length;
    }
    return whole;
}

function hasGaps(h: FrameHeader, attribute: number): boolean {
    return ((h.gaps >> attribute) & 1) !== 0;
}

function readRanges(numbers: Numbers, h: FrameHeader): AttributeRange[] {
    const attributes = h.attributeCount;
    const bounds = new Float64Array(numbers.take(4 * attributes).slice().buffer);
    return Array.from({ length: attributes }, (_, i) => {
        const range = { lo: bounds[2 * i]!, hi: bounds[2 * i + 1]!, gaps: hasGaps(h, i) };
        if (!Number.isFinite(range.lo) || !Number.isFinite(range.hi) || range.lo > range.hi) {
            throw new FrameError('a mesh update has an attribute without a usable range');
        }
        return range;
    });
}
