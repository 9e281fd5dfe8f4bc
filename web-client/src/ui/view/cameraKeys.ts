// Keys that turn, move and zoom the view while the picture has the focus, or nothing has.
import type { CameraControls } from '../../scene/camera/cameraControls.ts';

const turnStep = (5 * Math.PI) / 180;
const panStep = 0.05;
const zoomStep = 1.15;

const arrows = new Map<string, readonly [right: number, up: number]>([
    ['ArrowRight', [1, 0]],
    ['ArrowLeft', [-1, 0]],
    ['ArrowUp', [0, 1]],
    ['ArrowDown', [0, -1]],
]);
const zooms = new Map([
    ['+', zoomStep],
    ['=', zoomStep],
    ['-', 1 / zoomStep],
]);

export type TurnedView = Pick<CameraControls, 'turn' | 'pan' | 'zoom'>;

/** False where the key is none of these. */
export function turnByKey({ key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>, controls: TurnedView): boolean {
    const arrow = arrows.get(key);
    const zoom = zooms.get(key);
    if (arrow !== undefined) {
        const [right, up] = arrow;
        if (shiftKey) controls.pan(panStep * right, panStep * up);
        // The picture turns as if it were dragged that way.
        else controls.turn(turnStep * right, turnStep * up);
    } else if (zoom !== undefined) controls.zoom(zoom);
    else return false;
    return true;
}
