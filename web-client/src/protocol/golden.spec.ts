// The frames that the C++ side wrote, against what its decoder made of them.
import { beforeAll, describe, expect, test } from 'vitest';
import type { DracoPoints } from './dracoPoints.ts';
import { FrameError } from './bytes.ts';
import { dequantise } from './lattice.ts';
import { type AppliedUpdate, MeshDecoder } from './meshDecoder.ts';
import { frameHeaderBytes, phases } from './meshFrame.ts';
import { lastCode, wordSum } from './wireMesh.ts';
import { dracoPoints, golden, goldenFrames, type GoldenVertex } from './testing/golden.ts';
import { seededRandom } from './testing/randomSurface.ts';
import { sealed } from './testing/wireWriter.ts';

let points: DracoPoints;
beforeAll(async () => {
    points = await dracoPoints();
});

describe.each(Object.entries(golden))('the golden frames %s', (name, expected) => {
    const frames = goldenFrames(name);
    const decoder = (): MeshDecoder => new MeshDecoder(points, expected.lattice, expected.attributes);

    test('decode to what the C++ decoder makes of them, to the bit, update by update', () => {
        expect(frames).toHaveLength(expected.frames);
        const into = decoder();
        const [seqs, sums, changeSums]: number[][] = [[], [], []];
        let last: AppliedUpdate | undefined;
        for (const frame of frames) {
            const applied = into.fold(frame);
            if (applied === undefined) continue;
            last = applied;
            seqs!.push(applied.header.seq);
            sums!.push(applied.mesh.stateSum());
            changeSums!.push(wordSum(applied.mesh.position.change.subarray(0, 3 * applied.mesh.vertices)));
        }
        expect(seqs).toEqual(expected.seqs);
        expect(sums).toEqual(expected.stateSums);
        expect(changeSums).toEqual(expected.changeSums);
        const { header, mesh } = last!;
        const { surface, epoch, lossless, time } = expected;
        expect(header).toMatchObject({ surface, epoch, lossless, time, phase: phases[expected.phase] });
        expect([mesh.vertices, mesh.cellCount]).toEqual([expected.vertices, expected.cells]);
        if (expected.firstVertex === undefined) return;
        const vertex = (v: number): GoldenVertex => {
            const node = mesh.position.values.subarray(3 * v, 3 * v + 3);
            const position = new Float32Array(3);
            dequantise(expected.lattice, node, position);
            const codes = mesh.codes.map(({ values }) => values[v]!);
            const change = [...mesh.position.change.subarray(3 * v, 3 * v + 3)];
            const attributes = codes.map((code, i) => {
                const { lo, hi } = mesh.ranges[i]!;
                return Math.fround(lo + ((hi - lo) * code) / lastCode);
            });
            return { node: [...node], change, codes, position: [...position], attributes };
        };
        expect(vertex(0)).toEqual(expected.firstVertex);
        expect(vertex(expected.vertices - 1)).toEqual(expected.lastVertex);
        expect([...Uint32Array.from(mesh.cells.subarray(0, 8))]).toEqual(expected.firstCell);
        expect([...Uint32Array.from(mesh.cells.subarray(-8))]).toEqual(expected.lastCell);
    });

    test('are refused when mutated or cut off', () => {
        const random = seededRandom(11);
        const [good] = frames;
        for (let i = 0; i < 500; ++i) {
            const bad = i % 2 === 0 ? good!.slice() : good!.subarray(0, random() % good!.length);
            if (i % 2 === 0) bad[random() % bad.length]! ^= 1 + (random() % 255);
            expect(() => decoder().fold(bad)).toThrow();
        }
    });
});

test('entropy-coded blocks damaged behind a right checksum are refused, soon and in little memory', () => {
    const random = seededRandom(23);
    let refused = 0;
    let slowest = 0;
    for (let i = 0; i < 1500; ++i) {
        const name = ['hanging', 'refined', 'chaos'][i % 3]!;
        const bad = goldenFrames(name)[0]!;
        const { lattice, attributes } = golden[name]!;
        for (let k = random() % 3; k >= 0; --k) {
            bad[frameHeaderBytes + (random() % (bad.length - frameHeaderBytes))]! ^= 1 + (random() % 255);
        }
        const into = new MeshDecoder(points, lattice, attributes);
        const start = performance.now();
        try {
            // Ranges are not part of the checksum of the state: they may have changed.
            const applied = into.fold(sealed(bad));
            expect(applied?.mesh.stateSum()).toBe(golden[name]!.stateSums[0]);
        } catch (error) {
            expect(error).toBeInstanceOf(FrameError);
            ++refused;
        }
        slowest = Math.max(slowest, performance.now() - start);
    }
    expect(refused).toBeGreaterThan(1000);
    expect(slowest).toBeLessThan(2000);
    expect(points.heapBytes).toBeLessThan(256 << 20);
}, 60_000);
