import { PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { CameraPlace } from '../../protocol/messages.ts';
import { View } from '../base/view.ts';
import { frustumSegments, looksFromHere } from './frustum.ts';

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
