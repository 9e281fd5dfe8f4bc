// A checksum of 32 bit words that scripts compute fast: four lanes of xor, rotate, multiply.
// protocol/README.md, State checksum. Twin: protocol/state_sum.hpp.

const multiplier = 0x9e3779b1 | 0;

function stir(lane: number, word: number): number {
    const x = lane ^ word;
    return Math.imul((x << 13) | (x >>> 19), multiplier);
}

/// Sums words in any number of steps, each of which but the last adds a multiple of four.
export class WordSum {
    private readonly lanes = Int32Array.of(multiplier, 0x85ebca77, 0xc2b2ae3d, 0x27d4eb2f);
    private count = 0;

    add(words: Int32Array): void {
        const { lanes } = this;
        let a = lanes[0]!;
        let b = lanes[1]!;
        let c = lanes[2]!;
        let d = lanes[3]!;
        const whole = words.length & ~3;
        for (let at = 0; at < whole; at += 4) {
            a = stir(a, words[at]!);
            b = stir(b, words[at + 1]!);
            c = stir(c, words[at + 2]!);
            d = stir(d, words[at + 3]!);
        }
        lanes.set([a, b, c, d]);
        for (let at = whole; at < words.length; at += 1)
            lanes[at & 3] = stir(lanes[at & 3]!, words[at]!);
        this.count += words.length;
    }

    value(): number {
        const sum = this.lanes.reduce(stir, this.count | 0);
        return (sum ^ (sum >>> 15)) >>> 0;
    }
}

/// Small enough for the nearest cache; a multiple of four.
const piece = new Int32Array(1024);

/// Of the words as an unsigned number.
export function wordSum(words: Int32Array): number {
    const sum = new WordSum();
    sum.add(words);
    return sum.value();
}

/// Of the first `count` codes below 2^16, two to a word, the first in the low half; an odd number is padded with 0.
export function pairSum(codes: Int32Array, count: number): number {
    const sum = new WordSum();
    for (let at = 0; at < count; at += 2 * piece.length) {
        const words = Math.min(piece.length, (count - at + 1) >> 1);
        for (let i = 0, from = at; i < words; i += 1, from += 2)
            piece[i] = codes[from]! | (from + 1 < count ? codes[from + 1]! << 16 : 0);
        sum.add(piece.subarray(0, words));
    }
    return sum.value();
}
