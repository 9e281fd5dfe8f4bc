import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { CameraPlace, Vec3 } from '../../protocol/messages.ts';
import { View } from '../base/view.ts';
import { arrowTowards, edgeHint, frustumSegments, looksFromHere } from './peopleLayer.ts';

const place: CameraPlace = { position: [3, -8, 2], target: [0, 0, 0], up: [0, 0, 1], fov: 30 };

describe('frustumSegments', () => {
    it('has its corners at the edges of what that camera sees', () => {
        const camera = new PerspectiveCamera(30, 1.6, 0.1, 100);
        camera.up.set(...place.up);
        camera.position.set(...place.position);
        camera.lookAt(...place.target);
        camera.updateMatrixWorld();
        const view = new View(camera, { width: 160, height: 100 });
        const corners = frustumSegments(place).filter((_, i) => i % 4 === 1);
        const seen = corners.map((corner) => view.project(corner)!);
        const expected = [
            [0, 100],
            [160, 100],
            [160, 0],
            [0, 0],
        ] as const;
        expect(seen).toHaveLength(expected.length);
        seen.forEach(({ x, y }, i) => {
            expect(x).toBeCloseTo(expected[i]![0], 6);
            expect(y).toBeCloseTo(expected[i]![1], 6);
        });
    });

    it('is none of a camera that is where one looks from oneself', () => {
        const camera = new PerspectiveCamera(30, 1.6, 0.1, 100);
        camera.position.set(...place.position);
        const view = new View(camera, { width: 160, height: 100 });
        expect(looksFromHere(view, place)).toBe(true);
        expect(looksFromHere(view, { ...place, position: [3, -7.5, 2] })).toBe(false);
    });

    it('has eight lines, also where the camera looks along its up, and none of a camera without a direction', () => {
        expect(frustumSegments(place)).toHaveLength(16);
        const down = frustumSegments({ ...place, position: [0, 0, 5] });
        expect(down).toHaveLength(16);
        expect(down.flat().every(Number.isFinite)).toBe(true);
        expect(frustumSegments({ ...place, target: place.position })).toEqual([]);
    });
});

const size = { width: 640, height: 360 };
const insets = { left: 10, right: 60, top: 30, bottom: 20 };

/** Looks along y from the origin, z up: x is to the right. */
function looking<Kind extends PerspectiveCamera | OrthographicCamera>(camera: Kind): View {
    camera.up.set(0, 0, 1);
    camera.lookAt(0, 1, 0);
    camera.updateMatrixWorld();
    return new View(camera, size);
}

const perspective = looking(new PerspectiveCamera(40, size.width / size.height, 0.1, 100));
const parallel = looking(new OrthographicCamera(-6.4, 6.4, 3.6, -3.6, 0.1, 100));

describe('edgeHint', () => {
    it('is none for what is in the picture', () => {
        for (const view of [perspective, parallel]) {
            expect(edgeHint(view, [0, 10, 0], insets)).toBeNull();
            expect(edgeHint(view, [2, 10, -1], insets)).toBeNull();
        }
    });

    it('stands at the edge that the way from the middle to the projected point crosses', () => {
        const outside: Vec3[] = [
            [9, 10, 1],
            [-12, 10, 3],
            [1, 10, 6],
            [-2, 10, -9],
            [8, 10, 5],
        ];
        for (const view of [perspective, parallel]) {
            for (const point of outside) {
                const { at, share, towards } = edgeHint(view, point, insets)!;
                const seen = view.project(point)!;
                const across = (seen.x - 320) * (at.y - 180) - (seen.y - 180) * (at.x - 320);
                expect(Math.abs(across)).toBeLessThan(1e-6 * Math.hypot(seen.x, seen.y) * 320);
                expect((seen.x - 320) * (at.x - 320) + (seen.y - 180) * (at.y - 180)).toBeGreaterThan(0);
                // On the border of what the insets leave, and so of its width and height.
                const fromEdges = [at.x - 10, 640 - 60 - at.x, at.y - 30, 360 - 20 - at.y];
                expect(Math.min(...fromEdges)).toBeCloseTo(0, 6);
                expect(share.x).toBeCloseTo((at.x - 10) / 570, 9);
                expect(share.y).toBeCloseTo((at.y - 30) / 310, 9);
                expect(Math.hypot(towards.x, towards.y)).toBeCloseTo(1, 12);
            }
        }
    });

    it('goes on without a leap as a point passes from before the camera to behind it', () => {
        const before = edgeHint(perspective, [5, 1e-6, 2], insets)!;
        const behind = edgeHint(perspective, [5, -1e-6, 2], insets)!;
        expect(behind.at.x).toBeCloseTo(before.at.x, 3);
        expect(behind.at.y).toBeCloseTo(before.at.y, 3);
        expect(behind.at.x).toBeGreaterThan(320);
        expect(behind.at.y).toBeLessThan(180);
    });

    it('says the shorter turn to what is behind', () => {
        for (const [point, x] of [
            [[-3, -8, 0], 10],
            [[3, -8, 0], 580],
        ] as const) {
            const { at } = edgeHint(perspective, [...point], insets)!;
            expect(at.x).toBeCloseTo(x, 9);
            expect(at.y).toBeCloseTo(180, 9);
            // Looking half to the left or to the right: the side of the hint is the nearer one.
            const [left, right] = [-1, 1].map((side) => new Vector3(side, 1, 0).angleTo(new Vector3(...point)));
            expect(left! < right!).toBe(at.x < 320);
        }
        const exactly = edgeHint(perspective, [0, -1, 0], insets)!.at;
        expect(exactly.x).toBe(320);
        expect(exactly.y).toBeCloseTo(340, 9);
    });

    it('has an arrow for each of eight directions', () => {
        const arrows = [
            [1, 0],
            [1, 1],
            [0, 1],
            [-1, 1],
            [-1, 0],
            [-1, -1],
            [0, -1],
            [1, -1],
        ] as const;
        expect(arrows.map(([x, y]) => arrowTowards({ x, y })).join('')).toBe('→↘↓↙←↖↑↗');
        expect(arrowTowards({ x: -1, y: -1e-9 })).toBe('←');
    });
});
