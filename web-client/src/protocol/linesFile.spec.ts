import { describe, expect, it } from 'vitest';
import { linesFileOf } from './testing/linesFile.ts';
import { readLinesFile } from './linesFile.ts';

describe('a file of streamlines', () => {
    it('has lines, values and what was left out', () => {
        const read = readLinesFile(
            linesFileOf({
                lines: [
                    [[1, 2, 3, 0.5]],
                    [
                        [4, 5, 6, Number.NaN],
                        [7, 8, 9, -1],
                    ],
                ],
                outside: 3,
                cut: 2,
            }),
        );
        expect([...read.offsets]).toEqual([0, 1, 3]);
        expect([...read.points]).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9]);
        expect([...read.values]).toEqual([0.5, Number.NaN, -1]);
        expect(read).toMatchObject({ seeds: 5, outside: 3, origin: [10, 0, 0], ends: { cut: 2 } });
    });

    it('that is cut, or of another kind, is refused', () => {
        const good = linesFileOf({ lines: [[[1, 2, 3, 0.5]]] });
        for (let size = 0; size < good.byteLength; size += 4) {
            expect(() => readLinesFile(good.slice(0, size))).toThrow('cannot read');
        }
        for (const at of [0, 4, 8, 88, 92]) {
            const bad = good.slice(0);
            new DataView(bad).setUint8(at, 77);
            expect(() => readLinesFile(bad), String(at)).toThrow('cannot read');
        }
    });
});
