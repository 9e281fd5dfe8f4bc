import { PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { View } from '../base/view.ts';
import { placeUnder } from './rakeLayer.ts';
import { distance, type RakeShape } from './rakeShape.ts';

const size = { width: 800, height: 600 };

function viewFrom(eye: Vec3, scale = 1): View {
    const camera = new PerspectiveCamera(30, size.width / size.height, 0.01 * scale, 100 * scale);
    camera.up.set(0, 0, 1);
    camera.position.set(...eye);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    return new View(camera, size);
}

describe('placeUnder', () => {
    it.each([4e-5, 1, 3e6])('finds the place of the curve that is under the pointer, at a scale of %d', (scale) => {
        const view = viewFrom([-8 * scale, -15 * scale, 7 * scale], scale);
        const [a, b]: [Vec3, Vec3] = [
            [-scale, -scale, 0],
            [scale, 2 * scale, scale],
        ];
        for (const part of [0, 0.2, 0.5, 0.9]) {
            const point = a.map((value, k) => value + part * (b[k]! - value)) as Vec3;
            const seen = view.project(point)!;
            const found = placeUnder(seen, { kind: 'line', points: [a, b] }, view)!;
            expect(distance(found, point)).toBeLessThan(1e-5 * scale);
            expect(placeUnder({ x: seen.x + 40, y: seen.y + 40 }, { kind: 'line', points: [a, b] }, view)).toBeNull();
        }
    });

    it('finds the place of the disc of a circle, and nothing beside it or where it is seen from its edge', () => {
        const circle: RakeShape = {
            kind: 'circle',
            points: [
                [0, 0, 0],
                [0, 2, 0],
                [0, 0, 2],
            ],
        };
        const inside: Vec3 = [0, 0.7, -0.6];
        const view = viewFrom([-15, -8, 4]);
        expect(distance(placeUnder(view.project(inside)!, circle, view)!, inside)).toBeLessThan(1e-6);
        expect(placeUnder(view.project([0, 3, 0])!, circle, view)).toBeNull();
        const edgeOn = viewFrom([0, -15, 0]);
        expect(placeUnder(edgeOn.project(inside)!, circle, edgeOn)?.[0] ?? 0).toBeCloseTo(0, 6);
    });
});
