import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { distance } from '../rake/rakeShape.ts';
import type { CameraPose } from './cameraControls.ts';
import { poseAlong } from './cameraPath.ts';

function at(position: Vec3, target: Vec3 = [0, 0, 0]): CameraPose {
    return { position, target, orthographic: false };
}

describe('a path of the camera', () => {
    const poses = [at([5, 0, 1]), at([0, 6, 2], [1, 0, 0]), at([-9, 0, 3], [1, 1, 0]), at([-3, -3, 0])];

    it('is at each pose when its turn comes', () => {
        for (const [i, pose] of poses.entries()) {
            const found = poseAlong(poses, i / (poses.length - 1));
            expect(distance(found.position, pose.position)).toBeLessThan(1e-9);
            expect(distance(found.target, pose.target)).toBeLessThan(1e-9);
        }
    });

    it('has no jumps and no corners: its speed is even to first order', () => {
        for (const path of [poses, [...poses, at([4, 4, 1])]]) {
            const step = 1e-4;
            for (let part = step; part < 1 - step; part += 0.013) {
                const [a, b, c] = [part - step, part, part + step].map((each) => poseAlong(path, each).position) as [
                    Vec3,
                    Vec3,
                    Vec3,
                ];
                const bend = Math.hypot(...a.map((each, k) => each - 2 * b[k]! + c[k]!));
                expect(bend).toBeLessThan(1e-4);
            }
        }
    });

    it('goes round what is looked at and keeps its distance, also from one side to the opposite one', () => {
        for (const path of [
            [at([4, 0, 0]), at([0, 4, 0]), at([-4, 0, 0]), at([0, -4, 0])],
            [at([4, 0, 0]), at([-4, 0, 0])],
            [at([0, 0, 4]), at([0, 0, -4])],
        ]) {
            for (let part = 0; part <= 1; part += 0.01) {
                expect(distance(poseAlong(path, part).position, [0, 0, 0])).toBeCloseTo(4, 9);
            }
        }
    });

    it('of one pose stays there', () => {
        expect(poseAlong([at([1, 2, 3])], 0.7).position.map((each) => Number(each.toFixed(12)))).toEqual([1, 2, 3]);
    });
});
