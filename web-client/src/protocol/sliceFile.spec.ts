import { describe, expect, it } from 'vitest';
import { noSliceValue, readSliceFile, sliceCodes, sliceNumbers, usualRange } from './sliceFile.ts';

/** Returns the bytes of a raster as the server writes them. */
export function sliceBytes(columns: number, codes: readonly number[], range: [number, number] = [0, 1]): ArrayBuffer {
    const bytes = new ArrayBuffer(112 + 2 * codes.length);
    const view = new DataView(bytes);
    [0x57, 0x53, 0x4c, 1].forEach((byte, i) => view.setUint8(i, byte));
    [columns, codes.length / columns, codes.length].forEach((count, i) => view.setUint32(4 + 4 * i, count, true));
    [1, 2, 3, 4, 0, 0, 0, 5, 0, 2.5, ...range].forEach((number, i) => view.setFloat64(16 + 8 * i, number, true));
    codes.forEach((code, i) => view.setUint16(112 + 2 * i, code, true));
    return bytes;
}

describe('the file of a slice', () => {
    it('is read as the format says', () => {
        const raster = readSliceFile(sliceBytes(2, [0, 7, noSliceValue, sliceCodes], [-1, 3]));
        expect(raster).toMatchObject({ columns: 2, rows: 2, inFlow: 4, time: 2.5, range: [-1, 3] });
        expect(raster).toMatchObject({ corner: [1, 2, 3], across: [4, 0, 0], up: [0, 5, 0] });
        expect([...raster.codes]).toEqual([0, 7, noSliceValue, sliceCodes]);
    });

    it('is refused where it is cut or something else', () => {
        const good = sliceBytes(2, [1, 2]);
        expect(() => readSliceFile(good.slice(0, 100))).toThrow('cannot read');
        expect(() => readSliceFile(good.slice(0, 114))).toThrow('cannot read');
        new DataView(good).setUint8(0, 0x58);
        expect(() => readSliceFile(good)).toThrow('cannot read');
    });

    it('has an area and a mean, of the part with values alone', () => {
        const half = sliceCodes / 2;
        const raster = readSliceFile(sliceBytes(2, [0, half, noSliceValue, noSliceValue], [2, 6]));
        expect(sliceNumbers(raster)).toEqual({ area: 10, mean: 3 }); // of a rectangle of 4 by 5
        expect(sliceNumbers(readSliceFile(sliceBytes(1, [noSliceValue])))).toBeNull();
    });

    it('has a usual range without the last per cent at each end', () => {
        const codes = [0, sliceCodes, ...Array.from({ length: 198 }, (_, i) => 20_000 + 100 * i)];
        const [low, high] = usualRange(readSliceFile(sliceBytes(20, codes, [0, sliceCodes])))!;
        expect(low).toBeGreaterThanOrEqual(20_000);
        expect(high).toBeLessThanOrEqual(39_800);
        expect(usualRange(readSliceFile(sliceBytes(1, [noSliceValue])))).toBeNull();
    });
});
