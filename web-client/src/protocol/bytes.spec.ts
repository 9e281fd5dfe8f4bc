import { deflateRawSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { FrameError, Numbers } from './bytes.ts';
import { seededRandom } from './testing/randomSurface.ts';

function varint(value: number): number[] {
    return value < 0x80 ? [value] : [(value & 0x7f) | 0x80, ...varint(value >>> 7)];
}

/** An update of numbers as bytes, and one byte behind them. */
function packed(varints: number[], announced = varints.length): Uint8Array {
    const bytes = deflateRawSync(Uint8Array.from(varints));
    return Uint8Array.from([...varint(bytes.length), ...varint(announced), ...bytes, 77]);
}

test('reads numbers of any size, one after the other, and what follows them', () => {
    const random = seededRandom(5);
    const all = [0, 127, 128, 0xffffffff, ...Array.from({ length: 3000 }, () => random() >>> (random() % 32))];
    const numbers = new Numbers(packed(all.flatMap(varint)));
    expect(numbers.left).toBe(all.length);
    expect(all.map(() => numbers.next())).toEqual(all);
    expect([...numbers.rest]).toEqual([77]);
    expect(() => numbers.next()).toThrow(FrameError);
});

test('refuses numbers that are too large, cut off, missing, or more than announced', () => {
    expect(() => new Numbers(packed([5])).next(4)).toThrow(FrameError);
    expect(() => new Numbers(packed([1, 2])).take(3)).toThrow(FrameError);
    for (const varints of [[0x80], [0xff, 0xff, 0xff, 0xff, 0x10], [0xff, 0xff, 0xff, 0xff, 0xff, 1]]) {
        expect(() => new Numbers(packed(varints))).toThrow(FrameError);
    }
    expect(() => new Numbers(packed([1, 2, 3], 2))).toThrow(FrameError);
    expect(() => new Numbers(packed([1, 2, 3], 4))).toThrow(FrameError);
});

test('takes no more memory than deflate could fill from the bytes', () => {
    expect(() => new Numbers(packed([1, 2, 3], 0xffffffff))).toThrow(/more numbers than it can hold/);
});

test('refuses an update cut off anywhere in its numbers', () => {
    const whole = packed(Array.from({ length: 200 }, (_, i) => i % 128));
    for (let size = 0; size + 1 < whole.length; ++size) expect(() => new Numbers(whole.subarray(0, size))).toThrow(FrameError);
});
