import { expect, test } from 'vitest';
import { crc32c } from './crc32c.ts';
import { frameHeaderBytes, readFrame, surfaceOf } from './meshFrame.ts';
import { goldenFrames } from './testing/golden.ts';

const [good] = goldenFrames('hanging');

/// With the checksum made right again, so that the other checks are reached.
function changed(offset: number, value: number, size = 4): Uint8Array {
    const bytes = good!.slice();
    const view = new DataView(bytes.buffer);
    if (size === 1)
        view.setUint8(offset, value);
    else
        view.setUint32(offset, value, true);
    view.setUint32(48, crc32c(bytes.subarray(frameHeaderBytes), crc32c(bytes.subarray(0, 48))), true);
    return bytes;
}

test('reads the header of a golden frame', () => {
    const { header, ranges, draco, cells } = readFrame(good!);
    expect(header).toMatchObject({ first: true, last: true, final: true, surface: 1, epoch: 3, seq: 0 });
    expect(header).toMatchObject({ vertexBase: 0, vertexCount: 640, cellBase: 0, latticeBits: 16 });
    expect(ranges).toHaveLength(3);
    expect(draco.length + cells.length + frameHeaderBytes + 24).toBe(good!.length);
    expect(surfaceOf(good!)).toBe(1);
});

test('reads a frame that starts anywhere in its buffer', () => {
    const shifted = new Uint8Array(good!.length + 5);
    shifted.set(good!, 5);
    expect(readFrame(shifted.subarray(5)).header).toEqual(readFrame(good!).header);
});

test('refuses a frame with any flipped bit', () => {
    for (let bit = 0; bit < 8 * good!.length; bit += 1) {
        const bytes = good!.slice();
        bytes[bit >> 3]! ^= 1 << (bit & 7);
        expect(() => readFrame(bytes)).toThrow();
    }
});

test('refuses a frame cut off or followed by more', () => {
    for (let size = 0; size < good!.length; size += 1)
        expect(() => readFrame(good!.subarray(0, size))).toThrow();
    expect(() => readFrame(Uint8Array.of(...good!, 0))).toThrow();
});

test('refuses a header that cannot be true', () => {
    expect(readFrame(changed(4, 8)).header.surface).toBe(8);
    for (const bad of [
        changed(2, 2, 1), // version
        changed(3, 8, 1), // unknown flag
        changed(16, 1), // first, yet not from vertex 0
        changed(20, 0), // points for no vertices
        changed(20, 1 << 17),
        changed(28, 0), // code for no cells
        changed(28, 1 << 19),
        changed(32, 2, 1), // attributes
        changed(33, 0, 1), // lattice bits
        changed(33, 21, 1),
        changed(36, 1), // Draco bytes
        changed(40, 0xffffffff), // cell bytes
        changed(52, 0x7fc00000), // a range from NaN
    ])
        expect(() => readFrame(bad)).toThrow();
});
