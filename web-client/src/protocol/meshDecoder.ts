// From frames back to a mesh, in arrays that go to the GPU as they are. Twin: protocol/mesh_decoder.hpp.
import { cellStride, decodeCells } from './cellsCode.ts';
import type { DracoPoints } from './dracoPoints.ts';
import { FrameError } from './frameError.ts';
import { Growing } from './growing.ts';
import { dequantise, lastNode, type Lattice } from './lattice.ts';
import { type AttributeRange, type FrameHeader, type MeshFrame, readFrame } from './meshFrame.ts';
import { StateCrc } from './stateCrc.ts';

/// The arrays are views; their buffers may be longer, and may be transferred once taken.
export interface WireMesh {
    surface: number;
    epoch: number;
    seq: number; // of the newest frame
    complete: boolean; // the last frame of the state is in and its checksum held
    final: boolean; // no finer state of this epoch follows
    stateCrc: number;
    vertexCount: number;
    cellCount: number;
    nodes: Int32Array; // lattice positions, xyz
    positions: Float32Array; // the same in the dataset's length unit
    attributes: Record<string, Float32Array>; // one value a vertex
    ranges: Record<string, AttributeRange>;
    cells: Uint32Array; // cellStride ids a cell
}

interface Attribute {
    name: string;
    range: AttributeRange;
    values: Growing<Float32Array>;
}

function isInside(nodes: Int32Array, last: number): boolean {
    for (let i = 0; i < nodes.length; i += 1)
        if (nodes[i]! < 0 || nodes[i]! > last)
            return false;
    return true;
}

/// Folds the frames of one surface, in order, into its mesh.
export class MeshDecoder {
    private readonly points: DracoPoints;
    private readonly lattice: Lattice;
    private readonly names: readonly string[];
    private newest: FrameHeader | undefined;
    private intact = false; // every frame since the mesh began was taken
    private nodes = new Growing(Int32Array);
    private positions = new Growing(Float32Array);
    private cells = new Growing(Uint32Array);
    private attributes: Attribute[] = [];
    private crc = new StateCrc();

    /// `attributeNames`: what the frames carry, in order, as `surface.subscribe` says.
    constructor(points: DracoPoints, lattice: Lattice, attributeNames: readonly string[]) {
        this.points = points;
        this.lattice = lattice;
        this.names = attributeNames;
    }

    /// Throws FrameError when the frame is damaged, does not follow the one before, or the state's
    /// checksum fails. After that only a frame that starts a new mesh is taken.
    fold(bytes: Uint8Array): FrameHeader {
        const wasIntact = this.intact;
        this.intact = false;
        const frame = readFrame(bytes);
        this.checkOrder(frame, wasIntact);
        this.append(frame);
        this.intact = true;
        return frame.header;
    }

    /// The mesh so far; its arrays stay valid until the next fold().
    get mesh(): WireMesh | undefined {
        const h = this.newest;
        if (h === undefined || !this.intact)
            return undefined;
        return {
            surface: h.surface,
            epoch: h.epoch,
            seq: h.seq,
            complete: h.last,
            final: h.last && h.final,
            stateCrc: h.stateCrc,
            vertexCount: h.vertexBase + h.vertexCount,
            cellCount: h.cellBase + h.cellCount,
            nodes: this.nodes.view,
            positions: this.positions.view,
            attributes: Object.fromEntries(this.attributes.map((a) => [a.name, a.values.view])),
            ranges: Object.fromEntries(this.attributes.map((a) => [a.name, a.range])),
            cells: this.cells.view,
        };
    }

    /// The mesh so far, given away: its buffers may be transferred, and only a frame that starts a
    /// new mesh is taken next.
    take(): WireMesh | undefined {
        const { mesh } = this;
        this.start([]);
        this.intact = false;
        return mesh;
    }

    private checkOrder({ header: h, ranges }: MeshFrame, wasIntact: boolean): void {
        const before = this.newest;
        if (ranges.length !== this.names.length || h.latticeBits !== this.lattice.bits)
            throw new FrameError('a mesh frame has other attributes or another lattice than agreed');
        if (before !== undefined && h.surface !== before.surface)
            throw new FrameError(`a frame of surface ${h.surface} came to surface ${before.surface}`);
        if (h.first) {
            if (before !== undefined && (h.epoch < before.epoch || (h.epoch === before.epoch && h.seq <= before.seq)))
                throw new FrameError(`epoch ${h.epoch} frame ${h.seq} came too late`);
            return;
        }
        if (
            before === undefined ||
            !wasIntact ||
            before.last ||
            h.epoch !== before.epoch ||
            h.seq !== before.seq + 1 ||
            h.vertexBase !== before.vertexBase + before.vertexCount ||
            h.cellBase !== before.cellBase + before.cellCount
        )
            throw new FrameError(`epoch ${h.epoch} frame ${h.seq} does not continue the mesh so far`);
        if (this.attributes.some(({ range }, i) => range.lo !== ranges[i]!.lo || range.hi !== ranges[i]!.hi))
            throw new FrameError('the range of an attribute changed within a mesh');
    }

    private start(ranges: readonly AttributeRange[]): void {
        this.nodes = new Growing(Int32Array);
        this.positions = new Growing(Float32Array);
        this.cells = new Growing(Uint32Array);
        this.attributes = ranges.map((range, i) => ({
            name: this.names[i]!,
            range,
            values: new Growing(Float32Array),
        }));
        this.crc = new StateCrc();
    }

    private append(frame: MeshFrame): void {
        const h = frame.header;
        if (h.first)
            this.start(frame.ranges);
        this.newest = h;
        if (h.vertexCount > 0)
            this.appendPoints(frame);
        const cells = this.cells.extend(h.cellCount * cellStride);
        decodeCells(frame.cells, h.cellCount, h.vertexBase + h.vertexCount, cells);
        this.crc.addCells(cells);
        if (this.crc.value() !== h.stateCrc)
            throw new FrameError("the mesh does not match the server's checksum");
    }

    private appendPoints({ header: h, draco }: MeshFrame): void {
        const nodes = this.nodes.extend(3 * h.vertexCount);
        const codes = this.attributes.map(() => new Uint16Array(h.vertexCount));
        this.points.decode(draco, nodes, codes);
        if (!isInside(nodes, lastNode(h.latticeBits)))
            throw new FrameError('a mesh frame has a vertex outside its lattice');
        dequantise(this.lattice, nodes, this.positions.extend(nodes.length));
        this.attributes.forEach(({ range, values }, attribute) => {
            const into = values.extend(h.vertexCount);
            const from = codes[attribute]!;
            const width = range.hi - range.lo;
            for (let i = 0; i < into.length; i += 1)
                into[i] = range.lo + (width * from[i]!) / 65535;
        });
        this.crc.addPositions(nodes);
    }
}
