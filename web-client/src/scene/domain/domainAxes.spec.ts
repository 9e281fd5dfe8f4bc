import { PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { type AxisEdge, type Bounds, boxEdges, centreOf, clampedToPicture, edgesBeforeBox, labelledEdges } from './domainAxes.ts';
import { projectToScreen } from '../base/view.ts';

const bounds: Bounds = [-3, 13, -4, 4, 0, 6];
const size = { width: 800, height: 600 };

function cameraAt(eye: Vec3, at: Vec3): PerspectiveCamera {
    const camera = new PerspectiveCamera(30, size.width / size.height, 0.1, 1000);
    camera.up.set(0, 0, 1);
    camera.position.set(...eye);
    camera.lookAt(...at);
    camera.updateMatrixWorld();
    return camera;
}

/** The best of each axis. */
function edgesSeenFrom(eye: Vec3, at: Vec3 = centreOf(bounds)): AxisEdge[] {
    const camera = cameraAt(eye, at);
    return labelledEdges(bounds, eye, (p) => projectToScreen(p, camera, size), size).flatMap((each) => each.slice(0, 1));
}

describe('labelledEdges', () => {
    it('chooses one edge of the box for each axis, along that axis', () => {
        const edges = edgesSeenFrom([-20, -40, 25]);
        expect(edges.map(({ axis }) => axis)).toEqual([0, 1, 2]);
        for (const { axis, from, to } of edges) {
            expect(from[axis]).toBe(bounds[2 * axis]);
            expect(to[axis]).toBe(bounds[2 * axis + 1]);
        }
    });

    it('prefers the lower edges, which is where axes are looked for', () => {
        const [x, y] = edgesSeenFrom([-20, -40, 25]);
        expect(x?.from).toEqual([-3, -4, 0]);
        expect(y?.from).toEqual([-3, -4, 0]);
    });

    it('follows the camera to the other side', () => {
        const [x] = edgesSeenFrom([20, 40, 25]);
        expect(x?.from).toEqual([-3, 4, 0]);
    });

    it.each([
        ['outside, near a corner', [-6, -9, 4], [0, -4, 1]],
        ['inside', [0, 0, 3], [13, 4, 0]],
    ] as [string, Vec3, Vec3][])('takes of each edge what is seen from %s', (_where, eye, at) => {
        const edges = edgesSeenFrom(eye, at);
        expect(edges.length).toBeGreaterThan(0);
        const camera = cameraAt(eye, at);
        for (const { axis, from, to } of edges) {
            expect(from[axis]).toBeGreaterThanOrEqual(bounds[2 * axis]!);
            expect(to[axis]).toBeLessThanOrEqual(bounds[2 * axis + 1]!);
            expect(to[axis]).toBeGreaterThan(from[axis]);
            for (const end of [from, to]) {
                const { x, y } = projectToScreen(end, camera, size)!;
                expect(x).toBeGreaterThan(-1e-6 * size.width);
                expect(x).toBeLessThan((1 + 1e-6) * size.width);
                expect(y).toBeGreaterThan(-1e-6 * size.height);
                expect(y).toBeLessThan((1 + 1e-6) * size.height);
            }
        }
    });
});

describe('edgesBeforeBox', () => {
    const before = (eye: Vec3): number[][] => {
        const ends = boxEdges(bounds);
        const middle = (i: number, k: number): number => (ends[6 * i + k]! + ends[6 * i + 3 + k]!) / 2 + centreOf(bounds)[k]!;
        return edgesBeforeBox(bounds, eye).flatMap((is, i) => (is ? [[0, 1, 2].map((k) => middle(i, k))] : []));
    };

    it('are the three that meet in the corner next to an eye that sees three faces', () => {
        expect(before([-20, -40, 25])).toEqual([
            [-3, -4, 3],
            [5, -4, 6],
            [-3, 0, 6],
        ]);
    });

    it('is one where two faces are seen, and none where one is, or where the eye is inside', () => {
        expect(before([-20, -40, 3])).toEqual([[-3, -4, 3]]);
        expect(before([5, -40, 3])).toEqual([]);
        expect(before([5, 0, 3])).toEqual([]);
    });
});

describe('boxEdges', () => {
    it.each([1e-9, 4e-5, 1, 3e6])('are the twelve edges of a box of %d, each of its own length', (scale) => {
        const sides = [scale, 2 * scale, 3 * scale];
        const ends = boxEdges([0, sides[0]!, 0, sides[1]!, -sides[2]!, 0]);
        expect(ends).toHaveLength(12 * 2 * 3);
        const lengths = Array.from({ length: 12 }, (_, i) =>
            Math.hypot(...[0, 1, 2].map((k) => ends[6 * i + 3 + k]! - ends[6 * i + k]!)),
        );
        const near = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-6 * b;
        expect(sides.map((side) => lengths.filter((length) => near(length, side)).length)).toEqual([4, 4, 4]);
    });
});

describe('keptIn', () => {
    it('holds the words of a place in the picture inside, and leaves those of another where they are', () => {
        expect(clampedToPicture({ x: -8, y: 300 }, { x: 30, y: 310 }, size)).toEqual({ x: 12, y: 300 });
        expect(clampedToPicture({ x: 400, y: 612 }, { x: 410, y: 580 }, size)).toEqual({ x: 400, y: 588 });
        // All of long words, too.
        expect(clampedToPicture({ x: 20, y: 300 }, { x: 30, y: 310 }, size, 45)).toEqual({ x: 45, y: 300 });
        expect(clampedToPicture({ x: 400, y: 300 }, { x: 410, y: 310 }, size)).toEqual({ x: 400, y: 300 });
        expect(clampedToPicture({ x: -50, y: 300 }, { x: -10, y: 310 }, size)).toEqual({ x: -50, y: 300 });
    });
});
