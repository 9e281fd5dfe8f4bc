import { OrthographicCamera, PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { type SceneCamera, type ScreenPoint, View } from '../base/view.ts';
import { alongAxis, beginDrag, dragged, type Dragged, nearestAxis, onGrid, type Snap, unitAxis } from './rakeDrag.ts';
import { type Handle, handleUnder, hitRadiusPx, placedHandles, positionOf } from './rakeHandles.ts';
import { circleOf, circleShape, distance, dot, middleOf, minus, type RakeShape } from './rakeShape.ts';

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
const free: Snap = { axis: null, step: null };
const line: RakeShape = {
    kind: 'line',
    points: [
        [0, 1, -1],
        [1, -1, 2],
    ],
};
const bent: RakeShape = {
    kind: 'polyline',
    points: [
        [0, 1, -1],
        [1, -1, 0],
        [1, 0, 2],
    ],
};
const ring = circleShape({ centre: [0.5, 0, 0.5], radius: 1, u: [0, 1, 0], v: [0, 0, 1] });

describe.each(cameras)('a handle dragged in a %s view', (_, camera) => {
    const view = new View(camera, size);

    function drag(shape: RakeShape, handle: Handle, by: ScreenPoint, snap: Snap = free): Dragged & { pointer: ScreenPoint } {
        const at = view.project(positionOf(handle, shape, view))!;
        // Pressed a little off its centre.
        const drag = beginDrag(handle, shape, { x: at.x + 5, y: at.y - 3 }, view);
        const result = dragged(drag, { x: at.x + 5 + by.x, y: at.y - 3 + by.y }, view, snap);
        return { ...result, pointer: { x: at.x + by.x, y: at.y + by.y } };
    }

    function expectUnder({ at, pointer }: { at: Vec3; pointer: ScreenPoint }): void {
        const seen = view.project(at)!;
        expect(seen.x).toBeCloseTo(pointer.x, 6);
        expect(seen.y).toBeCloseTo(pointer.y, 6);
    }

    it.each([
        [line, 0],
        [line, 1],
        [bent, 1],
        [line, 'middle'],
        [line, 'rotate'],
        [ring, 'middle'],
        [ring, 1],
        [ring, 'rotate'],
    ] as [RakeShape, Handle][])('stays under the pointer (%#)', (shape, handle) => {
        expectUnder(drag(shape, handle, { x: 34, y: -21 }));
    });

    it('leaves the other points alone', () => {
        const { shape } = drag(bent, 1, { x: 34, y: -21 });
        expect([shape.points[0], shape.points[2]]).toEqual([bent.points[0], bent.points[2]]);
    });

    it('turns the rake about its middle by as much as the hand goes round it', () => {
        const { shape, at } = drag(line, 'rotate', { x: 40, y: 30 });
        const [middle, handle] = [middleOf(line), positionOf('rotate', line, view)];
        expect(distance(middleOf(shape), middle)).toBeLessThan(1e-9);
        expect(distance(shape.points[0]!, shape.points[1]!)).toBeCloseTo(distance(line.points[0]!, line.points[1]!), 9);
        const angle = (a: Vec3, b: Vec3): number => Math.acos(dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b)));
        const [axis] = [minus(...(view.sightLine(view.project(middle)!).reverse() as [Vec3, Vec3]))];
        const flat = (a: Vec3): Vec3 => {
            const part = dot(a, axis) / dot(axis, axis);
            return [a[0] - part * axis[0], a[1] - part * axis[1], a[2] - part * axis[2]];
        };
        const hand = angle(minus(handle, middle), minus(at, middle));
        expect(hand).toBeGreaterThan(0.3);
        const rake = angle(flat(minus(line.points[1]!, middle)), flat(minus(shape.points[1]!, middle)));
        expect(rake).toBeCloseTo(hand, 1);
    });

    it('keeps a circle in its plane when it is made larger, and its size when it is tilted', () => {
        const [centre, rim] = [view.project(ring.points[0]!)!, view.project(ring.points[1]!)!];
        const larger = drag(ring, 1, { x: 0.3 * (rim.x - centre.x), y: 0.3 * (rim.y - centre.y) }).shape;
        for (const point of larger.points) expect(point[0]).toBeCloseTo(0.5, 9);
        expect(circleOf(larger).radius).toBeGreaterThan(1.2);
        const tilted = drag(ring, 2, { x: -9, y: 7 });
        expect(circleOf(tilted.shape).radius).toBeCloseTo(1, 9);
        expect(tilted.shape.points[0]).toEqual(ring.points[0]);
        expectUnder(tilted);
    });

    it('keeps to the axis nearest to the movement, at the foot of the pointer on it', () => {
        for (const axis of [0, 1, 2] as const) {
            const from = line.points[0]!;
            const [a, b] = [
                view.project(from)!,
                view.project([0, 1, 2].map((k) => from[k]! + unitAxis(axis)[k]! * 0.7) as Vec3)!,
            ];
            const [dx, dy] = [b.x - a.x, b.y - a.y];
            const by = { x: dx - 0.1 * dy, y: dy + 0.1 * dx };
            expect(nearestAxis(from, by, view)).toBe(axis);
            const { shape, words } = drag(line, 0, by, { axis: 'nearest', step: null });
            expect(words).toBe(`along ${'xyz'[axis]}`);
            shape.points[0]!.forEach((v, k) => expect(v).toBeCloseTo(from[k]! + (k === axis ? 0.7 : 0), 6));
            const seen = view.project(alongAxis(from, axis, b, view))!;
            expect(Math.hypot(seen.x - b.x, seen.y - b.y)).toBeLessThan(1e-6);
        }
    });

    it('comes to a point of the grid, and moves along the axis only with both', () => {
        const { shape } = drag(line, 1, { x: 31, y: 17 }, { axis: null, step: 0.25 });
        for (const v of shape.points[1]!) expect(v * 4).toBe(Math.round(v * 4));
        const off: RakeShape = {
            kind: 'line',
            points: [
                [0.1, 0.2, 0.3],
                [1, 1, 1],
            ],
        };
        const both = drag(off, 0, { x: 50, y: -12 }, { axis: 'nearest', step: 0.25 });
        const kept = both.shape.points[0]!.filter((v, k) => v === off.points[0]![k]);
        expect(kept).toHaveLength(2);
        expect(both.words).toMatch(/along [xyz], grid 0.25/);
    });

    it('turns in steps of 15 degrees on a grid', () => {
        const { words } = drag(line, 'rotate', { x: 40, y: 30 }, { axis: null, step: 0.5 });
        expect(Math.abs(Number(/^-?\d+/.exec(words)![0]) % 15)).toBe(0);
    });
});

describe.each(cameras)('handles in a %s view', (_, camera) => {
    const view = new View(camera, size);

    it('are found within their radius, the nearest first', () => {
        const placed = placedHandles(line, view);
        expect(placed.map(({ handle }) => handle)).toEqual([0, 1, 'middle', 'rotate']);
        for (const { handle, at } of placed) {
            const seen = view.project(at)!;
            expect(handleUnder(seen, line, view)).toBe(handle);
        }
        const [a, b] = [view.project(line.points[0]!)!, view.project(positionOf('middle', line, view))!];
        const length = Math.hypot(b.x - a.x, b.y - a.y);
        const part = (px: number): ScreenPoint => ({
            x: a.x + ((b.x - a.x) * px) / length,
            y: a.y + ((b.y - a.y) * px) / length,
        });
        expect(handleUnder(part(-hitRadiusPx + 1), line, view)).toBe(0);
        expect(handleUnder(part(-hitRadiusPx - 1), line, view)).toBeNull();
        expect(hitRadiusPx).toBeGreaterThanOrEqual(18);
        const near: RakeShape = {
            kind: 'polyline',
            points: [line.points[0]!, view.pointAtDepth(part(10), line.points[0]!), line.points[1]!],
        };
        expect(handleUnder(part(4), near, view)).toBe(0);
        expect(handleUnder(part(6), near, view)).toBe(1);
    });

    it('keep the turning one at the same distance from the middle, at right angles to the rake', () => {
        for (const scale of [1, 0.3]) {
            const shape: RakeShape = { kind: 'line', points: line.points.map((p) => p.map((v) => v * scale) as Vec3) };
            const [middle, handle] = [view.project(middleOf(shape))!, view.project(positionOf('rotate', shape, view))!];
            expect(Math.hypot(handle.x - middle.x, handle.y - middle.y)).toBeCloseTo(52, 6);
        }
    });

    it('are few on a rake of many points', () => {
        const points = Array.from({ length: 4096 }, (_, i) => [i / 4096, 0, 0] as Vec3);
        expect(placedHandles({ kind: 'points', points }, view).map(({ handle }) => handle)).toEqual(['middle', 'rotate']);
        expect(placedHandles({ kind: 'polyline', points }, view)).toHaveLength(2);
    });
});

describe('the grid', () => {
    it('has no noise in its decimals', () => {
        expect(onGrid([0.31, -0.29, 0.04], 0.1)).toEqual([0.3, -0.3, 0]);
    });
});
