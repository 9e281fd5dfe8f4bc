// One half of a comparison: what of a page the other half is linked with. The right one is a page of its own, of a copy of the session,
// without the panel and the time controls.
import type { FlowScene } from '../../scene/scene.ts';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import type { Edits } from '../edits/edits.ts';
import type { FieldColours } from '../picture/fieldColours.ts';
import { timeWords } from '../picture/writtenNumbers.ts';
import type { ClockControl } from '../time/clockControl.ts';
import type { Playback } from '../time/playback.ts';

export interface Half {
    state: AppState;
    view: ViewState;
    scene: Pick<FlowScene, 'onDraw'> & {
        controls: Pick<FlowScene['controls'], 'follow' | 'onMove' | 'pose'>;
        loop: Pick<FlowScene['loop'], 'request'>;
    };
    edits: Pick<Edits, 'chooseRake' | 'chooseSurface' | 'follow' | 'onMove' | 'turnToo'>;
    colours: FieldColours;
    playback: Pick<Playback, 'goTo' | 'mode' | 'time'>;
    clock: Pick<ClockControl, 'set'>;
    worker: Pick<WorkerClient, 'call'>;
}

/** The dataset, and the time of its picture. */
export function shownWords({ state, view, playback }: Pick<Half, 'state' | 'view' | 'playback'>): string {
    const dataset = state.dataset.value;
    if (dataset === null || state.stage.value === 'starting') return 'loading…';
    const name = isolated(dataset.name);
    return dataset.steady || dataset.times.length < 2 ? name : `${name}, t = ${timeWords(state, view, playback.time.value)}`;
}
