// Tells how many pixels a unit of length has where the camera looks, once it has come to rest: what curved
// cells are cut by.
import { effect, type Signal } from '@preact/signals-core';
import type { CameraControls } from '../../scene/camera/cameraControls.ts';
import type { AppState } from '../../state/appState.ts';

const restMs = 300;

/** In powers of two: what has been cut is good for some zooming. */
export function measurePixels(
    controls: Pick<CameraControls, 'onMove' | 'pose' | 'fov'>,
    { dataset }: Pick<AppState, 'dataset'>,
    pixels: Signal<number>,
): void {
    let rest: ReturnType<typeof setTimeout> | undefined;
    const measure = (): void => {
        const { position, target } = controls.pose;
        const away = Math.hypot(...position.map((x, i) => x - target[i]!));
        const seen = 2 * Math.tan((controls.fov * Math.PI) / 360) * away;
        const now = 2 ** Math.ceil(Math.log2((innerHeight * devicePixelRatio) / seen));
        if (Number.isFinite(now)) pixels.value = now;
    };
    const moved = (): void => {
        clearTimeout(rest);
        rest = setTimeout(measure, restMs);
    };
    controls.onMove(moved);
    effect(() => {
        void dataset.value;
        moved();
    });
}
