// A checksum of 32 bit words that scripts and vector units compute fast: sums, and sums of sums, in four
// lanes. protocol/wire/FORMAT.md, State sum. Twin: protocol/wire/state_sum.hpp.

function stir(sum: number, word: number): number {
    const x = sum ^ word;
    return Math.imul((x << 13) | (x >>> 19), 0x9e3779b1);
}

/** Sums words in any number of steps, each of which but the last adds a multiple of four. */
export class WordSum {
    private readonly sums = new Int32Array(4);
    private readonly ofSums = new Int32Array(4);
    private count = 0;

    add(words: Int32Array): void {
        const { sums, ofSums } = this;
        let a = sums[0]!;
        let b = sums[1]!;
        let c = sums[2]!;
        let d = sums[3]!;
        let e = ofSums[0]!;
        let f = ofSums[1]!;
        let g = ofSums[2]!;
        let h = ofSums[3]!;
        const whole = words.length & ~3;
        for (let at = 0; at < whole; at += 4) {
            a = (a + words[at]!) | 0;
            b = (b + words[at + 1]!) | 0;
            c = (c + words[at + 2]!) | 0;
            d = (d + words[at + 3]!) | 0;
            e = (e + a) | 0;
            f = (f + b) | 0;
            g = (g + c) | 0;
            h = (h + d) | 0;
        }
        sums[0] = a;
        sums[1] = b;
        sums[2] = c;
        sums[3] = d;
        ofSums[0] = e;
        ofSums[1] = f;
        ofSums[2] = g;
        ofSums[3] = h;
        for (let at = whole; at < words.length; ++at) {
            sums[at & 3]! += words[at]!;
            ofSums[at & 3]! += sums[at & 3]!;
        }
        this.count += words.length;
    }

    value(): number {
        let sum = this.count | 0;
        for (let lane = 0; lane < 4; ++lane) sum = stir(stir(sum, this.sums[lane]!), this.ofSums[lane]!);
        return (sum ^ (sum >>> 15)) >>> 0;
    }
}

/** Returns the sum of the words, as an unsigned number. */
export function wordSum(words: Int32Array): number {
    const sum = new WordSum();
    sum.add(words);
    return sum.value();
}
