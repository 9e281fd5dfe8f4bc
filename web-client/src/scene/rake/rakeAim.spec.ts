import { PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { View } from '../base/view.ts';
import { dropLine, RakeAim } from './rakeAim.ts';
import { type Axis, beginDrag, dragged, unitAxis } from './rakeDrag.ts';
import type { RakeLayer } from './rakeLayer.ts';
import type { RakeShape } from './rakeShape.ts';

const line: RakeShape = {
    kind: 'line',
    points: [
        [-1, -1, 1],
        [1, 1, 2],
    ],
};

function viewFrom(eye: Vec3): View {
    const camera = new PerspectiveCamera(30, 4 / 3, 0.01, 100);
    camera.up.set(0, 0, 1);
    camera.position.set(...eye);
    camera.lookAt(0, 0, 1);
    camera.updateMatrixWorld();
    return new View(camera, { width: 800, height: 600 });
}

function aimAt(shape: RakeShape, mayMove = true): RakeAim {
    const middle: Vec3 = [0, 0, 1.5];
    const positionOf = (handle: unknown): Vec3 => (typeof handle === 'number' ? shape.points[handle]! : middle);
    return new RakeAim({ shape, movable: true, chosenId: 'r1', positionOf } as unknown as RakeLayer, () => mayMove);
}

describe('the arrows of a rake', () => {
    it('stand at its middle, or at the point that was used last, one along each axis', () => {
        const view = viewFrom([-8, -15, 8]);
        const aim = aimAt(line);
        const tips = aim.arrows(view);
        expect(tips.map(({ axis }) => axis)).toEqual([0, 1, 2]);
        for (const { axis, tip } of tips) {
            const away = tip.map((value, k) => value - [0, 0, 1.5][k]!);
            expect(away[axis]).toBeGreaterThan(0);
            expect(away.filter((_, k) => k !== axis)).toEqual([0, 0]);
            const under = aim.arrowUnder(view.project(tip)!, view);
            expect(under?.axis).toBe(axis);
            expect(under?.px).toBeCloseTo(0, 6);
        }
        aim.arm(1);
        expect(aim.handle).toBe(1);
        expect(aim.arrows(view)[2]!.tip.slice(0, 2)).toEqual([1, 1]);
    });

    it('have their tips clear of the handles, also of a rake that is short on the screen, whichever way it lies', () => {
        for (const direction of [
            [0, 0, 1],
            [1, 0, 0],
            [0, 1, 0],
            [0.6, 0.6, 0.5],
        ] as const) {
            for (const half of [0.1, 0.3, 0.6, 0.9, 1.4]) {
                const points = [-half, half].map((by) => direction.map((d, k) => by * d + [0, 0, 1.5][k]!) as unknown as Vec3);
                const shape: RakeShape = { kind: 'line', points };
                const view = viewFrom([-8, -15, 8]);
                for (const { tip } of aimAt(shape).arrows(view)) {
                    const at = view.project(tip)!;
                    for (const point of points) {
                        const handle = view.project(point)!;
                        expect(Math.hypot(at.x - handle.x, at.y - handle.y)).toBeGreaterThan(35);
                    }
                }
            }
        }
    });

    it('are not where they would point at the eye, nor where the rake may not be moved', () => {
        expect(
            aimAt(line)
                .arrows(viewFrom([0, -15, 1]))
                .map(({ axis }) => axis),
        ).toEqual([0, 2]);
        expect(aimAt(line, false).arrows(viewFrom([-8, -15, 8]))).toEqual([]);
    });

    it('are of the whole of a circle, whichever handle was used', () => {
        const aim = aimAt({ kind: 'circle', points: [...line.points, [0, 0, 3]] });
        aim.arm(1);
        expect(aim.handle).toBe('middle');
    });

    it('move the handle along their axis alone, as far as the pointer goes along it', () => {
        const view = viewFrom([-8, -15, 8]);
        for (const axis of [0, 1, 2] as Axis[]) {
            const { tip } = aimAt(line)
                .arrows(view)
                .find((each) => each.axis === axis)!;
            const pressed = view.project(tip)!;
            const drag = beginDrag('middle', line, pressed, view);
            const centre = view.project([0, 0, 1.5])!;
            const wanted = view.project(unitAxis(axis).map((each, k) => 0.8 * each + [0, 0, 1.5][k]!) as Vec3)!;
            // Off the line as a hand is.
            const pointer = { x: pressed.x + wanted.x - centre.x, y: pressed.y + wanted.y - centre.y };
            const { shape, words } = dragged(drag, pointer, view, { axis, step: null });
            shape.points.forEach((point, i) =>
                point.forEach((value, k) => expect(value - line.points[i]![k]!).toBeCloseTo(k === axis ? 0.8 : 0, 9)),
            );
            expect(words).toBe(`along ${'xyz'[axis]}`);
        }
    });
});

describe('the line to the floor', () => {
    it('goes down from both ends and along the print of the rake', () => {
        expect(dropLine(line, -4)).toEqual([line.points[0], [-1, -1, -4], [1, 1, -4], line.points[1]]);
    });

    it('is below the lower end of an upright rake, and below the middle of a circle', () => {
        const upright: RakeShape = {
            kind: 'line',
            points: [
                [2, 3, 5],
                [2, 3, 1],
            ],
        };
        expect(dropLine(upright, 0)).toEqual([
            [2, 3, 1],
            [2, 3, 0],
        ]);
        const circle: RakeShape = {
            kind: 'circle',
            points: [
                [2, 3, 4],
                [2, 4, 4],
                [2, 3, 5],
            ],
        };
        expect(dropLine(circle, 0)).toEqual([
            [2, 3, 4],
            [2, 3, 0],
        ]);
    });
});
