// The residuals of a point block, a Draco sequential point cloud. The only file that knows Draco.
// protocol/wire/FORMAT.md, Draco block. Twin: protocol/wire/draco_points.hpp.
import type { DecoderModule } from 'draco3d';
import { FrameError } from './bytes.ts';

const draco = { genericAttribute: 4, int32: 5, integerCoding: 1 } as const;
const bytesOfInt32 = 4;

/**
 * All that Draco 2.3 says before the entropy-coded values. It trusts these counts, so a damaged one
 * would cost gigabytes; compared first, they cannot.
 */
function expectedStart(points: number, components: readonly number[]): Uint8Array {
    const bytes = [...'DRACO'].map((letter) => letter.charCodeAt(0));
    bytes.push(2, 3, 0, 0, 0, 0); // version; point cloud, sequential; no flags
    for (let shift = 0; shift < 32; shift += 8) bytes.push((points >>> shift) & 0xff);
    bytes.push(1, components.length);
    components.forEach((count, i) => bytes.push(draco.genericAttribute, draco.int32, count, 0, i));
    for (let i = 0; i < components.length; ++i) bytes.push(draco.integerCoding);
    return Uint8Array.from(bytes);
}

function startsWith(bytes: Uint8Array, start: Uint8Array): boolean {
    return bytes.length >= start.length && start.every((byte, i) => byte === bytes[i]);
}

/** Decodes with one Draco module; everything it allocates there is freed before decode() returns. */
export class DracoPoints {
    private module: DecoderModule;

    constructor(module: DecoderModule) {
        this.module = module;
    }

    /** Bytes the module holds. They only grow. */
    get heapBytes(): number {
        return this.module.HEAP8.byteLength;
    }

    /** A fresh module takes the place of one that has grown too far. */
    renew(module: DecoderModule): void {
        this.module = module;
    }

    /**
     * Fills one array a channel, whose numbers for each of the `points` (at least one) are `components`.
     * Throws FrameError.
     */
    decode(bytes: Uint8Array, points: number, components: readonly number[], into: readonly Int32Array[]): void {
        if (!startsWith(bytes, expectedStart(points, components))) {
            throw new FrameError('the Draco block of a mesh frame is not what its header announces');
        }
        const { module } = this;
        const buffer = new module.DecoderBuffer();
        const decoder = new module.Decoder();
        const cloud = new module.PointCloud();
        const room = module._malloc(points * Math.max(...components) * bytesOfInt32);
        try {
            buffer.Init(new Int8Array(bytes.buffer, bytes.byteOffset, bytes.length), bytes.length);
            const status = decoder.DecodeBufferToPointCloud(buffer, cloud);
            if (!status.ok() || cloud.num_points() !== points) {
                throw new FrameError(`Draco did not decode a mesh frame: ${status.error_msg()}`);
            }
            components.forEach((count, i) => {
                const size = points * count;
                const attribute = decoder.GetAttribute(cloud, i);
                const type = module.DT_INT32;
                decoder.GetAttributeDataArrayForAllPoints(cloud, attribute, type, size * bytesOfInt32, room);
                // Looked up only now: decoding may have grown the heap, which detaches the old view.
                const start = room / bytesOfInt32;
                into[i]!.set(module.HEAP32.subarray(start, start + size));
            });
        } catch (error) {
            throw error instanceof FrameError ? error : new FrameError(`Draco failed on a mesh frame: ${String(error)}`);
        } finally {
            module._free(room);
            module.destroy(cloud);
            module.destroy(decoder);
            module.destroy(buffer);
        }
    }
}
