import { OrthographicCamera, PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { type SceneCamera, View } from './view.ts';

const size = { width: 640, height: 360 };

function placed<Kind extends SceneCamera>(camera: Kind): Kind {
    camera.up.set(0, 0, 1);
    camera.position.set(-7, -11, 6);
    camera.lookAt(1, 0.5, 0.2);
    camera.updateMatrixWorld();
    return camera;
}

const cameras: [string, SceneCamera][] = [
    ['perspective', placed(new PerspectiveCamera(30, size.width / size.height, 0.1, 100))],
    ['orthographic', placed(new OrthographicCamera(-6.4, 6.4, 3.6, -3.6, 0.1, 100))],
];

describe.each(cameras)('a %s view', (_, camera) => {
    const view = new View(camera, size);
    const anchor: Vec3 = [1, -0.5, 0.7];

    it('puts a point exactly under the pointer, at the depth of another', () => {
        for (const pointer of [
            { x: 320, y: 180 },
            { x: 3, y: 350 },
            { x: 612.5, y: 44.25 },
        ]) {
            const at = view.project(view.pointAtDepth(pointer, anchor));
            expect(at?.x).toBeCloseTo(pointer.x, 6);
            expect(at?.y).toBeCloseTo(pointer.y, 6);
        }
    });

    it('knows how long a pixel is: a step of so much to the side is one pixel', () => {
        const from = view.project(anchor)!;
        const to = view.pointAtDepth({ x: from.x + 1, y: from.y }, anchor);
        const step = Math.hypot(...to.map((value, i) => value - anchor[i]!));
        expect(view.worldPerPx(anchor)).toBeCloseTo(step, 9);
    });

    it('sees both points of a line of sight at the same place', () => {
        const pointer = { x: 100, y: 50 };
        const points = view.sightLine(pointer);
        expect(points).toHaveLength(2);
        for (const point of points) {
            expect(view.project(point)?.x).toBeCloseTo(pointer.x, 6);
            expect(view.project(point)?.y).toBeCloseTo(pointer.y, 6);
        }
    });

    it('keeps the distance from the camera plane', () => {
        const moved = view.pointAtDepth({ x: 10, y: 20 }, anchor);
        const forward = [8, 11.5, -5.8];
        const along = moved.reduce((sum, v, i) => sum + (v - anchor[i]!) * forward[i]!, 0);
        expect(along).toBeCloseTo(0, 8);
    });

    it('projects what is behind the camera where it is drawn: without perspective only', () => {
        const seen = view.project([-23, -34, 17.6]);
        if (camera instanceof PerspectiveCamera) expect(seen).toBeNull();
        else {
            // Along the line of sight through the middle.
            expect(seen?.x).toBeCloseTo(size.width / 2, 6);
            expect(seen?.y).toBeCloseTo(size.height / 2, 6);
        }
    });
});
