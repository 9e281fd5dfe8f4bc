import { PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import { FineOrbit } from './fineOrbit.ts';

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
