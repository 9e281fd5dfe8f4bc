import { beforeAll, describe, expect, test } from 'vitest';
import { crc32c } from './crc32c.ts';
import type { DracoPoints } from './dracoPoints.ts';
import { MeshDecoder } from './meshDecoder.ts';
import { frameHeaderBytes } from './meshFrame.ts';
import { dracoPoints, golden, goldenFrames, type GoldenVertex, seededRandom } from './testing/golden.ts';

let points: DracoPoints;
beforeAll(async () => {
    points = await dracoPoints();
});

function decoderOf(name: string): MeshDecoder {
    const { lattice, attributes } = golden[name]!;
    return new MeshDecoder(points, lattice, attributes);
}

function sealed(bytes: Uint8Array): Uint8Array {
    const crc = crc32c(bytes.subarray(frameHeaderBytes), crc32c(bytes.subarray(0, 48)));
    new DataView(bytes.buffer).setUint32(48, crc, true);
    return bytes;
}

describe.each(Object.entries(golden))('the golden frames %s', (name, expected) => {
    test('decode to what the C++ decoder makes of them, to the bit', () => {
        const decoder = decoderOf(name);
        const frames = goldenFrames(name);
        expect(frames).toHaveLength(expected.frames);
        for (const frame of frames)
            decoder.fold(frame);
        const mesh = decoder.mesh!;
        const { surface, epoch, seq, complete, final, stateCrc } = expected;
        expect(mesh).toMatchObject({ surface, epoch, seq, complete, final, stateCrc });
        expect([mesh.vertexCount, mesh.cellCount]).toEqual([expected.vertices, expected.cells]);
        expect(crc32c(mesh.positions)).toBe(expected.positionCrc);
        expect(Object.keys(mesh.attributes)).toEqual(expected.attributes);
        expect(Object.values(mesh.attributes).reduce((crc, values) => crc32c(values, crc), 0)).toBe(
            expected.attributeCrc,
        );
        const vertex = (i: number): GoldenVertex => ({
            node: [...mesh.nodes.subarray(3 * i, 3 * i + 3)],
            position: [...mesh.positions.subarray(3 * i, 3 * i + 3)],
            attributes: Object.values(mesh.attributes).map((values) => values[i]!),
        });
        if (expected.firstVertex !== undefined) {
            expect(vertex(0)).toEqual(expected.firstVertex);
            expect(vertex(expected.vertices - 1)).toEqual(expected.lastVertex);
            expect([...mesh.cells.subarray(0, 8)]).toEqual(expected.firstCell);
            expect([...mesh.cells.subarray(-8)]).toEqual(expected.lastCell);
        }
    });

    test('are refused when mutated or cut off', () => {
        const random = seededRandom(11);
        const [good] = goldenFrames(name);
        for (let i = 0; i < 2000; i += 1) {
            const bad = i % 2 === 0 ? good!.slice() : good!.subarray(0, random() % good!.length);
            if (i % 2 === 0)
                bad[random() % bad.length]! ^= 1 + (random() % 255);
            expect(() => decoderOf(name).fold(bad)).toThrow();
        }
    });
});

test('frames lost, repeated or reordered are refused until a new mesh starts', () => {
    const [a, b] = goldenFrames('chunked');
    for (const frames of [[b!], [a!, a!], [a!, b!, b!]]) {
        const decoder = decoderOf('chunked');
        for (const frame of frames.slice(0, -1))
            decoder.fold(frame);
        expect(() => decoder.fold(frames.at(-1)!)).toThrow();
        expect(decoder.mesh).toBeUndefined();
        expect(() => decoder.fold(b!)).toThrow();
    }
});

test('a mesh is complete only after its last frame', () => {
    const [a, b] = goldenFrames('chunked');
    const decoder = decoderOf('chunked');
    expect(decoder.fold(a!).last).toBe(false);
    expect(decoder.mesh!.complete).toBe(false);
    decoder.fold(b!);
    expect(decoder.mesh!.complete).toBe(true);
});

test('a mesh taken is whole, and its buffers are no longer used', () => {
    const [coarse, final] = goldenFrames('refined');
    const decoder = decoderOf('refined');
    decoder.fold(coarse!);
    const mesh = decoder.take()!;
    expect(mesh).toMatchObject({ complete: true, final: false, vertexCount: 24 });
    const sum = crc32c(mesh.positions);
    decoder.fold(final!);
    expect(decoder.mesh).toMatchObject({ complete: true, final: true, vertexCount: 108 });
    expect(crc32c(mesh.positions)).toBe(sum);
    expect(() => decoder.fold(coarse!)).toThrow();
});

test('damage behind a right checksum is an error or changes attributes only, and leaks nothing', () => {
    const random = seededRandom(23);
    const [good] = goldenFrames('hanging');
    const expected = golden['hanging']!.positionCrc;
    for (let i = 0; i < 1000; i += 1) {
        const bad = good!.slice();
        bad[random() % bad.length]! ^= 1 + (random() % 255);
        const decoder = decoderOf('hanging');
        try {
            decoder.fold(sealed(bad));
        } catch {
            continue;
        }
        expect(crc32c(decoder.mesh!.positions)).toBe(expected);
    }
    const heap = points.heapBytes;
    for (let i = 0; i < 300; i += 1)
        decoderOf('hanging').fold(good!);
    expect(points.heapBytes).toBe(heap);
});
