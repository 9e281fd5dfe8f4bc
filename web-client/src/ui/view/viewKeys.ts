// Keys for the view, wherever the focus is; those that turn, move and zoom it while the picture has the focus, or nothing has.
import type { CameraControls } from '../../scene/camera/cameraControls.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { People } from '../../session/people/people.ts';
import type { ViewState } from '../../state/viewState.ts';
import { isFree, isTyping } from '../base/keyboard.ts';
import { togglePanel, turnFullScreen } from './room.ts';

export interface ViewKeysModel {
    view: Pick<ViewState, 'tool' | 'panelFolded'>;
    scene: Pick<FlowScene, 'controls' | 'loop'>;
    people: Pick<People, 'startFollowing'>;
}

export function listenForViewKeys({ view, scene, people }: ViewKeysModel): void {
    addEventListener('keydown', (event) => {
        if (isTyping(event) || event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.key === 'f') {
            scene.controls.show('oblique');
            scene.loop.request();
        } else if (event.key === 'p') togglePanel(view);
        else if (event.key === 'F') turnFullScreen();
        else if (event.key === 'Escape') {
            view.tool.value = 'none';
            people.startFollowing(null);
        } else if (isFree(event) && turnByKey(event, scene.controls)) {
            event.preventDefault();
            scene.loop.request();
        }
    });
}

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
