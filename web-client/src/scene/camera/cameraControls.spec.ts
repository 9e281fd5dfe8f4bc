import { PerspectiveCamera } from 'three';
import { beforeEach, describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { CameraControls, FineOrbit } from './cameraControls.ts';

const length = (v: Vec3): number => Math.hypot(...v);
const between = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

describe.each([false, true])('the camera by steps, without perspective: %s', (orthographic) => {
    let controls: CameraControls;
    let turned: number;

    beforeEach(() => {
        turned = 0;
        controls = new CameraControls({ requestFrame: () => undefined, onHold: () => undefined, onTurn: () => ++turned });
        controls.setBounds([0, 4, -1, 1, 0, 2]);
        controls.place({ position: [2, -9, 1], target: [2, 0, 1], orthographic });
        turned = 0;
    });

    const offset = (): Vec3 => between(controls.pose.position, controls.pose.target);

    it('turns round its target, as if the picture were dragged, and keeps its distance', () => {
        controls.turn(Math.PI / 2, 0);
        // What was at the right is now behind: the camera has gone to the left.
        expect(offset().map((x) => Math.round(x * 1e6) / 1e6 + 0)).toEqual([-9, 0, 0]);
        controls.turn(0, 0.3);
        expect(offset()[2]).toBeCloseTo(-9 * Math.sin(0.3), 6);
        expect(length(offset())).toBeCloseTo(9, 6);
        expect(controls.pose.target).toEqual([2, 0, 1]);
        expect(turned).toBe(2);
    });

    it('never turns over', () => {
        for (let i = 0; i < 40; ++i) controls.turn(0, -0.2);
        expect(offset()[2]).toBeGreaterThan(8.99);
        controls.turn(0, 0.5);
        expect(offset()[1]).toBeLessThan(-4);
    });

    it('moves to the side by parts of the height of the picture, and looks the same way', () => {
        const before = offset();
        controls.pan(0.5, 0);
        const half = 9 * Math.tan(Math.PI / 12);
        expect(controls.pose.target[0]).toBeCloseTo(2 - half, 6);
        offset().forEach((x, i) => expect(x).toBeCloseTo(before[i]!, 6));
    });

    it('comes nearer and goes away, and back to where it was', () => {
        controls.zoom(1.5);
        expect(length(offset())).toBeCloseTo(6, 6);
        controls.zoom(1 / 1.5);
        expect(length(offset())).toBeCloseTo(9, 6);
        expect(controls.pose.orthographic).toBe(orthographic);
    });
});

it.each([
    ['x', [0, 0.1, -1, 1, 0, 2], [1, 0, 0]],
    ['y', [0, 4, 0, 0.1, 0, 2], [0, -1, 0]],
    ['z', [0, 4, -1, 1, 0, 0.01], [0, 0, 1]],
] as const)('sees a slab across %s straight on', (_, bounds, towards) => {
    const controls = new CameraControls({ requestFrame: () => undefined, onHold: () => undefined, onTurn: () => undefined });
    controls.setBounds([...bounds]);
    const from = between(controls.pose.position, controls.pose.target);
    from.forEach((x, k) => expect(x / length(from)).toBeCloseTo(towards[k]!, 2));
    controls.setBounds([0, 4, -1, 1, 0, 2]);
    expect(Math.min(...between(controls.pose.position, controls.pose.target).map(Math.abs))).toBeGreaterThan(1);
});

describe('a picture of another shape', () => {
    function bench() {
        const controls = new CameraControls({ requestFrame: () => undefined, onHold: () => undefined, onTurn: () => undefined });
        controls.resized(2);
        controls.setBounds([0, 4, -1, 1, 0, 2]);
        /** Half of what is seen of the width at the target. */
        const halfWidth = (aspect: number): number =>
            length(between(controls.pose.position, controls.pose.target)) * Math.tan((controls.fov * Math.PI) / 360) * aspect;
        return { controls, halfWidth };
    }

    it.each([false, true])('keeps in its width what someone has put there, and goes back, parallel: %s', (orthographic) => {
        const { controls, halfWidth } = bench();
        controls.place({ position: [2, -9, 1], target: [2, 0, 1], orthographic });
        const before = halfWidth(2);
        controls.resized(0.5);
        expect(halfWidth(0.5)).toBeCloseTo(before, 6);
        controls.resized(1);
        expect(halfWidth(1)).toBeCloseTo(before, 6);
        controls.resized(3);
        expect(controls.pose.position[1]).toBeCloseTo(-9, 6);
        controls.resized(2);
        expect(controls.pose.position[1]).toBeCloseTo(-9, 6);
    });

    it('fits again what it showed by itself, as long as no one has moved it', () => {
        const { controls } = bench();
        const part = [1, 2, 0, 1, 0, 1] as const;
        controls.offer([...part]);
        controls.resized(0.6);
        const fitted = controls.pose;
        const fresh = bench().controls;
        fresh.resized(0.6);
        fresh.offer([...part]);
        expect(fitted).toEqual(fresh.pose);
        controls.turn(0.3, 0);
        expect(controls.offer([...part])).toBe(false);
    });

    it('is not that of a figure, which leaves the camera where it is', () => {
        const { controls } = bench();
        const before = controls.pose;
        controls.setAspect(0.3);
        controls.resized(2);
        expect(controls.pose).toEqual(before);
    });

    it('counts when the page tells of it, though a frame or a figure had that shape before', () => {
        const { controls, halfWidth } = bench();
        controls.place({ position: [2, -9, 1], target: [2, 0, 1], orthographic: false });
        const before = halfWidth(2);
        // Three's camera takes the shape of what it draws.
        controls.camera.setViewOffset(100, 200, 0, 0, 100, 200);
        controls.camera.clearViewOffset();
        controls.resized(0.5);
        expect(halfWidth(0.5)).toBeCloseTo(before, 6);
        controls.setAspect(2);
        controls.resized(2);
        expect(controls.pose.position[1]).toBeCloseTo(-9, 6);
    });
});

describe('FineOrbit', () => {
    it.each([4e-5, 1, 3e6])(
        'tells of movements as small as they are seen in a domain of %d, and of none that is none',
        (scale) => {
            const camera = new PerspectiveCamera();
            camera.position.set(0, -3 * scale, scale);
            const orbit = new FineOrbit(camera);
            orbit.update();
            let changes = 0;
            orbit.addEventListener('change', () => ++changes);
            for (let i = 0; i < 5; ++i) expect(orbit.update()).toBe(false);
            expect(changes).toBe(0);
            // As panning does.
            camera.position.x += 0.01 * scale;
            orbit.target.x += 0.01 * scale;
            expect(orbit.update()).toBe(true);
            expect(changes).toBe(1);
            expect(orbit.update()).toBe(false);
            expect(changes).toBe(1);
        },
    );
});
