// Puts the page together. The path of a datum: worker/ (socket, decoding) -> session/ (records,
// newest state) -> scene/ (pixels); the path of an edit: scene/ or ui/ -> session/edits -> worker/. Each part
// is made of parts that are made above it, and each panel is handed what it uses.
import { computed } from '@preact/signals-core';
import { type Graphics, probeGraphics } from './scene/graphics.ts';
import { FlowScene } from './scene/scene.ts';
import type { ScreenPoint } from './scene/base/view.ts';
import type { Beside, BesideOptions } from './session/compare/compare.ts';
import { type Half, shownWords } from './session/compare/half.ts';
import { Calls } from './session/base/calls.ts';
import { connect, type Connected } from './session/connect.ts';
import { ClockControl } from './session/time/clockControl.ts';
import { Edits } from './session/edits/edits.ts';
import { pictureIsCoarse } from './session/out/exportNames.ts';
import { type BesideFigure, Figure } from './session/out/figure.ts';
import { FilmMaker } from './session/out/film.ts';
import { MeshDownload } from './session/out/meshDownload.ts';
import { scriptedPage } from './session/out/scriptedPicture.ts';
import { Thumbnails } from './session/out/thumbnails.ts';
import { frameFirstSurface } from './session/picture/initialView.ts';
import { announceLostGraphics, showStillPictures, showTheme } from './session/picture/drawingSettings.ts';
import { showMarks } from './session/picture/marksInPicture.ts';
import { Measuring, Noting, Probing } from './session/tools/pointTools.ts';
import { FieldColours } from './session/picture/fieldColours.ts';
import { connectChosenThings } from './session/picture/chosenThings.ts';
import { hideSurfaces, measurePixels, showLooks } from './session/picture/looksInPicture.ts';
import { BodyFields } from './session/picture/bodyFields.ts';
import { announceMissingFields } from './session/picture/surfaceFields.ts';
import { ImportWait } from './session/importWait.ts';
import { OpenDataset } from './session/openDataset.ts';
import { connectPainting } from './session/tools/painting.ts';
import { People } from './session/people/people.ts';
import { Pointing, showPeople } from './session/people/peopleInPicture.ts';
import { Means } from './session/means.ts';
import { Families } from './session/surface/families.ts';
import { playOnce } from './session/time/firstPlay.ts';
import { chooseKind } from './session/time/kindChoice.ts';
import { Playback } from './session/time/playback.ts';
import { Suggestions } from './session/sessions/defaultScene.ts';
import { connectRakes, showRakes } from './session/picture/rakesInPicture.ts';
import { dispatchWorkerEvent, ServerEvents } from './session/serverEvents.ts';
import { SessionController } from './session/sessionController.ts';
import { followHistory, openFragment, readNewLink } from './session/view/urlState.ts';
import { OwnCopy } from './session/sessions/ownCopy.ts';
import { SessionList } from './session/sessions/sessionList.ts';
import { SurfaceOutcomes, SurfaceProgress } from './session/surface/surfaceProgress.ts';
import { SurfaceFeed } from './session/surface/surfaceFeed.ts';
import { Bodies } from './session/picture/bodies.ts';
import { loadOtherDatasets } from './session/picture/loadOtherDatasets.ts';
import { showUnits, typeUnits } from './session/picture/writtenNumbers.ts';
import { Views } from './session/view/views.ts';
import { AppState } from './state/appState.ts';
import { LatencyLog } from './state/latency.ts';
import type { SlicePlane } from './state/pageView.ts';
import { ViewState } from './state/viewState.ts';
import { App } from './ui/app.ts';
import type { PanelModel } from './ui/panel.ts';
import { loadCompare, noComparison } from './ui/compare/loadCompare.ts';
import { listenForPresses, listenForUndoKeys } from './ui/base/keyboard.ts';
import { recallPanel } from './ui/view/room.ts';
import { listenForViewKeys } from './ui/view/viewKeys.ts';
import { loadPlots } from './ui/plots/loadPlots.ts';
import { loadBodyRakes } from './ui/rake/loadBodyRakes.ts';
import { loadLines } from './ui/lines/loadLines.ts';
import { loadSlices } from './ui/slices/loadSlices.ts';

const noWebGl2 =
    'This browser does not offer WebGL2, which the picture needs. Use a current browser, and allow ' +
    'hardware or software rendering in its settings.';

const loggedOut = 'You are logged out. Open the link that wakesurf printed, or the one that you were given, to come back.';

/** A page, as another one has it beside it. */
interface Page extends Beside {
    app: App;
    panel: PanelModel;
    edits: Edits;
    figure: Figure;
}

/** @param beside of the right half of a comparison; null: this is the page itself */
function start(app: App, { url, server, worker }: Connected, graphics: Graphics, beside: BesideOptions | null): Page {
    const state = new AppState();
    const view = new ViewState();
    const latency = new LatencyLog();
    const { canvas, labels } = app;
    const scene = new FlowScene({ canvas, labels, graphics });
    const requestFrame = scene.loop.request;
    const edits = new Edits({ state, worker, latency, requestFrame, dragging: () => scene.interaction.dragging });
    const people = new People({ state, view, worker, controls: scene.controls, requestFrame });
    const calls = new Calls(state, worker, {
        begin: () => edits.gestures.begin(),
        taken: (gesture) => edits.history.noted(gesture),
    });
    const progress = new SurfaceProgress({ state, worker, calls });
    showPeople(state, view, scene);
    showTheme(view, scene);
    announceLostGraphics(state, canvas);
    showStillPictures(view, scene, graphics);
    showMarks(state, view, scene);
    showUnits(state, view, scene);
    const sight = {
        pick: (at: ScreenPoint) => scene.pick(at),
        rakeAt: (at: ScreenPoint) => scene.rakes.pointUnder(at, scene.view()),
    };
    const probing = new Probing({ state, pageView: view, worker, requestFrame, ...sight });
    const pointing = new Pointing({ state, people, requestFrame, ...sight });
    for (const tool of [
        probing,
        new Measuring({ state, pageView: view, ...sight }),
        new Noting({ state, pageView: view, ...sight }),
        pointing,
    ]) {
        scene.pointerTools.add(tool);
    }
    hideSurfaces(state, view);
    connectChosenThings({ state, view, scene });
    measurePixels(scene.controls, state, view.pixelsPerLength);
    connectPainting(view, scene);
    frameFirstSurface({
        ...{ state, controls: scene.controls, surfaces: scene.surfaces },
        dragging: () => scene.interaction.dragging,
    });
    scene.controls.onMove(() => people.takeCamera());
    const feed = new SurfaceFeed({ state, scene, worker, latency });
    const outcomes = new SurfaceOutcomes({ state, worker });
    const views = new Views({ state, view, scene, url });
    const ownCopy = new OwnCopy({ state, calls, views });
    announceMissingFields({ state, view, ownCopy });
    connectRakes({ state, view, scene, edits, people, ownCopy });
    const imports = new ImportWait({ state, worker });
    const thumbnails = new Thumbnails({
        ...{ state, worker, edits },
        picture: (size) => scene.copySmall(size),
        busy: () => scene.interaction.dragging || document.visibilityState !== 'visible',
    });
    const bodies = new Bodies(state, worker);
    const dataset = new OpenDataset({ state, view, scene, worker, bodies, imports });
    loadOtherDatasets({ state, view, scene, worker, bodies, turnTo: (other) => dataset.turnTo(other) });
    const suggestions = new Suggestions(state, worker);
    const controller = new SessionController({
        state,
        worker,
        dataset,
        suggestions,
        feed,
        edits,
        people,
        views,
        thumbnails,
        url,
        filled: () => playOnce({ state, playback }),
        prepare: beside?.prepare,
    });
    const sessionList = new SessionList({ state, worker, server, restored: (session) => controller.restored(session) });
    const clock = new ClockControl({ state, worker, requestFrame });
    const playback = new Playback({ state, edits, clock });
    const bodyFields = new BodyFields({
        ...{ state, view, scene, worker, server },
        time: () => playback.timeOf(state.dataset.value?.dataset ?? ''),
        moves: () => playback.mode.value === 'clock',
    });
    const colours = new FieldColours();
    const inPicture = {
        ...{ state, view, scene, colours, server, worker, edits },
        time: (dataset: string) => playback.timeOf(dataset),
    };
    const [slices, lines] = [loadSlices(inPicture), loadLines(inPicture)];
    const bodyRakes = loadBodyRakes({ state, view, scene, actions: edits.actions });
    const slicePlane = (id: string): SlicePlane | undefined => (slices.model.value?.slices.places ?? state.slices).value.get(id);
    showLooks({ state, view, scene, worker, slicePlane });
    const fieldsShown = { waiting: computed(() => slices.waiting.value || lines.waiting.value) };
    const families = new Families({ state, worker, edits, clock, time: () => playback.time.value });
    const means = new Means({ state, worker });
    const events = new ServerEvents({
        state,
        feed,
        outcomes,
        people,
        progress,
        longCalls: [families, means],
        dataset,
        controller,
    });
    const findBar = (): HTMLElement | null => labels.parentElement?.querySelector<HTMLElement>('wakesurf-scalar-bar') ?? null;
    const figure = new Figure(scene, findBar, { state, worker });
    const film = new FilmMaker({
        ...{ state, view, worker, edits, playback, bodyFields, fieldsShown, figure },
        controls: scene.controls,
    });
    const mesh = new MeshDownload(server);
    scene.loop.beforeFrame(() => edits.flush());
    scene.loop.beforeFrame(() => clock.flush());
    scene.loop.beforeFrame(() => probing.flush());
    scene.loop.beforeFrame(() => pointing.flush());
    scene.loop.beforeFrame(() => feed.apply());
    showRakes(state, view, scene);
    const parts = { state, view, scene, bodyFields, fieldsShown };
    const scripted = scriptedPage({ ...parts, slices: slices.model, latency, canvas, figure });
    Object.assign(window, { [beside === null ? 'wakesurf' : 'wakesurfBeside']: scripted });
    const half = { app, figure, state, view, scene, edits, colours, playback, clock, worker, server };
    const comparison = beside === null ? loadCompare<Page>({ left: half, calls, views, open: openBeside }) : null;
    figure.beside = () => besideOf(half, comparison?.right.value ?? null);
    listenForPresses(edits.gestures, () => state.notices.passed('press'));
    if (comparison !== null) {
        recallPanel(view);
        listenForViewKeys({ view, scene, people });
        listenForUndoKeys(() => (comparison.chosen.value === 'right' ? (comparison.right.value?.edits ?? edits) : edits));
        followHistory(() => state.session.value);
    }
    const retryNow = (): void => worker.retryNow();
    const session = (): string | null => state.session.value ?? url.session;
    const takeLink = (text: string): boolean => {
        const link = readNewLink(text, session());
        if (link?.to === 'here') worker.logIn(link.token);
        else if (link?.to === 'session') openFragment(link.fragment);
        return link !== null;
    };
    const leave = async (): Promise<void> => {
        const more = await server.logOut();
        worker.stop();
        app.fail(more === '' ? loggedOut : `${loggedOut} ${more}`);
    };
    const panel: PanelModel = {
        beside: beside !== null,
        comparison: comparison ?? noComparison,
        state,
        view,
        ownCopy,
        help: { view },
        sessionHead: { state, view, sessionList },
        datasetHead: { state, edits, sessionList },
        pictureList: { state, view, edits, slices: slices.model, lines: lines.model },
        surface: { state, view, edits, families, chooseKind: (kind) => chooseKind({ state, edits, clock, playback }, kind) },
        rake: { state, view, edits, scene },
        slices: slices.model,
        lines: lines.model,
        bodyRakes,
        means: { state, means },
        look: { state, view, edits, scene, bodyFields, ownCopy },
        bookmarks: { state, views, calls, clock },
        probe: { state, view, probing, scene },
        surroundings: { state, view, typeUnits: (change) => void typeUnits(state, calls, change) },
        people: { state, view, people, calls, rename: (name) => controller.rename(name), logOut: leave },
        links: { state, views, calls, worker, ownCopy },
        notes: { state, view, calls, scene },
        export: {
            picture: { state, view, figure },
            film: { state, view, playback, figure, film, ownCopy },
            mesh: { state, view, mesh },
            animation: {
                ...{ state, animation: new MeshDownload(server) },
                styleOf: (id) => scene.surfaces.spanOf(id)?.style ?? null,
            },
        },
        status: { state, view, edits, progress, worker, mesh },
    };
    app.begin({
        comparison,
        state,
        scalarBar: { state, view, scene, bodyFields, slices: slices.model, lines: lines.model },
        viewButtons: { view, scene },
        tools: { state, view, comparison: comparison ?? noComparison },
        tour: { state, view, edits, playback, scene },
        banner: {
            state,
            view,
            imports,
            retryNow,
            takeLink,
            restoreSession: () => controller.restore(),
            recoverSession: () => controller.recover(),
        },
        panel,
        note: { view, calls },
        timeBar: { state, view, playback, edits, ownCopy },
        plots: loadPlots({ state, view, worker, mesh, time: () => playback.time.value }, playback),
    });
    void app.updateComplete.then(() => {
        const bar = findBar();
        if (bar !== null) scene.watchCover(bar);
    });
    addEventListener('online', retryNow);
    server.onOther(session, (login) => worker.takeLogin(login));
    const loginEnded = (login: string): void => {
        const other = server.ended(login, session());
        if (other !== null) worker.takeLogin(other);
    };
    worker.listen(
        () => scene.movingResolution.sparing,
        (event) => dispatchWorkerEvent(event, { state, feed, events, controller, loginEnded }),
    );
    const end = (): void => {
        removeEventListener('online', retryNow);
        worker.stop();
        scene.renderer.dispose();
        scene.renderer.forceContextLoss();
    };
    return { ...half, panel, end };
}

function besideOf(left: Half, right: Page | null): BesideFigure | null {
    return right === null
        ? null
        : { figure: right.figure, captions: [shownWords(left), shownWords(right)], coarse: pictureIsCoarse(right.state) };
}

function openBeside(options: BesideOptions): Page {
    const graphics = probeGraphics();
    if (graphics === null) throw new Error(noWebGl2);
    const connected = connect(options.url);
    try {
        return start(new App(), connected, graphics, options);
    } catch (error) {
        connected.worker.stop();
        throw error;
    }
}

/** Makes the page where the document has a place for it. */
export function startPage(connected: Connected): void {
    const app = document.querySelector('wakesurf-app');
    if (!(app instanceof App)) return;
    const graphics = probeGraphics();
    if (graphics !== null) {
        start(app, connected, graphics, null);
        return;
    }
    connected.worker.stop();
    app.fail(noWebGl2);
}
