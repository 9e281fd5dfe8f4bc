import { OrthographicCamera, PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import type { ScreenPoint } from '../base/view.ts';
import { type SceneCamera, View } from '../base/view.ts';
import { dot, lengthOf, minus, unit } from '../rake/rakeShape.ts';
import { type SliceHandle, SliceHandles, type SlicePlane } from './sliceHandles.ts';

const size = { width: 640, height: 360 };
const box = [-2, 2, -1, 1, 0, 3];
const middle: Vec3 = [0, 0, 1.5];

function looking<Kind extends SceneCamera>(camera: Kind, from: Vec3): Kind {
    camera.up.set(0, from[0] === 0 && from[1] === 0 ? 1 : 0, from[0] === 0 && from[1] === 0 ? 0 : 1);
    camera.position.set(...from);
    camera.lookAt(...middle);
    camera.updateMatrixWorld();
    return camera;
}

/** Handles of a plane that is where it was moved last. */
function handlesOf(camera: SceneCamera, start: SlicePlane, mayMove = true) {
    const view = new View(camera, size);
    const nothing = (): void => undefined;
    let plane = start;
    const handles = new SliceHandles({
        ...{ view: () => view, requestFrame: nothing, onHold: nothing, released: nothing, mayMove: () => mayMove },
        moved: (to) => {
            plane = to;
            handles.set(plane, box);
        },
    });
    handles.set(plane, box);
    const at = (handle: SliceHandle): ScreenPoint => handles.handleOnScreen(handle)!;
    const pointer = (place: ScreenPoint, shift = false) => ({ at: place, time: 0, shift });
    const drag = (handle: SliceHandle, by: ScreenPoint, shift = false): SlicePlane => {
        const from = at(handle);
        expect(handles.press(pointer(from))).toBe(true);
        for (const part of [0.5, 1]) handles.move(pointer({ x: from.x + part * by.x, y: from.y + part * by.y }, shift));
        handles.release();
        return plane;
    };
    return { handles, view, at, drag };
}

describe.each([
    ['perspective', looking(new PerspectiveCamera(40, size.width / size.height, 0.1, 100), [-5, -6, 4])],
    ['orthographic', looking(new OrthographicCamera(-6.4, 6.4, 3.6, -3.6, 0.1, 100), [-5, -6, 4])],
])('the handles of a slice, in %s', (_, camera) => {
    it('move it along its normal, under the pointer as far as that goes along it', () => {
        const { at, drag, view } = handlesOf(camera, { origin: middle, normal: [0, 0, 2] });
        const from = at('move');
        const { origin, normal } = drag('move', { x: 0, y: -40 });
        expect(normal).toEqual([0, 0, 2]);
        expect([origin[0], origin[1]]).toEqual([0, 0]);
        expect(view.project(origin)!.y).toBeCloseTo(from.y - 40, 0);
        expect(at('move').y).toBeCloseTo(from.y - 40, 0);
    });

    it('do not let it leave the domain', () => {
        const { drag } = handlesOf(camera, { origin: middle, normal: [0, 0, 1] });
        expect(drag('move', { x: 0, y: -230 }).origin[2]).toBeCloseTo(3, 1);
        expect(drag('move', { x: 0, y: 230 }).origin[2]).toBeCloseTo(0, 1);
    });

    it('turn it about its middle, and with Shift to the nearest axis', () => {
        const turned = handlesOf(camera, { origin: middle, normal: [0, 0, 1] }).drag('turn', { x: 50, y: 8 });
        expect(turned.origin.map((each, k) => each - middle[k]!).every((each) => Math.abs(each) < 1e-9)).toBe(true);
        expect(lengthOf(turned.normal)).toBeCloseTo(1, 9);
        expect(dot(turned.normal, [0, 0, 1])).toBeLessThan(0.95);
        const snapped = handlesOf(camera, { origin: middle, normal: unit([0.2, 0.1, 1]) }).drag('turn', { x: 3, y: 0 }, true);
        expect(snapped.normal).toEqual([0, 0, 1]);
    });

    it('turn it on, also past the side that faces the eye', () => {
        const { drag, at } = handlesOf(camera, { origin: middle, normal: [0, 0, -1] });
        const from = at('turn');
        const { normal } = drag('turn', { x: 0, y: 30 });
        // The stem is on the side that is seen, against the normal.
        expect(normal[2]).toBeLessThan(0);
        expect(Math.hypot(at('turn').x - from.x, at('turn').y - from.y - 30)).toBeLessThan(8);
    });

    it('are not there for those who may not move it', () => {
        const { handles, at } = handlesOf(camera, { origin: middle, normal: [0, 0, 1] }, false);
        expect(handles.press({ at: at('move'), time: 0, shift: false })).toBe(false);
    });
});

it('a slice that is seen along its normal goes away from the eye as the pointer goes up', () => {
    const camera = looking(new PerspectiveCamera(40, size.width / size.height, 0.1, 100), [0, 0, 12]);
    const up = handlesOf(camera, { origin: middle, normal: [0, 0, 1] }).drag('move', { x: 0, y: -20 });
    expect(up.origin[2]).toBeLessThan(1.5);
    const other = handlesOf(camera, { origin: middle, normal: [0, 0, -1] }).drag('move', { x: 0, y: -20 });
    expect(minus(up.origin, other.origin).every((each) => Math.abs(each) < 1e-9)).toBe(true);
});
