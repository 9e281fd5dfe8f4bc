// Keys for the view, wherever the focus is.
import type { FlowScene } from '../../scene/scene.ts';
import type { People } from '../../session/people/people.ts';
import type { ViewState } from '../../state/viewState.ts';
import { isTyping } from '../base/typing.ts';
import { turnByKey } from './cameraKeys.ts';
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

/** Arrows belong to what has the focus; the picture, and the page where nothing has it, leave them to the
 *  camera. */
function isFree(event: KeyboardEvent): boolean {
    const [at] = event.composedPath();
    return at instanceof HTMLCanvasElement || at === document.body;
}
