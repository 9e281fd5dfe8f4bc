// The envelope of one binary message: a header, and a piece of an update. protocol/wire/FORMAT.md has the
// byte map. Twin: protocol/wire/mesh_frame.hpp.
import { FrameError } from './bytes.ts';
import { maxLatticeBits } from './lattice.ts';

const frameMagic = 0x5357;
const frameVersion = 5;
export const frameHeaderBytes = 48;
export const frameCrcAt = 44;

const maxFrameBytes = 4 << 20;
const maxMeshVertices = 1 << 24;
const maxMeshCells = 1 << 24;
const maxAttributes = 8;
export const maxBlockVertices = 1 << 16;

const flag = { key: 1, lossless: 2 } as const;

/** How good a state is: what is shown, and whether more is to come. */
export const phases = ['coarse', 'refined', 'final', 'live'] as const;
export type Phase = (typeof phases)[number];

export interface FrameHeader {
    key: boolean; // starts from the empty state
    lossless: boolean; // the state is the server's surface, exact on the lattice
    surface: number; // the subscription
    epoch: number;
    seq: number; // of the update; a DELTA starts from the state of the one before
    frameIndex: number;
    frameCount: number;
    phase: Phase;
    latticeBits: number;
    attributeCount: number;
    gaps: number; // a bit an attribute: some vertices have no value of it
    vertices: number; // of the state after the update
    cells: number;
    time: number; // simulation time of the state
    stateSum: number;
}

/** A frame taken apart; the body is a view of the bytes it was read from. */
export interface MeshFrame {
    header: FrameHeader;
    body: Uint8Array;
}

/** Returns whether two frames can be of one update: alike but for their index. */
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
    const phase = phases[view.getUint8(20)];
    if ((flags & ~(flag.key | flag.lossless)) !== 0 || phase === undefined) {
        throw new FrameError('a mesh frame has flags or a phase that this version does not know');
    }
    return {
        key: (flags & flag.key) !== 0,
        lossless: (flags & flag.lossless) !== 0,
        surface: view.getUint32(4, true),
        epoch: view.getUint32(8, true),
        seq: view.getUint32(12, true),
        frameIndex: view.getUint16(16, true),
        frameCount: view.getUint16(18, true),
        phase,
        latticeBits: view.getUint8(21),
        attributeCount: view.getUint8(22),
        gaps: view.getUint8(23),
        vertices: view.getUint32(24, true),
        cells: view.getUint32(28, true),
        time: view.getFloat64(32, true),
        stateSum: view.getUint32(40, true),
    };
}

/** Counts that memory is reserved for, and what must be so in any header. */
function check(h: FrameHeader): void {
    if (h.vertices > maxMeshVertices || h.cells > maxMeshCells || h.attributeCount > maxAttributes) {
        throw new FrameError(`a mesh frame announces ${h.vertices} vertices and ${h.cells} cells`);
    }
    const { latticeBits: bits } = h;
    if (
        h.frameIndex >= h.frameCount ||
        (!h.key && h.seq === 0) ||
        bits < 1 ||
        bits > maxLatticeBits ||
        h.gaps >> h.attributeCount !== 0 ||
        !Number.isFinite(h.time)
    ) {
        throw new FrameError("a mesh frame's header contradicts itself");
    }
}

/** Throws FrameError unless `bytes` are one whole, undamaged frame. */
export function readFrame(bytes: Uint8Array): MeshFrame {
    if (bytes.length > maxFrameBytes) throw new FrameError(`a mesh frame has ${bytes.length} bytes`);
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length < frameHeaderBytes || view.getUint16(0, true) !== frameMagic) {
        throw new FrameError('a binary message is not a mesh frame');
    }
    if (view.getUint8(2) !== frameVersion) {
        throw new FrameError(`a mesh frame has version ${view.getUint8(2)}, not ${frameVersion}`);
    }
    const body = bytes.subarray(frameHeaderBytes);
    if (crc32(body, crc32(bytes.subarray(0, frameCrcAt))) !== view.getUint32(frameCrcAt, true)) {
        throw new FrameError('a mesh frame does not match its checksum');
    }
    const header = parse(view);
    check(header);
    return { header, body };
}

const table = Int32Array.from({ length: 256 }, (_, byte) => {
    let remainder = byte;
    for (let bit = 0; bit < 8; ++bit) remainder = (remainder >>> 1) ^ (remainder & 1 ? 0xedb88320 : 0);
    return remainder;
});

/**
 * The checksum of a frame, CRC-32 as in zlib and PNG. Returns the checksum of `bytes`, or of what `before` is the checksum of
 * and `bytes` behind it; unsigned.
 */
export function crc32(bytes: Uint8Array, before = 0): number {
    let crc = ~before;
    for (let i = 0; i < bytes.length; ++i) crc = (crc >>> 8) ^ table[(crc ^ bytes[i]!) & 0xff]!;
    return ~crc >>> 0;
}
