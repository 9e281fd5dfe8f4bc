// The envelope of one binary message: header, attribute ranges, Draco points, cells code.
// protocol/README.md has the byte map. Twin: protocol/mesh_frame.hpp.
import { crc32c } from './crc32c.ts';
import { FrameError } from './frameError.ts';
import { maxLatticeBits } from './lattice.ts';

export const frameMagic = 0x5357;
export const frameVersion = 1;
export const frameHeaderBytes = 52;

export const maxFrameBytes = 4 << 20;
export const maxFrameVertices = 1 << 16;
export const maxFrameCells = 1 << 18;
export const maxMeshVertices = 1 << 26;
export const maxMeshCells = 1 << 26;
export const maxAttributes = 16;

const frameCrcAt = 48;
const rangeBytes = 8;
const firstBit = 1;
const lastBit = 2;
const finalBit = 4;

export interface FrameHeader {
    first: boolean; // a new mesh starts
    last: boolean; // the mesh is whole: check stateCrc, show it
    final: boolean; // no finer mesh of this epoch follows
    surface: number; // the subscription
    epoch: number;
    seq: number; // counts the frames of an epoch
    vertexBase: number;
    vertexCount: number;
    cellBase: number;
    cellCount: number;
    latticeBits: number;
    stateCrc: number;
}

/// What the 16 bit values 0 and 65535 of an attribute stand for, through the whole state.
export interface AttributeRange {
    lo: number;
    hi: number;
}

/// A frame taken apart; the blocks are views of the bytes it was read from.
export interface MeshFrame {
    header: FrameHeader;
    ranges: AttributeRange[];
    draco: Uint8Array;
    cells: Uint8Array;
}

/// Which subscription a message belongs to, without checking anything else.
export function surfaceOf(bytes: Uint8Array): number | undefined {
    if (bytes.length < frameHeaderBytes)
        return undefined;
    return new DataView(bytes.buffer, bytes.byteOffset).getUint32(4, true);
}

function parse(view: DataView): FrameHeader {
    const flags = view.getUint8(3);
    if ((flags & ~(firstBit | lastBit | finalBit)) !== 0)
        throw new FrameError(`a mesh frame has unknown flags ${flags}`);
    return {
        first: (flags & firstBit) !== 0,
        last: (flags & lastBit) !== 0,
        final: (flags & finalBit) !== 0,
        surface: view.getUint32(4, true),
        epoch: view.getUint32(8, true),
        seq: view.getUint32(12, true),
        vertexBase: view.getUint32(16, true),
        vertexCount: view.getUint32(20, true),
        cellBase: view.getUint32(24, true),
        cellCount: view.getUint32(28, true),
        latticeBits: view.getUint8(33),
        stateCrc: view.getUint32(44, true),
    };
}

/// Counts that memory is reserved for.
function checkLimits(h: FrameHeader, attributes: number): void {
    if (
        h.vertexCount > maxFrameVertices ||
        h.cellCount > maxFrameCells ||
        h.vertexBase + h.vertexCount > maxMeshVertices ||
        h.cellBase + h.cellCount > maxMeshCells ||
        attributes > maxAttributes
    )
        throw new FrameError(`a mesh frame announces ${h.vertexCount} vertices and ${h.cellCount} cells`);
}

function checkConsistency(h: FrameHeader, dracoBytes: number, cellBytes: number): void {
    if (h.latticeBits < 1 || h.latticeBits > maxLatticeBits)
        throw new FrameError(`a mesh frame has a lattice of ${h.latticeBits} bits`);
    if ((h.vertexCount === 0) !== (dracoBytes === 0) || (h.cellCount === 0) !== (cellBytes === 0))
        throw new FrameError('a mesh frame announces vertices or cells without bytes for them');
    if (h.first && (h.vertexBase !== 0 || h.cellBase !== 0))
        throw new FrameError('the first frame of a mesh does not start at vertex 0 and cell 0');
}

function readRange(view: DataView, at: number): AttributeRange {
    const range = { lo: view.getFloat32(at, true), hi: view.getFloat32(at + 4, true) };
    if (!Number.isFinite(range.lo) || !Number.isFinite(range.hi) || range.lo > range.hi)
        throw new FrameError('a mesh frame has an attribute without a usable range');
    return range;
}

/// Throws FrameError unless `bytes` are exactly one whole, undamaged frame.
export function readFrame(bytes: Uint8Array): MeshFrame {
    if (bytes.length > maxFrameBytes)
        throw new FrameError(`a mesh frame has ${bytes.length} bytes`);
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length < frameHeaderBytes || view.getUint16(0, true) !== frameMagic)
        throw new FrameError('a binary message is not a mesh frame');
    if (view.getUint8(2) !== frameVersion)
        throw new FrameError(`a mesh frame has version ${view.getUint8(2)}, not ${frameVersion}`);
    const crc = crc32c(bytes.subarray(frameHeaderBytes), crc32c(bytes.subarray(0, frameCrcAt)));
    if (crc !== view.getUint32(frameCrcAt, true))
        throw new FrameError('a mesh frame does not match its checksum');
    const header = parse(view);
    const attributes = view.getUint8(32);
    const dracoBytes = view.getUint32(36, true);
    const cellBytes = view.getUint32(40, true);
    checkLimits(header, attributes);
    checkConsistency(header, dracoBytes, cellBytes);
    const body = frameHeaderBytes + rangeBytes * attributes;
    if (bytes.length !== body + dracoBytes + cellBytes)
        throw new FrameError(`a mesh frame of ${bytes.length} bytes announces other blocks`);
    const ranges: AttributeRange[] = [];
    for (let i = 0; i < attributes; i += 1)
        ranges.push(readRange(view, frameHeaderBytes + rangeBytes * i));
    return {
        header,
        ranges,
        draco: bytes.subarray(body, body + dracoBytes),
        cells: bytes.subarray(body + dracoBytes),
    };
}
