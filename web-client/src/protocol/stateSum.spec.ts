import { expect, test } from 'vitest';
import { pairSum, WordSum, wordSum } from './stateSum.ts';
import { seededRandom } from './testing/random.ts';

test('gives the values of the specification', () => {
    expect(wordSum(new Int32Array(0))).toBe(0xfd1c883d);
    expect(wordSum(Int32Array.of(1, 2, 3, 4, 5))).toBe(0x8b251d41);
});

test('equals its definition in whole numbers without overflow', () => {
    const random = seededRandom(5);
    const mask = 0xffffffffn;
    const stir = (lane: bigint, word: bigint): bigint => {
        const x = lane ^ word;
        return ((((x << 13n) | (x >> 19n)) & mask) * 0x9e3779b1n) & mask;
    };
    for (let length = 0; length < 40; length += 1) {
        const words = Int32Array.from({ length }, random);
        const lanes = [0x9e3779b1n, 0x85ebca77n, 0xc2b2ae3dn, 0x27d4eb2fn];
        words.forEach((word, i) => (lanes[i % 4] = stir(lanes[i % 4]!, BigInt(word >>> 0))));
        const h = lanes.reduce(stir, BigInt(length));
        expect(wordSum(words)).toBe(Number(h ^ (h >> 15n)));
    }
});

test('of a whole is that of its parts in turn', () => {
    const words = Int32Array.from({ length: 50 }, seededRandom(6));
    for (let cut = 0; cut <= 50; cut += 4) {
        const sum = new WordSum();
        sum.add(words.subarray(0, cut));
        sum.add(words.subarray(cut));
        expect(sum.value()).toBe(wordSum(words));
    }
});

test('changes with any change of one word', () => {
    const words = Int32Array.from({ length: 33 }, seededRandom(7));
    const before = wordSum(words);
    for (let i = 0; i < words.length; i += 1) {
        words[i]! ^= 1 << (i & 31);
        expect(wordSum(words)).not.toBe(before);
        words[i]! ^= 1 << (i & 31);
    }
});

test('of codes is that of their pairs, whatever stands behind them', () => {
    const codes = Int32Array.from({ length: 5000 }, seededRandom(8)).map((code) => code & 0xffff);
    for (const count of [0, 1, 2, 7, 8, 2047, 2048, 2049, 2050, 4097]) {
        const words = Int32Array.from({ length: (count + 1) >> 1 }, (_, i) => {
            const high = 2 * i + 1 < count ? codes[2 * i + 1]! : 0;
            return codes[2 * i]! | (high << 16);
        });
        expect(pairSum(codes, count)).toBe(wordSum(words));
    }
});
