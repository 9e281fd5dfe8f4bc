import { expect, test } from 'vitest';
import { cellStride, noVertex } from './cell.ts';
import { decodeCells } from './cellsCode.ts';
import { FrameError } from './frameError.ts';
import { nothingKept, type PlainKept, writeCells } from './testing/cellsWriter.ts';
import { seededRandom } from './testing/random.ts';

const n = noVertex;

function decode(code: number[], count: number, vertices: number, kept: PlainKept = nothingKept): number[][] {
    const all = kept.replaced.flatMap((is, i) => (is ? [{ begin: i, end: i + 1 }] : []));
    const cells = decodeCells(Uint8Array.from(code), count, {
        vertices,
        stay: kept.stay,
        kept: Int32Array.from(kept.cells.flat()),
        replaced: { all, count: all.length },
        near: kept.cells.flatMap((cell, i) => (!kept.replaced[i] && cell.some((v) => kept.touched.has(v)) ? [i] : [])),
    });
    return Array.from({ length: count }, (_, i) => [...cells.subarray(i * cellStride, (i + 1) * cellStride)]);
}

/** Columns of ten. */
function strip(column: number, cells: number): number[][] {
    return Array.from({ length: cells }, (_, i) => {
        const at = 10 * column + i;
        return [at, at + 10, at + 11, at + 1, n, n, n, n];
    });
}

test('reads a sheet, whose later cells are as expected and cost hardly a byte', () => {
    const sheet = [...strip(0, 9), ...strip(1, 9), ...strip(2, 9), ...strip(3, 9)];
    const code = writeCells(sheet, nothingKept, 50);
    expect(decode(code, 36, 50)).toEqual(sheet);
    expect(code.length).toBeLessThan(36);
});

/** Two strips with hanging nodes: 5 cells of vertices below 30. */
const mixed = [
    [0, 10, 11, 1, n, n, n, n],
    [1, 11, 13, 2, n, 12, n, n],
    [2, 13, 14, 4, 25, n, 26, 3],
    [10, 20, 21, 11, n, n, n, n],
    [11, 21, 22, 13, n, n, n, 12],
];

test('reads what replaces a cell and what fills a hole from the cells around it', () => {
    const cells = [...strip(0, 3), ...strip(1, 3)];
    const touched = new Set([1, 11, 12, 2]);
    const kept: PlainKept = { cells, replaced: cells.map((_, i) => i === 1), touched, stay: 24 };
    const wanted = [
        [1, 11, 24, 25, n, n, n, n],
        [25, 24, 12, 2, n, n, n, n],
    ];
    const code = writeCells(wanted, kept, 26);
    expect(decode(code, 2, 26, kept)).toEqual(wanted);
});

test('looks, of many cells that stay, at the last 4096 and at those by a change', () => {
    const cells = Array.from({ length: 500 }, (_, column) => strip(column, 9)).flat();
    const touched = new Set([33, 43, 44, 34]);
    const kept: PlainKept = { cells, replaced: cells.map((_, i) => i === 30), touched, stay: 5010 };
    const added = [...strip(500, 9), [25, 26, 5020, 24, n, n, n, n], [4000, 4010, 4011, 4001, n, n, n, n]];
    const wanted = [[33, 43, 44, 34, n, n, n, n], ...added];
    const code = writeCells(wanted, kept, 5021);
    expect(decode(code, wanted.length, 5021, kept)).toEqual(wanted);
});

test('refuses every truncation, more cells, fewer cells and fewer vertices', () => {
    const code = writeCells(mixed, nothingKept, 30);
    expect(decode(code, 5, 30)).toEqual(mixed);
    for (let size = 0; size < code.length; ++size) expect(() => decode(code.slice(0, size), 5, 30)).toThrow(FrameError);
    expect(() => decode([...code, 0], 5, 30)).toThrow(FrameError);
    expect(() => decode(code, 0, 30)).toThrow(FrameError);
    expect(() => decode(code, 500, 30)).toThrow(FrameError);
    expect(() => decode(code, 5, 8)).toThrow(FrameError);
});

test('survives mutations with ids in range or an error', () => {
    const random = seededRandom(7);
    const code = writeCells(mixed, nothingKept, 30);
    let survived = 0;
    for (let i = 0; i < 20_000; ++i) {
        const bad = [...code];
        for (let k = random() % 4; k >= 0; --k) bad[random() % bad.length] = random() & 0xff;
        let cells: number[][];
        try {
            cells = decode(bad, 5, 30);
        } catch (error) {
            expect(error).toBeInstanceOf(FrameError);
            continue;
        }
        ++survived;
        expect(cells.flat().every((id) => (id >= 0 && id < 30) || id === noVertex)).toBe(true);
    }
    expect(survived).toBeGreaterThan(20);
}, 60_000);
