// The life of a session on this page: connect, wait for data, join or create, mirror the server's
// records, and do the same again after every interruption.
import { apiLevel } from '../protocol/version.ts';
import type { Notification, Patch, SessionSnapshot } from '../protocol/messages.ts';
import type { FlowScene } from '../scene/scene.ts';
import type { AppState } from '../state/appState.ts';
import { keep, recall } from '../state/browserMemory.ts';
import { CallError, type WorkerClient, type WorkerEvent } from '../worker/workerClient.ts';
import { isDisconnected, tellUnlessCut } from './base/lostConnection.ts';
import { defaultLength, defaultRake, defaultSeeds } from './edits/defaults.ts';
import type { Edits } from './edits/edits.ts';
import { makeAnew, rememberedOf } from './view/madeAnew.ts';
import type { ImportWait } from './importWait.ts';
import { OpenDataset } from './openDataset.ts';
import type { People } from './people/people.ts';
import { adoptSnapshot, applyPatches } from './recordMirror.ts';
import type { SurfaceProgress } from './surface/surfaceProgress.ts';
import type { SurfaceFeed } from './surface/surfaceFeed.ts';
import type { UrlState } from './view/urlState.ts';
import type { Views } from './view/views.ts';

const notFound = -32004;
const nameKept = 'name';
/** Notices before the server closes the connection, which the page tells in its own words. */
const farewells: ReadonlySet<string> = new Set(['displaced', 'removed', 'linkEnded']);

export interface SessionControllerOptions {
    state: AppState;
    scene: FlowScene;
    worker: WorkerClient;
    edits: Edits;
    feed: SurfaceFeed;
    people: People;
    progress: Pick<SurfaceProgress, 'progressed'>;
    imports: Pick<ImportWait, 'begin' | 'left'>;
    url: UrlState;
    views: Pick<Views, 'restore' | 'madeAnew'>;
}

export class SessionController {
    private readonly options: SessionControllerOptions;
    private readonly dataset: OpenDataset;
    private session: string | null;
    private resumeToken: string | undefined;
    /** Counts connections; what an earlier one began must not go on in the next. */
    private connectionNumber = 0;
    /** While records are made anew one by one, the page keeps showing those that were lost. */
    private rebuilding = false;

    constructor(options: SessionControllerOptions) {
        this.options = options;
        this.dataset = new OpenDataset(options);
        this.session = options.url.session;
    }

    handle(event: WorkerEvent): void {
        const { state, feed } = this.options;
        if (event.type === 'surface') feed.receive(event);
        else if (event.type === 'notification') this.notified(event.notification);
        else if (event.type === 'roundTrip') state.roundTripMs.value = event.ms;
        else if (event.type === 'frameTrouble') {
            void feed.troubled(event.surface, event.subscription, event.reason);
        } else {
            const { type: _, ...connection } = event;
            state.connection.value = connection;
            if (connection.state === 'waiting') {
                state.retryAt.value = performance.now() + connection.retryInMs;
                state.stage.value = 'starting';
                state.catchingUp.value = new Set();
            }
            if (connection.state === 'ended') state.stage.value = 'ended';
            if (connection.state === 'refused') state.fatal.value = connection.reason;
            if (connection.state === 'open') void this.begin();
        }
    }

    private async begin(): Promise<void> {
        const { state } = this.options;
        const connection = ++this.connectionNumber;
        const gone = (): boolean => connection !== this.connectionNumber;
        state.everConnected.value = true;
        try {
            await this.checkServer();
            const snapshot = await this.join(this.session);
            const { url } = this.options;
            const shown = state.dataset.value?.dataset;
            const linked = url.dataset ?? url.state?.surfaces[0]?.dataset ?? null;
            const id = snapshot?.surfaces[0]?.dataset ?? shown ?? linked;
            const entry = await this.dataset.wait(id, gone);
            if (entry === null || gone()) return;
            await this.dataset.describe(entry.dataset);
            const own = snapshot ?? (await this.createSession(entry.dataset));
            // Whoever has taken everything away wants it so; a session without anything is a new one.
            const empty = own.surfaces.length + own.rakes.length === 0;
            if (empty && (snapshot === null || connection === 1) && state.role.value !== 'viewer') {
                await this.addDefaultSurface(entry.dataset);
            }
            if (gone()) return;
            await this.subscribeAll();
            state.stage.value = 'running';
            this.options.views.restore();
        } catch (error) {
            if (gone() || isDisconnected(error)) return;
            state.stage.value = 'failed';
            state.notice.value = error instanceof Error ? error.message : String(error);
        }
    }

    private async checkServer(): Promise<void> {
        const info = await this.options.worker.call('server.info', {});
        this.options.state.capabilities.value = info.capabilities;
        if (info.apiLevel === apiLevel) return;
        this.options.state.notice.value =
            'The server speaks another version of the protocol than this page. Reload the page.';
    }

    /** Null when there is no such session (any more). */
    private async join(session: string | null): Promise<SessionSnapshot | null> {
        if (session === null) return null;
        const { state } = this.options;
        try {
            const snapshot = await this.enter(session);
            this.adopt(snapshot);
            return snapshot;
        } catch (error) {
            if (!isNotFound(error)) throw error;
            this.resumeToken = undefined;
            if (state.rakes.value.size === 0) {
                state.notice.value = sessionGone(this.options.url);
            }
            return null;
        }
    }

    private async enter(session: string): Promise<SessionSnapshot> {
        const resume = this.resumeToken === undefined ? {} : { resumeToken: this.resumeToken };
        const name = recall(nameKept);
        const asked = { session, ...resume, ...(name === null ? {} : { name }) };
        const joined = await this.options.worker.call('session.join', asked);
        this.session = session;
        if (joined.resumeToken !== this.resumeToken) this.options.edits.history.clear();
        this.resumeToken = joined.resumeToken;
        this.options.state.role.value = joined.role ?? 'host';
        this.options.state.session.value = session;
        this.options.people.joined(joined);
        return joined.snapshot;
    }

    /** How others see this page's user, here and from now on; the server may add a number to tell two apart. */
    async rename(name: string): Promise<void> {
        keep(nameKept, name);
        if (this.session === null || this.resumeToken === undefined) return;
        try {
            await this.enter(this.session);
            this.options.state.problems.solved('name');
        } catch (error) {
            tellUnlessCut(this.options.state.problems, 'name', error);
        }
    }

    /** A new session, with what the user had if the server has forgotten an earlier one. */
    private async createSession(dataset: string): Promise<SessionSnapshot> {
        const { worker, state, url, views } = this.options;
        const former = rememberedOf(state, url, dataset);
        const shape = state.rakeShape.value;
        const active = state.rake.value?.rake;
        const forgotten = this.session;
        const { session } = await worker.call('session.create', {});
        this.rebuilding = true;
        try {
            await this.enter(session);
            const made = await makeAnew(worker, former, (record) =>
                record.rake === active && shape.points.length > 0 ? shape : record,
            );
            // An edit of meanwhile lies below what was made anew, for the server.
            this.options.edits.history.clear();
            views.madeAnew(made);
            if (made.missing !== null) state.notice.value = made.missing;
        } catch (error) {
            // What is on the page is not all in the new session: the next connection begins again with another.
            this.session = forgotten;
            throw error;
        } finally {
            this.rebuilding = false;
        }
        const snapshot = await this.join(session);
        if (snapshot === null) throw new Error('The new session disappeared at once.');
        return snapshot;
    }

    private async addDefaultSurface(dataset: string): Promise<void> {
        const { worker, state } = this.options;
        const description = state.dataset.value;
        if (description === null) return;
        const { rake } = await worker.call('rake.set', {
            kind: 'line',
            points: defaultRake(description.bounds),
            seeds: defaultSeeds,
            name: 'Rake 1',
        });
        const from = state.times.value[0] ?? 0;
        const length = defaultLength(description.bounds, state.speedRange.value[1]);
        await worker.call('surface.set', { rake, dataset, kind: 'stream', from, to: from + length });
        await this.join(this.session);
    }

    private async subscribeAll(): Promise<void> {
        const { feed, edits } = this.options;
        feed.reset();
        edits.reconnected();
        const asked = new Set<string>();
        const next = (): string | undefined => {
            const { surfaces } = this.options.state;
            return [...surfaces.value.keys()].find((surface) => !asked.has(surface));
        };
        // Others make and delete surfaces meanwhile.
        for (let surface = next(); surface !== undefined; surface = next()) {
            asked.add(surface);
            await this.subscribe(surface);
        }
    }

    private async subscribe(surface: string): Promise<void> {
        const { feed, state } = this.options;
        try {
            await feed.subscribe(surface);
        } catch (error) {
            if (!isNotFound(error) || state.surfaces.value.has(surface)) throw error;
        }
    }

    /** One that somebody has added since. */
    private async subscribeLate(surface: string): Promise<void> {
        try {
            await this.subscribe(surface);
        } catch (error) {
            // A lost connection is told of elsewhere, and all are subscribed again after it.
            if (isDisconnected(error)) return;
            this.options.state.notice.value = error instanceof Error ? error.message : String(error);
        }
    }

    private adopt(snapshot: SessionSnapshot): void {
        adoptSnapshot(this.options.state, snapshot);
        this.options.edits.recordsChanged();
    }

    private notified(notification: Notification): void {
        const { state, feed } = this.options;
        switch (notification.method) {
            case 'session.patched':
                if (notification.session === this.session && !this.rebuilding) {
                    this.patched(notification.patches);
                }
                break;
            case 'surface.done':
                feed.done(notification.surface, notification.epoch, notification.error);
                break;
            case 'dataset.patched':
                this.dataset.patched(notification.dataset, notification.change);
                break;
            case 'server.notice':
                if (notification.text !== null && !farewells.has(notification.kind)) {
                    state.notice.value = notification.text;
                }
                this.noticed(notification.kind, notification.surface ?? '');
                break;
            case 'presence.patched':
                this.options.people.patched(notification.participants, notification.left);
                break;
            case 'cache.patched':
                this.dataset.stepsPatched(notification.dataset, notification.changes);
                break;
            case 'surface.progress':
                feed.progressed(notification.surface, notification.epoch, notification.seconds);
                break;
            case '$/progress':
                this.options.progress.progressed(notification.token, notification.fraction, notification.message);
                break;
        }
    }

    private noticed(kind: string, surface: string): void {
        const { catchingUp } = this.options.state;
        if (kind !== 'catchingUp' && kind !== 'caughtUp') return;
        const surfaces = new Set(catchingUp.value);
        if (kind === 'catchingUp') surfaces.add(surface);
        else surfaces.delete(surface);
        catchingUp.value = surfaces;
    }

    private patched(patches: readonly Patch[]): void {
        const { state, feed } = this.options;
        const { added, removed, asked } = applyPatches(state, patches);
        for (const surface of removed) feed.removed(surface);
        for (const { surface, epoch } of asked) feed.requested(surface, epoch);
        this.options.edits.recordsChanged();
        if (state.stage.value === 'running') for (const id of added) void this.subscribeLate(id);
    }

}

function isNotFound(error: unknown): boolean {
    return error instanceof CallError && error.failure.code === notFound;
}

function sessionGone({ state }: UrlState): string {
    const like = state !== null && state.rakes.length > 0;
    return `The session of this link no longer exists; this is a new one${like ? ' with its rakes and surfaces' : ''}.`;
}
