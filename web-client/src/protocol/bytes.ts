// Little-endian varints in byte strings: the atoms of the binary wire. Twin: protocol/wire/bytes.hpp.
import { FrameError } from './frameError.ts';

/** Differences near zero, of either sign, stand as small numbers: 0, 1, 2, 3 ... are 0, -1, 1, -2 ... */
export function unzigzag(code: number): number {
    return (code >>> 1) ^ -(code & 1);
}

/** Reads numbers one after the other. Throws FrameError at the end of the bytes. */
export class ByteReader {
    private at = 0;
    private readonly bytes: Uint8Array;

    constructor(bytes: Uint8Array) {
        this.bytes = bytes;
    }

    get atEnd(): boolean {
        return this.at === this.bytes.length;
    }

    byte(): number {
        if (this.atEnd) throw new FrameError('a part of a mesh frame ends too early');
        return this.bytes[this.at++]!;
    }

    /** Seven bits a byte, lowest first, at most 32 bits. */
    varint(): number {
        let value = 0;
        for (let shift = 0; shift < 35; shift += 7) {
            const byte = this.byte();
            if (shift === 28 && byte > 0x0f) break;
            value |= (byte & 0x7f) << shift;
            if ((byte & 0x80) === 0) return value >>> 0;
        }
        throw new FrameError('a mesh frame holds a number of more than 32 bits');
    }

    signed(): number {
        return unzigzag(this.varint());
    }

    /** The next `count` bytes, not copied. */
    take(count: number): Uint8Array {
        if (count > this.bytes.length - this.at) throw new FrameError('a part of a mesh frame ends too early');
        this.at += count;
        return this.bytes.subarray(this.at - count, this.at);
    }

    rest(): Uint8Array {
        return this.take(this.bytes.length - this.at);
    }
}
