import { beforeAll, describe, expect, test } from 'vitest';
import type { DracoPoints } from './dracoPoints.ts';
import { FrameError } from './bytes.ts';
import { MeshDecoder } from './meshDecoder.ts';
import { frameHeaderBytes, readFrame } from './meshFrame.ts';
import { dracoPoints } from './testing/golden.ts';
import { Dice, lattice, randomUpdates, ranges, seededRandom, type Update } from './testing/randomSurface.ts';
import { type PlainState, sealed } from './testing/wireWriter.ts';
import { valueOf, type WireMesh } from './wireMesh.ts';

let points: DracoPoints;
beforeAll(async () => {
    points = await dracoPoints();
});

function decoder(): MeshDecoder {
    return new MeshDecoder(points, lattice, ranges.length);
}

function plain(mesh: WireMesh): PlainState {
    const rows = (values: Int32Array, n: number): number[][] =>
        Array.from({ length: mesh.vertices }, (_, v) => [...values.subarray(n * v, n * v + n)]);
    const codes = Array.from({ length: mesh.vertices }, (_, v) => mesh.codes.map(({ values }) => values[v]!));
    const cells = Array.from({ length: mesh.cellCount }, (_, i) => [...mesh.cells.subarray(8 * i, 8 * i + 8)]);
    return { positions: rows(mesh.position.values, 3), codes, changes: rows(mesh.position.change, 3), cells };
}

/** Folds until something is refused; true if nothing was. */
function accepts(into: MeshDecoder, frames: readonly Uint8Array[]): boolean {
    try {
        for (const frame of frames) into.fold(frame);
        return true;
    } catch (error) {
        expect(error).toBeInstanceOf(FrameError);
        expect(into.mesh).toBeUndefined();
        return false;
    }
}

describe('random sequences', () => {
    test('of a thousand frames decode to what a plain reading of the specification makes of them', () => {
        const into = decoder();
        let count = 0;
        for (const { frames, state } of randomUpdates(41, 450)) {
            for (const [i, frame] of frames.entries()) {
                ++count;
                const applied = into.fold(frame);
                expect(applied !== undefined).toBe(i + 1 === frames.length);
                if (applied === undefined) continue;
                expect(plain(applied.mesh)).toEqual(state);
            }
        }
        expect(count).toBeGreaterThan(1000);
    }, 60_000);

    test('come out alike from a KEY and from all updates before it', () => {
        const updates = randomUpdates(42, 60);
        const [early, late] = [decoder(), decoder()];
        let joined = 0;
        for (const [i, { frames }] of updates.entries()) {
            if (i > 0 && readFrame(frames[0]!).header.key) joined = i;
            expect(accepts(early, frames)).toBe(true);
            if (joined > 0) expect(accepts(late, frames)).toBe(true);
        }
        expect(joined).toBeGreaterThan(0);
        expect(plain(late.mesh!)).toEqual(plain(early.mesh!));
    });
});

describe('frames lost, repeated or reordered', () => {
    test('are refused, or do no harm, until a KEY', () => {
        const dice = new Dice(seededRandom(43));
        const updates = randomUpdates(44, 60);
        const right = updates.map(({ state }) => JSON.stringify(state));
        for (let round = 0; round < 20; ++round) {
            const frames = updates.flatMap((update) => update.frames);
            for (let changes = 1 + dice.below(3); changes > 0; --changes) {
                const at = dice.below(frames.length);
                const other = dice.below(frames.length);
                if (dice.oneIn(3)) frames.splice(at, 1);
                else if (dice.oneIn(2)) frames.splice(other, 0, frames[at]!);
                else [frames[at], frames[other]] = [frames[other]!, frames[at]!];
            }
            const into = decoder();
            let needsKey = true;
            for (const frame of frames) {
                try {
                    const applied = into.fold(frame);
                    if (applied === undefined) continue;
                    needsKey &&= !applied.header.key;
                    expect(needsKey).toBe(false);
                    expect(JSON.stringify(plain(applied.mesh))).toBe(right[applied.header.seq]);
                } catch (error) {
                    expect(error).toBeInstanceOf(FrameError);
                    needsKey = true;
                }
            }
        }
    });

    test('of another subscription are refused, unless the surface goes on there', () => {
        const [first, second] = randomUpdates(45, 2) as [Update, Update];
        const moved = second.frames.map((frame) => {
            const bytes = frame.slice();
            new DataView(bytes.buffer).setUint32(4, 99, true);
            return sealed(bytes);
        });
        const into = decoder();
        accepts(into, first.frames);
        expect(accepts(into, moved)).toBe(false);
        const other = decoder();
        accepts(other, first.frames);
        other.continueAs(99);
        expect(accepts(other, moved)).toBe(true);
        expect(plain(other.mesh!)).toEqual(second.state);
    });

    test('of an older epoch, or a KEY before the newest update, come too late', () => {
        const updates = randomUpdates(46, 3);
        const into = decoder();
        for (const { frames } of updates) accepts(into, frames);
        expect(into.newest).toMatchObject({ epoch: 1, seq: 2 });
        expect(() => updates[0]!.frames.forEach((frame) => into.fold(frame))).toThrow(/too late/);
    });
});

describe('damage', () => {
    test('of any byte, and any cut, is refused', () => {
        const [{ frames }] = randomUpdates(47, 1) as [Update];
        const [good] = frames as [Uint8Array];
        const random = seededRandom(48);
        for (let i = 0; i < 2000; ++i) {
            const bad = i % 2 === 0 ? good.slice() : good.subarray(0, random() % good.length);
            if (i % 2 === 0) bad[random() % bad.length]! ^= 1 + (random() % 255);
            expect(accepts(decoder(), [bad])).toBe(false);
        }
    });

    test('behind a right checksum is refused or makes no difference to the state', () => {
        const random = seededRandom(49);
        const updates = randomUpdates(50, 6);
        const contents = ({ positions, codes, cells }: PlainState): object => ({ positions, codes, cells });
        let refused = 0;
        for (let i = 0; i < 1500; ++i) {
            const hit = random() % updates.length;
            const sent = updates.slice(0, hit + 1).map(({ frames }) => frames.map((frame) => frame.slice()));
            const bytes = sent[hit]![random() % sent[hit]!.length]!;
            for (let k = random() % 3; k >= 0; --k) {
                const from = random() % 4 === 0 ? 0 : frameHeaderBytes;
                bytes[from + (random() % (bytes.length - from))]! ^= 1 + (random() % 255);
            }
            sealed(bytes);
            const into = decoder();
            if (!accepts(into, sent.flat())) ++refused;
            else if (into.mesh !== undefined)
            // What made the update look unfinished leaves the one before.
            {
                expect([hit, hit - 1].map((at) => updates[at] && contents(updates[at].state))).toContainEqual(
                    contents(plain(into.mesh)),
                );
            }
        }
        expect(refused).toBeGreaterThan(1000);
    }, 60_000);

    test('leaves nothing behind in the memory of Draco', () => {
        const updates = randomUpdates(51, 20);
        const run = (): void => {
            const into = decoder();
            for (const { frames } of updates) accepts(into, frames);
        };
        run();
        const heap = points.heapBytes;
        for (let i = 0; i < 60; ++i) run();
        expect(points.heapBytes).toBe(heap);
    });
});

describe('what is announced', () => {
    test('is limited before memory is reserved for it', () => {
        const [{ frames }] = randomUpdates(52, 1) as [Update];
        const announcing = (offset: number, value: number): Uint8Array[] =>
            frames.map((frame) => {
                const bytes = frame.slice();
                new DataView(bytes.buffer).setUint32(offset, value, true);
                return sealed(bytes);
            });
        for (const offset of [24, 28]) {
            for (const value of [0xffffffff, (1 << 24) + 1, 1 << 24]) {
                expect(accepts(decoder(), announcing(offset, value))).toBe(false);
            }
        }
    });
});

/** Returns the frame where some vertices have no value of the attributes whose bits are set. */
function withGaps(frame: Uint8Array, bits: number): Uint8Array {
    const bytes = frame.slice();
    bytes[23] = bits;
    return sealed(bytes);
}

test('a code near the last one is no value where the attribute has gaps, and gaps change with a KEY only', () => {
    const [first, second] = [...randomUpdates(43, 20)] as [Update, Update, ...Update[]];
    const into = decoder();
    const mesh = first.frames.map((frame) => into.fold(withGaps(frame, 0b001))).at(-1)!.mesh;
    const [speed, s] = mesh.ranges;
    expect([speed!.gaps, s!.gaps]).toEqual([true, false]);
    expect(valueOf(speed!, 0xf800)).toBeNaN();
    expect(valueOf(speed!, 65535)).toBeNaN();
    expect(valueOf(speed!, 0xefff)).toBe(speed!.hi);
    expect(valueOf(s!, 65535)).toBe(s!.hi);
    expect(valueOf(speed!, 0)).toBe(speed!.lo);
    expect(readFrame(second.frames[0]!).header.key).toBe(false);
    expect(accepts(into, second.frames)).toBe(false);
});
