// The envelope of one binary message: header, attribute ranges, a piece of the topology, point blocks.
// protocol/wire/README.md has the byte map. Twin: protocol/wire/mesh_frame.hpp.
import { crc32c } from './crc32c.ts';
import { FrameError } from './frameError.ts';
import { maxLatticeBits } from './lattice.ts';
import type { AttributeRange } from './wireMesh.ts';

export const frameMagic = 0x5357;
export const frameVersion = 3;
export const frameHeaderBytes = 64;
export const frameCrcAt = 60;

export const maxFrameBytes = 4 << 20;
export const maxMeshVertices = 1 << 24;
export const maxMeshCells = 1 << 24;
export const maxAttributes = 7;

export const flag = { key: 1, lossless: 2, history: 4 } as const;

/** How good a state is: what is shown, and whether more is to come. */
export const phases = ['coarse', 'refined', 'final', 'live'] as const;
export type Phase = (typeof phases)[number];

const rangeBytes = 8;

export interface FrameHeader {
    key: boolean; // starts from the empty state
    lossless: boolean; // the state is the server's surface, exact on the lattice
    history: boolean; // a KEY with the changes of its vertices
    surface: number; // the subscription
    epoch: number;
    seq: number; // of the update
    baseSeq: number;
    frameIndex: number;
    frameCount: number;
    phase: Phase;
    latticeBits: number;
    attributeCount: number;
    vertices: number; // of the state after the update
    cells: number;
    topologySize: number; // of the update, all frames together
    time: number; // simulation time of the state
    stateSum: number;
}

/** A frame taken apart; the parts are views of the bytes it was read from. */
export interface MeshFrame {
    header: FrameHeader;
    ranges: AttributeRange[]; // of frame 0 of a KEY, else empty
    topology: Uint8Array;
    points: Uint8Array;
}

/** Whether two frames can be of one update: alike but for their index and the sizes of their parts. */
export function sameUpdate(a: FrameHeader, b: FrameHeader): boolean {
    const names = Object.keys(a) as (keyof FrameHeader)[];
    return names.every((name) => name === 'frameIndex' || Object.is(a[name], b[name]));
}

/** Which subscription a message belongs to, without checking anything else. */
export function surfaceOf(bytes: Uint8Array): number | undefined {
    if (bytes.length < frameHeaderBytes) return undefined;
    return new DataView(bytes.buffer, bytes.byteOffset).getUint32(4, true);
}

function parse(view: DataView): FrameHeader {
    const flags = view.getUint8(3);
    const phase = phases[view.getUint8(24)];
    if ((flags & ~(flag.key | flag.lossless | flag.history)) !== 0 || phase === undefined || view.getUint8(27) !== 0) {
        throw new FrameError('a mesh frame has flags or a phase that this version does not know');
    }
    return {
        key: (flags & flag.key) !== 0,
        lossless: (flags & flag.lossless) !== 0,
        history: (flags & flag.history) !== 0,
        surface: view.getUint32(4, true),
        epoch: view.getUint32(8, true),
        seq: view.getUint32(12, true),
        baseSeq: view.getUint32(16, true),
        frameIndex: view.getUint16(20, true),
        frameCount: view.getUint16(22, true),
        phase,
        latticeBits: view.getUint8(25),
        attributeCount: view.getUint8(26),
        vertices: view.getUint32(28, true),
        cells: view.getUint32(32, true),
        topologySize: view.getUint32(36, true),
        time: view.getFloat64(40, true),
        stateSum: view.getUint32(56, true),
    };
}

/** Counts that memory is reserved for, and what must be so in any header. */
function check(h: FrameHeader, topologyBytes: number): void {
    if (h.vertices > maxMeshVertices || h.cells > maxMeshCells || h.attributeCount > maxAttributes) {
        throw new FrameError(`a mesh frame announces ${h.vertices} vertices and ${h.cells} cells`);
    }
    if (
        h.frameIndex >= h.frameCount ||
        (h.key ? h.baseSeq !== h.seq : h.baseSeq >= h.seq) ||
        (h.history && !h.key) ||
        h.latticeBits < 1 ||
        h.latticeBits > maxLatticeBits ||
        topologyBytes > h.topologySize ||
        !Number.isFinite(h.time)
    ) {
        throw new FrameError("a mesh frame's header contradicts itself");
    }
}

function readRange(view: DataView, at: number): AttributeRange {
    const range = { lo: view.getFloat32(at, true), hi: view.getFloat32(at + 4, true) };
    if (!Number.isFinite(range.lo) || !Number.isFinite(range.hi) || range.lo > range.hi) {
        throw new FrameError('a mesh frame has an attribute without a usable range');
    }
    return range;
}

/** Throws FrameError unless `bytes` are exactly one whole, undamaged frame. */
export function readFrame(bytes: Uint8Array): MeshFrame {
    if (bytes.length > maxFrameBytes) throw new FrameError(`a mesh frame has ${bytes.length} bytes`);
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length < frameHeaderBytes || view.getUint16(0, true) !== frameMagic) {
        throw new FrameError('a binary message is not a mesh frame');
    }
    if (view.getUint8(2) !== frameVersion) {
        throw new FrameError(`a mesh frame has version ${view.getUint8(2)}, not ${frameVersion}`);
    }
    const crc = crc32c(bytes.subarray(frameHeaderBytes), crc32c(bytes.subarray(0, frameCrcAt)));
    if (crc !== view.getUint32(frameCrcAt, true)) throw new FrameError('a mesh frame does not match its checksum');
    const header = parse(view);
    const topologyBytes = view.getUint32(48, true);
    const pointsBytes = view.getUint32(52, true);
    check(header, topologyBytes);
    const ranges: AttributeRange[] = [];
    const rangeCount = header.key && header.frameIndex === 0 ? header.attributeCount : 0;
    const body = frameHeaderBytes + rangeBytes * rangeCount;
    if (bytes.length !== body + topologyBytes + pointsBytes) {
        throw new FrameError(`a mesh frame of ${bytes.length} bytes announces other parts`);
    }
    for (let i = 0; i < rangeCount; ++i) ranges.push(readRange(view, frameHeaderBytes + rangeBytes * i));
    return {
        header,
        ranges,
        topology: bytes.subarray(body, body + topologyBytes),
        points: bytes.subarray(body + topologyBytes),
    };
}
