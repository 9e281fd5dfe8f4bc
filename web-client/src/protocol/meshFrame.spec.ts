import { expect, test } from 'vitest';
import { frameHeaderBytes, readFrame, sameUpdate, surfaceOf } from './meshFrame.ts';
import { Dice, randomStep } from './testing/randomSurface.ts';
import { seededRandom } from './testing/random.ts';
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
    const { header, ranges, topology, points } = readFrame(good);
    expect(header).toMatchObject({ key: true, lossless: false, history: true, surface: 3, epoch: 1, seq: 0, baseSeq: 0 });
    expect(header).toMatchObject({ phase: 'refined', latticeBits: 12, attributeCount: 3, time: 0, frameIndex: 0 });
    expect(header).toMatchObject({ frameCount: frames.length, vertices: 30, cells: wanted.cells.length });
    expect(ranges).toEqual([
        { lo: -1, hi: 3 },
        { lo: 0, hi: 1 },
        { lo: 2, hi: 2 },
    ]);
    expect(topology.length + points.length + frameHeaderBytes + 24).toBe(good.length);
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
    for (const bad of [
        changed(2, 1, 1), // version
        changed(3, 8, 1), // unknown flag
        changed(3, 4, 1), // changes without a KEY
        changed(16, 1), // a KEY based on another update
        changed(20, frames.length, 2), // beyond the last frame
        changed(22, 0, 2), // no frames
        changed(24, 4, 1), // phase
        changed(25, 0, 1), // lattice bits
        changed(25, 21, 1),
        changed(26, 2, 1), // attributes
        changed(26, 8, 1),
        changed(27, 1, 1), // reserved
        changed(28, (1 << 24) + 1), // vertices
        changed(32, 0xffffffff), // cells
        changed(36, 0), // less topology than this frame has
        changed(44, 0x7ff00000), // time
        changed(48, 1), // parts
        changed(52, 0xffffffff),
        changed(64, 0x7fc00000), // a range from NaN
    ]) {
        expect(() => readFrame(bad)).toThrow();
    }
});
