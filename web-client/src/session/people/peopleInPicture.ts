// Shows the others in the picture as they come, move and go.
import { effect } from '@preact/signals-core';
import { PeopleLayer } from '../../scene/people/peopleLayer.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';

export function showPeople(state: AppState, view: ViewState, scene: FlowScene): void {
    const layer = new PeopleLayer(scene.labels);
    scene.add(layer);
    effect(() => {
        const unseen = [state.you.value, view.following.value];
        const others = [...state.participants.value.values()];
        layer.set(others.filter(({ participant, connected }) => connected && !unseen.includes(participant)));
        scene.loop.request();
    });
}
