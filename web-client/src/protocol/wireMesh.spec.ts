import { expect, test } from 'vitest';
import { seededRandom } from './testing/randomSurface.ts';
import { WireMesh, WordSum, wordSum } from './wireMesh.ts';

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

test('of a state in the memory of another is as in memory of its own', () => {
    const random = seededRandom(8);
    const ranges = [0, 1].map(() => ({ lo: 0, hi: 1, gaps: false }));
    const filled = (mesh: WireMesh, vertices: number, cells: Int32Array): WireMesh => {
        mesh.beginVertices({ all: [], count: 0 }, vertices);
        mesh.position.values.fill(7, 0, 3 * vertices);
        for (const { values } of mesh.codes) values.fill(9, 0, vertices);
        mesh.appendCells(cells);
        mesh.cellsChanged(0);
        return mesh;
    };
    const some = (cells: number, vertices: number): Int32Array =>
        Int32Array.from({ length: 8 * cells }, (_, i) => ((i & 7) < 4 ? random() % vertices : -1));
    const before = filled(new WireMesh(16, ranges), 500, some(400, 500));
    before.position.change.fill(3);
    const cells = some(100, 120);
    const own = filled(new WireMesh(16, ranges), 120, cells);
    const again = filled(new WireMesh(16, ranges, before), 120, cells);
    expect(again.stateSum()).toBe(own.stateSum());
    expect(again.position.change.slice(0, 360)).toEqual(own.position.change.slice(0, 360));
    for (const name of ['highest', 'lowest', 'beside', 'beside2', 'opposite'] as const) {
        expect(again.neighbours[name].slice(0, 120)).toEqual(own.neighbours[name].slice(0, 120));
    }
});
