// Keys for the view, wherever the focus is.
import type { AppModel } from '../base/appModel.ts';
import { isTyping } from '../base/typing.ts';

export function listenForViewKeys({ view, scene, people }: AppModel): void {
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
