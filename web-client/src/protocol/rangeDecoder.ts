// Binary arithmetic decoding with probabilities that both ends learn alike from what has been coded: what the cells code is
// read with. protocol/wire/README.md, Range code. Twin: protocol/wire/range_coder.hpp.
import { FrameError } from './frameError.ts';

const leastRange = 2 ** 24;
const certain = 65536;
const least = 32;
const longestMemory = 30;

/** How likely some decisions are, by number, from how they went before. */
export class AdaptiveBits {
    readonly one: Int32Array; // of 2^16
    readonly seen: Uint8Array;

    constructor(count: number) {
        this.one = new Int32Array(count).fill(certain / 2);
        this.seen = new Uint8Array(count);
    }
}

/** What a decision weighs after so many of its kind. */
const rates = Int32Array.from({ length: longestMemory + 1 }, (_, seen) => Math.floor(131072 / (2 * seen + 3)));

export class RangeDecoder {
    private readonly bytes: Uint8Array;
    private read = 0;
    private range = 0xffffffff; // this and code: 32 bits without sign, as doubles
    private code = 0;

    constructor(bytes: Uint8Array) {
        this.bytes = bytes;
        for (let i = 0; i < 4; ++i) this.code = this.code * 256 + this.next();
        if (this.code === this.range) throw new FrameError('a range code of a mesh frame begins as none does'); // it is always below
    }

    /** 0 or 1. Throws FrameError behind the end of the bytes. */
    bit({ one, seen }: AdaptiveBits, index: number): number {
        const likely = one[index]!;
        const bit = this.narrow((this.range >>> 16) * likely);
        const rate = rates[seen[index]!]!;
        const now = bit !== 0 ? likely + (((certain - likely) * rate) >>> 16) : likely - ((likely * rate) >>> 16);
        one[index] = now < least ? least : now > certain - least ? certain - least : now;
        if (seen[index]! < longestMemory) ++seen[index]!;
        return bit;
    }

    /** A decision about which nothing was known. */
    even(): number {
        return this.narrow(this.range >>> 1);
    }

    /** Throws FrameError unless all bytes have been read. */
    finish(): void {
        if (this.read !== this.bytes.length) throw new FrameError('a range code of a mesh frame goes on after its end');
    }

    private narrow(bound: number): number {
        let bit = 0;
        if (this.code < bound) {
            this.range = bound;
            bit = 1;
        } else {
            this.code -= bound;
            this.range -= bound;
        }
        for (; this.range < leastRange; this.range *= 256) this.code = this.code * 256 + this.next();
        return bit;
    }

    private next(): number {
        if (this.read === this.bytes.length) throw new FrameError('a range code of a mesh frame ends too early');
        return this.bytes[this.read++]!;
    }
}

/** Numbers that are mostly small: how many bits, then the bits, of which the two below the highest are learnt. */
export class AdaptiveNumber {
    private readonly width = new AdaptiveBits(64);
    private readonly high = new AdaptiveBits(99);

    /** Of 32 bits, with or without sign. */
    read(decoder: RangeDecoder): number {
        let node = 1;
        for (let level = 0; level < 6; ++level) node = node * 2 + decoder.bit(this.width, node);
        const width = node - 64;
        if (width > 32) throw new FrameError('a range code of a mesh frame holds a number of more than 32 bits');
        if (width === 0) return 0;
        let value = 1;
        for (let place = 1; place < width; ++place) {
            const context = 3 * width + (place === 1 ? 0 : 1 + (value & 1));
            value = (value << 1) | (place <= 2 ? decoder.bit(this.high, context) : decoder.even());
        }
        return value;
    }
}
