// What the components share: the state they show and the actions they offer.
import type { ClockControl } from '../session/clockControl.ts';
import type { Edits } from '../session/edits.ts';
import type { FlowScene } from '../scene/scene.ts';
import type { AppState } from '../state/appState.ts';
import type { ViewState } from '../state/viewState.ts';

export interface AppModel {
    state: AppState;
    view: ViewState;
    edits: Edits;
    clock: ClockControl;
    scene: FlowScene;
    retryNow: () => void;
}
