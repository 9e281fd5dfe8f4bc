import { expect, test } from 'vitest';
import { cellStride, decodeCells, noVertex } from './cellsCode.ts';
import { readFrame } from './meshFrame.ts';
import { goldenFrames, seededRandom } from './testing/golden.ts';

const n = noVertex;

function decode(code: number[], count: number, vertices: number): number[][] {
    const cells = new Uint32Array(count * cellStride);
    decodeCells(Uint8Array.from(code), count, vertices, cells);
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

test('refuses every truncation, more cells, fewer cells and fewer vertices', () => {
    const [first] = goldenFrames('hanging');
    const { header, cells: code } = readFrame(first!);
    const cells = new Uint32Array((header.cellCount + 1) * cellStride);
    for (let size = 0; size < code.length; size += 1)
        expect(() => decodeCells(code.subarray(0, size), header.cellCount, header.vertexCount, cells)).toThrow();
    expect(() => decodeCells(code, header.cellCount - 1, header.vertexCount, cells)).toThrow();
    expect(() => decodeCells(code, header.cellCount + 1, header.vertexCount, cells)).toThrow();
    expect(() => decodeCells(code, header.cellCount, 10, cells)).toThrow();
});

test('refuses impossible runs and numbers of more than 32 bits', () => {
    for (const code of [[0xf0, 0], [0xf0, 9], [0xf1, 1, 0], [0xf0, 255, 255, 255, 255, 31], [0x10, 255, 255, 255, 255, 16]])
        expect(() => decode(code, 8, 100)).toThrow();
    expect(() => decode([0xf0, 8], 8, 8)).toThrow();
    expect(decode([0xf0, 8], 8, 100)).toHaveLength(8);
});

test('survives mutations with ids in range or an error', () => {
    const [first] = goldenFrames('hanging');
    const { header, cells: code } = readFrame(first!);
    const cells = new Uint32Array(header.cellCount * cellStride);
    const random = seededRandom(7);
    for (let i = 0; i < 5000; i += 1) {
        const bad = code.slice();
        for (let k = random() % 4; k >= 0; k -= 1)
            bad[random() % bad.length] = random();
        try {
            decodeCells(bad, header.cellCount, header.vertexCount, cells);
        } catch {
            continue;
        }
        expect(cells.every((id) => id < header.vertexCount || id === noVertex)).toBe(true);
    }
});
