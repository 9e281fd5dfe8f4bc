import { PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../protocol/messages.ts';
import { difference, dragInViewPlane, middleOf, projectToScreen, translate } from './rakeDrag.ts';

const size = { width: 640, height: 360 };

function camera(): PerspectiveCamera {
    const made = new PerspectiveCamera(30, size.width / size.height, 0.1, 100);
    made.up.set(0, 0, 1);
    made.position.set(-7, -11, 6);
    made.lookAt(1, 0.5, 0.2);
    made.updateMatrixWorld();
    return made;
}

describe('dragInViewPlane', () => {
    it('puts the handle exactly under the pointer', () => {
        const anchor: Vec3 = [1, -0.5, 0.7];
        for (const pointer of [
            { x: 320, y: 180 },
            { x: 3, y: 350 },
            { x: 612.5, y: 44.25 },
        ]) {
            const at = projectToScreen(dragInViewPlane(pointer, anchor, camera(), size), camera(), size);
            expect(at?.x).toBeCloseTo(pointer.x, 6);
            expect(at?.y).toBeCloseTo(pointer.y, 6);
        }
    });

    it('keeps the distance from the camera plane', () => {
        const anchor: Vec3 = [1, -0.5, 0.7];
        const moved = dragInViewPlane({ x: 10, y: 20 }, anchor, camera(), size);
        const forward = [8, 11.5, -5.8];
        const along = difference(moved, anchor).reduce((sum, v, i) => sum + v * forward[i]!, 0);
        expect(along).toBeCloseTo(0, 9);
    });

    it('does not move a handle whose pointer has not moved', () => {
        const anchor: Vec3 = [2, 1, -1];
        const pointer = projectToScreen(anchor, camera(), size)!;
        dragInViewPlane(pointer, anchor, camera(), size).forEach((value, i) =>
            expect(value).toBeCloseTo(anchor[i]!, 9),
        );
    });
});

describe('projectToScreen', () => {
    it('has no place for what is behind the camera', () => {
        expect(projectToScreen([-14, -22, 12], camera(), size)).toBeNull();
    });
});

describe('translate and middleOf', () => {
    it('move the middle with the ends', () => {
        const points: Vec3[] = [
            [0, 0, 0],
            [2, 4, 6],
        ];
        expect(middleOf(points)).toEqual([1, 2, 3]);
        expect(middleOf(translate(points, [1, 1, 1]))).toEqual([2, 3, 4]);
    });
});
