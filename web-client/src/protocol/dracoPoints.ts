// The points of one frame, a Draco sequential point cloud: differences of consecutive lattice positions
// and, in a low and a high byte, of 16 bit attribute codes. The only file that knows Draco.
// Twin: protocol/draco_points.hpp.
import type { Decoder, DecoderModule, PointCloud } from 'draco3d';
import { FrameError } from './frameError.ts';

const draco = { genericAttribute: 4, int32: 5, uint8: 2, integerCoding: 1 } as const;

/// All that Draco 2.3 says before the entropy-coded values. It trusts these counts, so a damaged one
/// would cost gigabytes; compared first, they cannot.
function expectedStart(points: number, bytePlanes: number): Uint8Array {
    const bytes = [...'DRACO'].map((letter) => letter.charCodeAt(0));
    bytes.push(2, 3, 0, 0, 0, 0); // version; point cloud, sequential; no flags
    for (let shift = 0; shift < 32; shift += 8)
        bytes.push((points >>> shift) & 0xff);
    bytes.push(1, bytePlanes + 1);
    bytes.push(draco.genericAttribute, draco.int32, 3, 0, 0);
    for (let i = 1; i <= bytePlanes; i += 1)
        bytes.push(draco.genericAttribute, draco.uint8, 1, 0, i);
    for (let i = 0; i <= bytePlanes; i += 1)
        bytes.push(draco.integerCoding);
    return Uint8Array.from(bytes);
}

function startsWith(bytes: Uint8Array, start: Uint8Array): boolean {
    return bytes.length >= start.length && start.every((byte, i) => byte === bytes[i]);
}

function sumUp(nodes: Int32Array): void {
    for (let i = 3; i < nodes.length; i += 1)
        nodes[i] = nodes[i]! + nodes[i - 3]!;
}

function joinPlanes(low: Uint8Array, high: Uint8Array, codes: Uint16Array): void {
    let code = 0;
    for (let i = 0; i < codes.length; i += 1) {
        code = (code + low[i]! + 256 * high[i]!) & 0xffff;
        codes[i] = code;
    }
}

/// Decodes with one Draco module; everything it allocates there is freed before decode() returns.
export class DracoPoints {
    private readonly module: DecoderModule;

    constructor(module: DecoderModule) {
        this.module = module;
    }

    /// Bytes the module holds. It only grows; a worker may be replaced when it has grown too far.
    get heapBytes(): number {
        return this.module.HEAP8.byteLength;
    }

    /// Fills `nodes` (xyz of each point, at least one) and one array a point for each attribute.
    /// Throws FrameError.
    decode(bytes: Uint8Array, nodes: Int32Array, attributes: readonly Uint16Array[]): void {
        if (!startsWith(bytes, expectedStart(nodes.length / 3, 2 * attributes.length)))
            throw new FrameError('the Draco block of a mesh frame is not what its header announces');
        const { module } = this;
        const buffer = new module.DecoderBuffer();
        const decoder = new module.Decoder();
        const cloud = new module.PointCloud();
        try {
            buffer.Init(new Int8Array(bytes.buffer, bytes.byteOffset, bytes.length), bytes.length);
            const status = decoder.DecodeBufferToPointCloud(buffer, cloud);
            if (!status.ok() || cloud.num_points() * 3 !== nodes.length)
                throw new FrameError(`Draco did not decode a mesh frame: ${status.error_msg()}`);
            this.copyOut(decoder, cloud, nodes, attributes);
        } catch (error) {
            throw error instanceof FrameError ? error : new FrameError(`Draco failed on a mesh frame: ${String(error)}`);
        } finally {
            module.destroy(cloud);
            module.destroy(decoder);
            module.destroy(buffer);
        }
        sumUp(nodes);
    }

    private copyOut(
        decoder: Decoder,
        cloud: PointCloud,
        nodes: Int32Array,
        attributes: readonly Uint16Array[],
    ): void {
        const { module } = this;
        const room = module._malloc(nodes.byteLength);
        try {
            const copy = (id: number, into: Int32Array | Uint8Array, type: number): void => {
                const attribute = decoder.GetAttribute(cloud, id);
                decoder.GetAttributeDataArrayForAllPoints(cloud, attribute, type, into.byteLength, room);
                // Looked up only now: decoding may have grown the heap, which detaches the old view.
                const heap = into instanceof Int32Array ? module.HEAP32 : module.HEAPU8;
                const start = room / into.BYTES_PER_ELEMENT;
                into.set(heap.subarray(start, start + into.length));
            };
            copy(0, nodes, module.DT_INT32);
            const low = new Uint8Array(nodes.length / 3);
            const high = new Uint8Array(nodes.length / 3);
            attributes.forEach((codes, i) => {
                copy(2 * i + 1, low, module.DT_UINT8);
                copy(2 * i + 2, high, module.DT_UINT8);
                joinPlanes(low, high, codes);
            });
        } finally {
            module._free(room);
        }
    }
}
