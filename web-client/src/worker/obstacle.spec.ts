import { describe, expect, it } from 'vitest';
import type { BodyMesh } from '../mesh/meshChange.ts';
import { creaseNormals, framesOf } from './obstacle.ts';

describe('framesOf', () => {
    it('cuts the body at the lengths', () => {
        const bytes = Uint8Array.of(2, 0, 0, 0, 10, 11, 1, 0, 0, 0, 12);
        expect(framesOf(bytes).map((frame) => [...frame])).toEqual([[10, 11], [12]]);
        expect(framesOf(new Uint8Array())).toEqual([]);
    });

    it('refuses a body that ends within a frame', () => {
        expect(() => framesOf(Uint8Array.of(9, 0, 0, 0, 1))).toThrow(/incomplete/);
    });
});

type Point = [number, number, number];

/** Quads in two triangles each. */
function bodyOf(
    points: readonly Point[],
    quads: readonly (readonly number[])[],
): { positions: Float32Array; indices: Uint32Array } {
    const triangles = quads.flatMap(([a, b, c, d]) => (d === undefined ? [a, b, c] : [a, b, c, a, c, d])) as number[];
    return { positions: Float32Array.from(points.flat()), indices: Uint32Array.from(triangles) };
}

/** Round z, open at both ends. */
function tube(sides: number, radius = 1, middle: Point = [0, 0, 0]) {
    const ring = (z: number): Point[] =>
        Array.from({ length: sides }, (_, i) => {
            const angle = (2 * Math.PI * i) / sides;
            return [middle[0] + radius * Math.cos(angle), middle[1] + radius * Math.sin(angle), middle[2] + radius * z];
        });
    const quads = Array.from({ length: sides }, (_, i) => [i, (i + 1) % sides, sides + ((i + 1) % sides), sides + i]);
    return { points: [...ring(-1), ...ring(1)], quads };
}

const cube = (() => {
    const points = Array.from({ length: 8 }, (_, i): Point => [i & 1, (i >> 1) & 1, (i >> 2) & 1]);
    const quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    return { points, quads };
})();

interface Corner {
    place: number[];
    normal: number[];
    face: number[];
}

/** Returns the corners of all triangles, with the normals of these. */
function cornersOf({ positions, normals, indices }: BodyMesh): Corner[] {
    const at = (array: Float32Array, i: number): number[] => [...array.subarray(3 * i, 3 * i + 3)];
    return Array.from(indices, (vertex, corner) => {
        const [a, b, c] = [0, 1, 2].map((k) => at(positions, indices[corner - (corner % 3) + k]!)) as [
            number[],
            number[],
            number[],
        ];
        const [u, v] = [b.map((x, k) => x - a[k]!), c.map((x, k) => x - a[k]!)] as [number[], number[]];
        const cross = [u[1]! * v[2]! - u[2]! * v[1]!, u[2]! * v[0]! - u[0]! * v[2]!, u[0]! * v[1]! - u[1]! * v[0]!];
        const length = Math.hypot(...cross);
        return { place: at(positions, vertex), normal: at(normals, vertex), face: cross.map((x) => x / length) };
    });
}

const apart = (a: readonly number[], b: readonly number[]): number => Math.hypot(...a.map((x, k) => x - b[k]!));

describe('normals of a body', () => {
    it('are those of its faces where they meet at a right angle, with three vertices at each corner of a cube', () => {
        const made = creaseNormals(...(Object.values(bodyOf(cube.points, cube.quads)) as [Float32Array, Uint32Array]));
        expect(made.positions).toHaveLength(3 * 24);
        for (const { normal, face } of cornersOf(made)) expect(apart(normal, face)).toBeLessThan(1e-6);
    });

    it.each([1e-6, 1, 5e6])('point away from the axis of a tube of 16 sides, radius %d, which shares its vertices', (radius) => {
        const { points, quads } = tube(16, radius);
        const { positions, indices } = bodyOf(points, quads);
        const made = creaseNormals(positions, indices);
        expect(made.positions).toEqual(positions);
        expect(made.indices).toEqual(indices);
        for (const { place, normal } of cornersOf(made)) {
            const away = [place[0]! / radius, place[1]! / radius, 0];
            expect(apart(normal, away)).toBeLessThan(1e-5);
        }
    });

    it('leave a tube of ten sides its edges, since these meet at 36 degrees, and none to one of thirteen', () => {
        const smooth = (sides: number): number => {
            const { points, quads } = tube(sides);
            const { positions, indices } = bodyOf(points, quads);
            const corners = cornersOf(creaseNormals(positions, indices));
            return Math.max(...corners.map(({ normal, face }) => apart(normal, face)));
        };
        expect(smooth(10)).toBeLessThan(1e-6);
        expect(smooth(13)).toBeCloseTo(2 * Math.sin(Math.PI / 26), 5);
    });

    it('keep the rim of a closed tube sharp and its side round', () => {
        const { points, quads } = tube(24);
        const lid = Array.from({ length: 22 }, (_, i) => [24, 24 + i + 1, 24 + i + 2]);
        const { positions, indices } = bodyOf(points, [...quads, ...lid]);
        for (const { place, normal, face } of cornersOf(creaseNormals(positions, indices))) {
            const expected = face[2]! > 0.9 ? [0, 0, 1] : [place[0]!, place[1]!, 0];
            expect(apart(normal, expected)).toBeLessThan(1e-5);
        }
    });

    it('do not depend on which way triangles are turned, but for their side', () => {
        const { points, quads } = tube(20);
        const { positions, indices } = bodyOf(points, quads);
        const turned = indices.slice();
        for (let i = 0; i < turned.length; i += 3) {
            if (i % 4 === 0) [turned[i + 1], turned[i + 2]] = [turned[i + 2]!, turned[i + 1]!];
        }
        for (const { place, normal, face } of cornersOf(creaseNormals(positions, turned))) {
            const side = Math.sign(face[0]! * place[0]! + face[1]! * place[1]!);
            expect(apart(normal, [side * place[0]!, side * place[1]!, 0])).toBeLessThan(1e-5);
        }
    });

    it('are the same where each triangle has vertices of its own', () => {
        const { points, quads } = tube(20);
        const shared = bodyOf(points, quads);
        const own = Float32Array.from([...shared.indices].flatMap((i) => points[i]!));
        const made = creaseNormals(
            own,
            Uint32Array.from(shared.indices, (_, i) => i),
        );
        for (const { place, normal } of cornersOf(made)) expect(apart(normal, [place[0]!, place[1]!, 0])).toBeLessThan(1e-5);
    });

    it('are those of the faces where more than two meet at an edge, as where two cells of a body touch', () => {
        const beside = cube.points.map(([x, y, z]): Point => [x + 1, y + 1, z]);
        const points = [...cube.points, ...beside];
        const { positions, indices } = bodyOf(points, [...cube.quads, ...cube.quads.map((quad) => quad.map((i) => i + 8))]);
        for (const { normal, face } of cornersOf(creaseNormals(positions, indices))) {
            expect(apart(normal, face)).toBeLessThan(1e-6);
        }
    });

    it('are the same where triangles come as quads with one corner twice, as walls do', () => {
        const { points, quads } = tube(16);
        const twice = quads.flatMap(([a, b, c, d]) => [
            [a!, b!, c!, c!],
            [a!, c!, d!, d!],
        ]);
        const { positions, indices } = bodyOf(points, twice);
        const made = creaseNormals(positions, indices);
        expect(made.positions).toEqual(positions);
        for (const { place, normal } of cornersOf(made)) expect(apart(normal, [place[0]!, place[1]!, 0])).toBeLessThan(1e-5);
    });

    it('are none of a triangle without area, and it disturbs no other', () => {
        const { points, quads } = tube(16);
        const { positions, indices } = bodyOf(points, [...quads, [0, 0, 1], [3, 3, 3]]);
        const made = creaseNormals(positions, indices);
        expect([...made.normals].every(Number.isFinite)).toBe(true);
        for (const { place, normal } of cornersOf(made).slice(0, 96)) {
            expect(apart(normal, [place[0]!, place[1]!, 0])).toBeLessThan(1e-5);
        }
    });
});
