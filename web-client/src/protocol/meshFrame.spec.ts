import { expect, test } from 'vitest';
import { crc32, frameHeaderBytes, readFrame, sameUpdate, surfaceOf } from './meshFrame.ts';
import { Dice, randomStep, seededRandom } from './testing/randomSurface.ts';
import { emptyState, sealed, writeUpdate } from './testing/wireWriter.ts';

const { edit, wanted, options } = randomStep(emptyState(), new Dice(seededRandom(3)), 0, true);
const { frames } = writeUpdate(emptyState(), edit, wanted, { ...options, phase: 1, history: true });
const good = frames[0]!;

/** With the checksum made right again, so that the other checks are reached. */
function changed(offset: number, value: number, size = 4): Uint8Array {
    const bytes = good.slice();
    const view = new DataView(bytes.buffer);
    if (size === 1) view.setUint8(offset, value);
    else if (size === 2) view.setUint16(offset, value, true);
    else view.setUint32(offset, value, true);
    return sealed(bytes);
}

test('reads the header of a frame', () => {
    const { header, body } = readFrame(good);
    expect(header).toMatchObject({ key: true, lossless: false, surface: 3, epoch: 1, seq: 0 });
    expect(header).toMatchObject({ phase: 'refined', latticeBits: 12, attributeCount: 3, time: 0, frameIndex: 0 });
    expect(header).toMatchObject({ frameCount: frames.length, vertices: 30, cells: wanted.cells.length });
    expect(body.length + frameHeaderBytes).toBe(good.length);
    expect(surfaceOf(good)).toBe(3);
});

test('reads a frame that starts anywhere in its buffer', () => {
    const shifted = new Uint8Array(good.length + 5);
    shifted.set(good, 5);
    expect(readFrame(shifted.subarray(5)).header).toEqual(readFrame(good).header);
});

test('knows the frames of one update', () => {
    const [first, ...others] = frames.map((frame) => readFrame(frame).header);
    expect(others.length).toBeGreaterThan(0);
    for (const other of others) expect(sameUpdate(first!, other)).toBe(true);
    for (const name of ['seq', 'epoch', 'time', 'cells', 'stateSum'] as const) {
        expect(sameUpdate(first!, { ...first!, [name]: first![name] + 1 })).toBe(false);
    }
});

test('refuses a frame with any flipped bit', () => {
    for (let bit = 0; bit < 8 * good.length; ++bit) {
        const bytes = good.slice();
        bytes[bit >> 3]! ^= 1 << (bit & 7);
        expect(() => readFrame(bytes)).toThrow();
    }
});

test('refuses a frame cut off or followed by more', () => {
    for (let size = 0; size < good.length; ++size) expect(() => readFrame(good.subarray(0, size))).toThrow();
    expect(() => readFrame(Uint8Array.of(...good, 0))).toThrow();
});

test('refuses a header that cannot be true', () => {
    expect(readFrame(changed(4, 8)).header.surface).toBe(8);
    expect(readFrame(changed(22, 8, 1)).header.attributeCount).toBe(8);
    for (const bad of [
        changed(2, 3, 1), // version
        changed(3, 4 + 1, 1), // unknown flag
        changed(3, 0, 1), // a DELTA without an update before it
        changed(16, frames.length, 2), // beyond the last frame
        changed(18, 0, 2), // no frames
        changed(20, 4, 1), // phase
        changed(21, 0, 1), // lattice bits
        changed(21, 21, 1),
        changed(22, 9, 1), // attributes
        changed(23, 8, 1), // gaps of a fourth attribute
        changed(24, (1 << 24) + 1), // vertices
        changed(28, 0xffffffff), // cells
        changed(36, 0x7ff00000), // time
    ]) {
        expect(() => readFrame(bad)).toThrow();
    }
});

const text = new TextEncoder();

function bitwise(bytes: Uint8Array): number {
    let crc = 0xffffffff;
    for (const byte of bytes) {
        crc ^= byte;
        for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ ((crc & 1) !== 0 ? 0xedb88320 : 0);
    }
    return ~crc >>> 0;
}

test('gives the published check values', () => {
    expect(crc32(text.encode('123456789'))).toBe(0xcbf43926);
    expect(crc32(new Uint8Array(0))).toBe(0);
    expect(crc32(new Uint8Array(32))).toBe(0x190a55ad);
    expect(crc32(new Uint8Array(32).fill(0xff))).toBe(0xff6cab0b);
    expect(crc32(Uint8Array.from({ length: 32 }, (_, i) => i))).toBe(0x91267e8a);
});

test('equals its definition for every length and alignment', () => {
    const bytes = Uint8Array.from({ length: 67 }, (_, i) => i * i * 31 + 7);
    for (let from = 0; from < 8; ++from) {
        for (let to = from; to <= bytes.length; ++to) {
            expect(crc32(bytes.subarray(from, to))).toBe(bitwise(bytes.subarray(from, to)));
        }
    }
});

test('of a whole is that of its parts in turn', () => {
    const bytes = text.encode('quads with hanging nodes, column by column');
    for (let cut = 0; cut <= bytes.length; ++cut) {
        expect(crc32(bytes.subarray(cut), crc32(bytes.subarray(0, cut)))).toBe(crc32(bytes));
    }
});
