import { expect, test } from 'vitest';
import { cellStride, decodeCells, noVertex } from './cellsCode.ts';
import { seededRandom } from './testing/random.ts';
import { writeCells } from './testing/wireWriter.ts';

const n = noVertex;


function decode(code: number[], count: number, vertices: number): number[][] {
    const cells = new Int32Array(count * cellStride);
    decodeCells(Uint8Array.from(code), vertices, cells);
    return Array.from({ length: count }, (_, i) => [...cells.subarray(i * cellStride, (i + 1) * cellStride)]);
}

test('reads a strip between two columns of ten: one explicit cell, then a run', () => {
    // 0x60: both ends predicted; corner 0 = 0, corner 1 = 0 + 10 (zigzag 20); then 0xf0: a run of 2.
    expect(decode([0x60, 0, 20, 0xf0, 2], 3, 20)).toEqual([
        [0, 10, 11, 1, n, n, n, n],
        [1, 11, 12, 2, n, n, n, n],
        [2, 12, 13, 3, n, n, n, n],
    ]);
});

test('reads mids along both columns and across', () => {
    // 0x6f: all mids; left mid as predicted, right mid as predicted, mid 0 = 0 + 5, mid 2 = 5 + 1.
    expect(decode([0x6f, 0, 20, 0, 0, 10, 2], 1, 20)).toEqual([[0, 10, 12, 2, 5, 11, 6, 1]]);
});

/// Two strips with hanging nodes, and a run: 8 cells of vertices below 30.
const mixed = [
    ...writeCells([
        [0, 10, 11, 1, n, n, n, n],
        [1, 11, 13, 2, n, 12, n, n],
        [2, 13, 14, 4, 25, n, 26, 3],
        [10, 20, 21, 11, n, n, n, n],
        [11, 21, 22, 13, n, n, n, 12],
    ]),
    ...[0xf0, 3],
];

test('refuses every truncation, more cells, fewer cells and fewer vertices', () => {
    const count = 8;
    expect(decode(mixed, count, 30)).toHaveLength(count);
    for (let size = 0; size < mixed.length; size += 1)
        expect(() => decode(mixed.slice(0, size), count, 30)).toThrow();
    expect(() => decode(mixed, count - 1, 30)).toThrow();
    expect(() => decode(mixed, count + 1, 30)).toThrow();
    expect(() => decode(mixed, count, 8)).toThrow();
});

test('refuses impossible runs and numbers of more than 32 bits', () => {
    for (const code of [[0xf0, 0], [0xf0, 9], [0xf1, 1, 0], [0xf0, 255, 255, 255, 255, 31], [0x10, 255, 255, 255, 255, 16]])
        expect(() => decode(code, 8, 100)).toThrow();
    expect(() => decode([0xf0, 8], 8, 8)).toThrow();
    expect(decode([0xf0, 8], 8, 100)).toHaveLength(8);
});

test('survives mutations with ids in range or an error', () => {
    const random = seededRandom(7);
    let survived = 0;
    for (let i = 0; i < 20_000; i += 1) {
        const bad = [...mixed];
        for (let k = random() % 4; k >= 0; k -= 1)
            bad[random() % bad.length] = random() & 0xff;
        let cells: number[][];
        try {
            cells = decode(bad, 8, 30);
        } catch {
            continue;
        }
        survived += 1;
        expect(cells.flat().every((id) => (id >= 0 && id < 30) || id === noVertex)).toBe(true);
    }
    expect(survived).toBeGreaterThan(20);
});
