// Keys for the view, wherever the focus is.
import type { FlowScene } from '../../scene/scene.ts';
import type { People } from '../../session/people/people.ts';
import type { ViewState } from '../../state/viewState.ts';
import { isTyping } from '../base/typing.ts';

export interface ViewKeysModel {
    view: Pick<ViewState, 'tool'>;
    scene: Pick<FlowScene, 'controls' | 'loop'>;
    people: Pick<People, 'startFollowing'>;
}

export function listenForViewKeys({ view, scene, people }: ViewKeysModel): void {
    addEventListener('keydown', (event) => {
        if (isTyping(event) || event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.key === 'f') {
            scene.controls.show('oblique');
            scene.loop.request();
        } else if (event.key === 'Escape') {
            view.tool.value = 'none';
            people.startFollowing(null);
        }
    });
}
