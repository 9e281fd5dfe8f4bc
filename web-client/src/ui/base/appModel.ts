// What the components share: the state they show and the actions they offer.
import type { Calls } from '../../session/base/calls.ts';
import type { ClockControl } from '../../session/time/clockControl.ts';
import type { Edits } from '../../session/edits/edits.ts';
import type { Figure } from '../../session/out/figure.ts';
import type { FilmMaker } from '../../session/out/film.ts';
import type { MeshDownload } from '../../session/out/meshDownload.ts';
import type { People } from '../../session/people/people.ts';
import type { ImportWait } from '../../session/importWait.ts';
import type { Playback } from '../../session/time/playback.ts';
import type { Probing } from '../../session/tools/probing.ts';
import type { SessionShelf } from '../../session/sessions/sessionShelf.ts';
import type { SurfaceProgress } from '../../session/surface/surfaceProgress.ts';
import type { Views } from '../../session/view/views.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';

export interface AppModel {
    state: AppState;
    view: ViewState;
    edits: Edits;
    clock: ClockControl;
    playback: Playback;
    figure: Figure;
    film: FilmMaker;
    mesh: MeshDownload;
    people: People;
    scene: FlowScene;
    worker: Pick<WorkerClient, 'call'>;
    calls: Calls;
    views: Views;
    probing: Probing;
    progress: SurfaceProgress;
    imports: ImportWait;
    shelf: SessionShelf;
    rename: (name: string) => Promise<void>;
    /** What can be done where the session of this page is gone. */
    restoreSession: () => Promise<void>;
    makeSessionAgain: () => Promise<void>;
    logOut: () => Promise<void>;
    retryNow: () => void;
}
