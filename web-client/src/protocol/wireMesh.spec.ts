import { expect, test } from 'vitest';
import { seededRandom } from './testing/randomSurface.ts';
import { WordSum, wordSum } from './wireMesh.ts';

test('equals its definition in whole numbers without overflow', () => {
    const random = seededRandom(5);
    const wrap = (value: bigint): bigint => BigInt.asUintN(32, value);
    const stir = (sum: bigint, word: bigint): bigint => {
        const x = sum ^ wrap(word);
        return wrap(wrap((x << 13n) | (x >> 19n)) * 0x9e3779b1n);
    };
    for (let length = 0; length < 40; ++length) {
        const words = Int32Array.from({ length }, random);
        let h = BigInt(length);
        for (let lane = 0; lane < 4; ++lane) {
            const mine = [...words].filter((_, i) => i % 4 === lane).map((word) => BigInt(word >>> 0));
            h = stir(
                h,
                mine.reduce((sum, word) => sum + word, 0n),
            );
            h = stir(
                h,
                mine.reduce((sum, word, i) => sum + word * BigInt(mine.length - i), 0n),
            );
        }
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
    for (let i = 0; i < words.length; ++i) {
        words[i]! ^= 1 << (i & 31);
        expect(wordSum(words)).not.toBe(before);
        words[i]! ^= 1 << (i & 31);
    }
});
