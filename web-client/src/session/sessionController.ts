// The life of a session on this page: connect, join, wait for data, mirror the server's records, and do the
// same again after every interruption. It makes no session by itself: what the server does not have (any
// more) is said, with what can be done about it.
import type { ConnectionState } from '../connection/liveSocket.ts';
import { apiLevel, type JoinedSession, type Patch, type SessionSnapshot } from '../protocol/messages.ts';
import type { AppState } from '../state/appState.ts';
import { keep } from '../state/browserMemory.ts';
import type { WorkerClient } from '../worker/workerClient.ts';
import { isDisconnected, announceUnlessDisconnected } from './base/calls.ts';
import type { Edits } from './edits/edits.ts';
import type { UndoHistory } from './edits/undoHistory.ts';
import type { OpenDataset } from './openDataset.ts';
import type { People } from './people/people.ts';
import { adoptSnapshot, applyPatches } from './recordMirror.ts';
import { isNotFound, personNameKey, rememberSession, SessionJoin } from './sessions/joinSession.ts';
import type { Thumbnails } from './out/thumbnails.ts';
import { addDefaultScene, isEmpty, type Suggestions, wasEdited } from './sessions/defaultScene.ts';
import type { SurfaceFeed } from './surface/surfaceFeed.ts';
import { isEmptyContent, knownContent, recoverSession, type SessionContent } from './view/sessionRecovery.ts';
import type { UrlState } from './view/urlState.ts';
import type { Views } from './view/views.ts';

/** Pages that have lost the same session make it again in turn, lest each does. */
const turnMs = 1500;
/** Another user may bring a session back from the trash. */
const retryAfterMs = 5000;
/** Between two tries of what the server refuses. */
const longestPauseMs = 60_000;

export interface SessionControllerOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    dataset: Pick<OpenDataset, 'wait' | 'describe'>;
    feed: Pick<SurfaceFeed, 'subscribe' | 'reset' | 'requested' | 'removed'>;
    edits: Pick<Edits, 'reconnected' | 'recordsChanged'> & { history: Pick<UndoHistory, 'clear'> };
    people: Pick<People, 'joined'>;
    suggestions: Pick<Suggestions, 'here'>;
    views: Pick<Views, 'restore' | 'recovered'>;
    thumbnails: Pick<Thumbnails, 'patched'>;
    url: UrlState;
    /** The session was empty, and has a first rake and surface now. */
    filled: () => void;
    /** Brings its records into another form before they are shown; false: they are as they were. */
    prepare?: ((snapshot: SessionSnapshot) => Promise<boolean>) | undefined;
}

export class SessionController {
    private readonly options: SessionControllerOptions;
    private readonly sessionJoin: SessionJoin;
    /** Counts connections, and new beginnings in one; what an earlier one began must not go on in the
     *  next. */
    private beginning = 0;
    /** Beginnings in a row that the server has refused. */
    private failures = 0;
    /** The page has shown this session. */
    private shown = false;
    /** What is to be made again where the server has lost it; while there is such, the page keeps
     *  showing it. */
    private lost: SessionContent | null = null;

    constructor(options: SessionControllerOptions) {
        this.options = options;
        this.sessionJoin = new SessionJoin(options.worker, options.url.session);
    }

    connectionChanged(connection: ConnectionState): void {
        const { state } = this.options;
        state.connection.value = connection;
        if (connection.state === 'waiting') {
            state.retryAt.value = performance.now() + connection.retryInMs;
            state.stage.value = 'starting';
            state.catchingUp.value = new Set();
        }
        // The picture stays; what may help is in the banner.
        if (connection.state === 'ended' || connection.state === 'refused') state.stage.value = 'ended';
        if (connection.state === 'broken') state.fatal.value = connection.reason;
        if (connection.state === 'open') void this.begin();
    }

    /** Sets how other users see that of this page, here and from now on; the server may add a number to tell
     *  two apart. */
    async rename(name: string): Promise<void> {
        keep(personNameKey, name);
        const { session, resumeToken } = this.sessionJoin;
        if (session === null || resumeToken === undefined) return;
        try {
            this.entered(await this.sessionJoin.enter(session), resumeToken);
            this.options.state.problems.solved('name');
        } catch (error) {
            announceUnlessDisconnected(this.options.state.problems, 'name', error);
        }
    }

    /** Out of the trash, where it is. */
    async restore(): Promise<void> {
        const { state, worker } = this.options;
        const gone = state.gone.value;
        if (gone === null) return;
        await this.attempt('session.restore', async () => {
            await worker.call('session.restore', { session: gone.session });
            await this.begin();
        });
    }

    /** Some session is out of the trash again, perhaps the one of this page. */
    restored(session: string): void {
        if (this.options.state.gone.value?.session === session) void this.begin();
    }

    /** A new session, with what this page or its link knows of the one that is gone. */
    async recover(): Promise<void> {
        const { state, worker } = this.options;
        const name = state.gone.value?.name ?? '';
        await this.attempt('session.create', async () => {
            const { session } = await worker.call('session.create', name === '' ? {} : { name });
            [this.sessionJoin.session, this.sessionJoin.resumeToken, this.shown] = [session, undefined, false];
            await this.begin();
        });
    }

    /** A user has changed records; what is of another session, or of one that is being made again, is not
     *  taken. */
    patched(session: string, patches: readonly Patch[]): void {
        const { state, feed, edits, thumbnails } = this.options;
        if (session !== this.sessionJoin.session || this.lost !== null) return;
        if (patches.some(({ type }) => type !== 'clock')) thumbnails.patched();
        const { added, removed, requested } = applyPatches(state, patches);
        for (const surface of removed) feed.removed(surface);
        for (const { surface, epoch } of requested) feed.requested(surface, epoch);
        edits.recordsChanged();
        if (state.stage.value === 'running') for (const id of added) void this.subscribeLate(id);
    }

    /** The session that this page is in was moved to the trash. */
    async deleted(): Promise<void> {
        this.sessionJoin.resumeToken = undefined;
        await this.missing();
    }

    private async attempt(about: string, action: () => Promise<void>): Promise<void> {
        const { problems } = this.options.state;
        try {
            await action();
            problems.solved(about);
        } catch (error) {
            announceUnlessDisconnected(problems, about, error);
        }
    }

    private async begin(): Promise<void> {
        const { state, url, views, dataset } = this.options;
        const beginning = ++this.beginning;
        const gone = (): boolean => beginning !== this.beginning;
        state.everConnected.value = true;
        try {
            await this.checkServer();
            const before = this.sessionJoin.resumeToken;
            let joined = await this.sessionJoin.join(url.dataset);
            if (gone()) return;
            if (joined === null) {
                await this.missing();
                return;
            }
            this.entered(joined, before);
            const prepared = await this.options.prepare?.(joined.snapshot);
            if (prepared === true) joined = await this.sessionJoin.enter(joined.snapshot.session);
            const { snapshot } = joined;
            const mayMake = state.role.value !== 'viewer';
            const mayFill = mayMake && url.beside !== true;
            const newLife = joined.resumeToken !== before;
            if (this.lost === null && newLife && mayMake && isEmpty(snapshot)) await this.look(snapshot.session);
            if (this.lost === null) this.adopt(snapshot);
            const entry = await dataset.wait(this.datasetOf(snapshot), gone);
            if (entry === null || gone()) return;
            await dataset.describe(entry.dataset);
            if (this.lost !== null) await this.recoverInto(joined, entry.dataset);
            else if (mayFill && !this.shown && (await addDefaultScene(this.options, entry.dataset, snapshot))) {
                this.adopt((await this.sessionJoin.enter(snapshot.session)).snapshot);
                this.options.filled();
            }
            if (gone()) return;
            await this.subscribeAll();
            this.shown = true;
            state.stage.value = 'running';
            this.failures = 0;
            views.restore();
            this.sayDataset(entry.dataset);
            if (url.beside === true) return;
            rememberSession({ session: snapshot.session, created: joined.created ?? '', dataset: entry.dataset });
        } catch (error) {
            if (gone() || isDisconnected(error)) return;
            state.stage.value = 'failed';
            state.notices.tell('start', error, { label: 'Try again', act: () => void this.begin() });
            // What was too much for the server now may not be later.
            const pause = Math.min(retryAfterMs * 2 ** this.failures++, longestPauseMs);
            setTimeout(() => {
                if (!gone() && state.stage.value === 'failed') void this.begin();
            }, pause);
        }
    }

    private async checkServer(): Promise<void> {
        const { state, worker } = this.options;
        const info = await worker.call('server.info', {});
        state.capabilities.value = info.capabilities;
        if (info.apiLevel === apiLevel) return;
        state.notices.say('protocol', 'The server speaks another version of the protocol than this page. Reload the page.');
    }

    /** @param before the resume token of the last stay */
    private entered(joined: JoinedSession, before: string | undefined): void {
        const { state, edits, people } = this.options;
        if (joined.resumeToken !== before) edits.history.clear();
        state.role.value = joined.role;
        state.session.value = joined.snapshot.session;
        state.sessionName.value = joined.snapshot.name;
        state.copyOf.value = joined.copyOf ?? null;
        state.gone.value = null;
        state.notices.solved('start');
        people.joined(joined);
    }

    /** Checks whether an empty session has lost what this page or its link remembers. */
    private async look(session: string): Promise<void> {
        const { state, url, worker } = this.options;
        const content = knownContent(state, url);
        if (isEmptyContent(content) || (await wasEdited(worker, session))) return;
        this.lost = content;
    }

    /** Also after a connection that was lost in the middle of it. */
    private async recoverInto(joined: JoinedSession, dataset: string): Promise<void> {
        const { worker, views, edits, state } = this.options;
        const lost = this.lost!;
        let there = joined.snapshot;
        const place = joined.participants.findIndex(({ participant }) => participant === joined.you);
        for (let turn = 0; turn < place && isEmpty(there); ++turn) {
            await new Promise((resolve) => setTimeout(resolve, turnMs));
            there = (await this.sessionJoin.enter(there.session)).snapshot;
        }
        if (isEmpty(joined.snapshot) === isEmpty(there)) {
            const shown = <Of extends { dataset: string }>(records: Of[]): Of[] =>
                records.filter(
                    (each) => each.dataset === dataset || state.datasets.value.some((known) => known.dataset === each.dataset),
                );
            const { surfaces, slices, lines } = lost;
            const content = { ...lost, surfaces: shown(surfaces), slices: shown(slices), lines: shown(lines) };
            const made = await recoverSession(worker, content, there);
            // An edit of meanwhile lies below what was made again, for the server.
            edits.history.clear();
            views.recovered(made);
            if (made.missing !== null) state.notices.say('made again', made.missing);
            there = (await this.sessionJoin.enter(there.session)).snapshot;
        }
        this.lost = null;
        this.adopt(there);
    }

    private datasetOf(snapshot: SessionSnapshot): string | null {
        const { state, url } = this.options;
        const firstOf = ({
            surfaces,
            slices,
            lines,
        }: Pick<SessionSnapshot, 'surfaces' | 'slices' | 'lines'>): string | undefined =>
            [surfaces, slices, lines].flat()[0]?.dataset;
        const linked = url.dataset ?? (url.state === null ? undefined : firstOf(url.state)) ?? null;
        const records = [snapshot.surfaces, snapshot.slices, snapshot.lines].flat();
        const worked = state.dataset.value?.dataset;
        // After an interruption the one that is worked on, though the session may have more.
        const there = [worked, url.dataset].find((id) => records.some(({ dataset }) => dataset === id));
        return there ?? firstOf(snapshot) ?? worked ?? linked;
    }

    /** The address asks for a dataset, and the session shows another. */
    private sayDataset(shown: string): void {
        const { state, url } = this.options;
        const requested = url.dataset;
        if (requested === null || requested === shown) return;
        url.dataset = null;
        const [there, here] = [requested, shown].map((id) => state.datasets.value.find(({ dataset }) => dataset === id)?.name);
        state.notices.say(
            'dataset',
            there === undefined
                ? `The server does not have the dataset of this link. This session shows ${here ?? shown}.`
                : `This session shows ${here ?? shown}. To see ${there}, choose it in the panel: it opens in another session, or is added to this picture.`,
        );
    }

    /** The session is not there; where it is in the trash, a user may restore it. */
    private async missing(): Promise<void> {
        const { state, worker, url } = this.options;
        const beginning = ++this.beginning;
        const session = this.sessionJoin.session ?? '';
        const trash = await worker.call('session.list', { trash: true }).catch(() => null);
        if (beginning !== this.beginning) return;
        const entry = trash?.sessions.find((each) => each.session === session);
        state.stage.value = 'gone';
        state.participants.value = new Map();
        state.gone.value = {
            session,
            name: entry?.name ?? state.sessionName.value,
            restorableUntil: entry?.deletedUntil ?? null,
            remembered: !isEmptyContent(knownContent(state, url)),
        };
        if (entry === undefined) return;
        setTimeout(() => {
            if (beginning === this.beginning) void this.begin();
        }, retryAfterMs);
    }

    private async subscribeAll(): Promise<void> {
        const { feed, edits } = this.options;
        feed.reset();
        edits.reconnected();
        const subscribed = new Set<string>();
        const next = (): string | undefined => {
            const { surfaces } = this.options.state;
            return [...surfaces.value.keys()].find((surface) => !subscribed.has(surface));
        };
        // Others make and delete surfaces meanwhile.
        for (let surface = next(); surface !== undefined; surface = next()) {
            subscribed.add(surface);
            await this.subscribe(surface);
        }
    }

    /** One that cannot be sent leaves the others as they are, and says why. */
    private async subscribe(surface: string): Promise<void> {
        const { feed, state } = this.options;
        try {
            await feed.subscribe(surface);
        } catch (error) {
            if (isDisconnected(error)) throw error;
            if (!isNotFound(error) || state.surfaces.value.has(surface)) state.notices.tell(`surface ${surface}`, error);
        }
    }

    /** One that a user has added since. A lost connection is told of elsewhere, and all are subscribed again
     *  after it. */
    private async subscribeLate(surface: string): Promise<void> {
        try {
            await this.subscribe(surface);
        } catch (error) {
            announceUnlessDisconnected(this.options.state.notices, `surface ${surface}`, error);
        }
    }

    private adopt(snapshot: SessionSnapshot): void {
        adoptSnapshot(this.options.state, snapshot);
        this.options.edits.recordsChanged();
    }
}
