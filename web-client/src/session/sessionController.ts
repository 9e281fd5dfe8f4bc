// The life of a session on this page: connect, wait for data, join or create, mirror the server's
// records, and do the same again after every interruption.
import { apiLevel } from '../protocol/version.ts';
import {
    errorWords,
    type DatasetDescription,
    type DatasetEntry,
    type Notification,
    type Patch,
    type RakeRecord,
    type SessionSnapshot,
    type SurfaceRecord,
} from '../protocol/messages.ts';
import type { FlowScene } from '../scene/scene.ts';
import type { AppState, ShownRake } from '../state/appState.ts';
import { keep, recall } from '../state/browserMemory.ts';
import { CallError, type WorkerClient, type WorkerEvent } from '../worker/workerClient.ts';
import { defaultLength, defaultRake, defaultSeeds } from './defaults.ts';
import type { Edits } from './edits.ts';
import type { People } from './people.ts';
import { settingAnew } from './surfaceIntent.ts';
import { adoptSnapshot, applyPatches } from './recordMirror.ts';
import { StepStates } from './stepStates.ts';
import type { SurfaceProgress } from './surfaceProgress.ts';
import type { SurfaceFeed } from './surfaceFeed.ts';
import type { UrlState } from './urlState.ts';
import type { Views } from './views.ts';

const notFound = -32004;
const importPollMs = 1000;
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
    url: UrlState;
    views: Pick<Views, 'restore'>;
}

/** What a session is rebuilt from when the server no longer knows it. */
interface Remembered {
    rakes: RakeRecord[];
    surfaces: SurfaceRecord[];
}

export class SessionController {
    private readonly options: SessionControllerOptions;
    private readonly stepStates: StepStates;
    private session: string | null;
    private resumeToken: string | undefined;
    /** Counts connections; what an earlier one began must not go on in the next. */
    private connectionNumber = 0;
    /** While records are made anew one by one, the page keeps showing those that were lost. */
    private rebuilding = false;

    constructor(options: SessionControllerOptions) {
        this.options = options;
        this.stepStates = new StepStates(options.state, options.worker);
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
            const id = snapshot?.surfaces[0]?.dataset ?? url.dataset ?? url.state?.surfaces[0]?.dataset ?? null;
            const entry = await this.waitForDataset(id, gone);
            if (entry === null || gone()) return;
            await this.describe(entry.dataset);
            const own = snapshot ?? (await this.createSession(entry.dataset));
            if (own.surfaces.length === 0 && state.role.value !== 'viewer') {
                await this.addDefaultSurface(entry.dataset);
            }
            if (gone()) return;
            await this.subscribeAll();
            state.stage.value = 'running';
            this.options.views.restore();
        } catch (error) {
            if (gone() || (error instanceof CallError && error.failure.kind === 'disconnected')) return;
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
        } catch (error) {
            this.options.state.editError.value = error instanceof Error ? error.message : String(error);
        }
    }

    private async waitForDataset(
        id: string | null,
        gone: () => boolean,
    ): Promise<DatasetEntry | null> {
        const { worker, state } = this.options;
        while (!gone()) {
            const { datasets } = await worker.call('dataset.list', {});
            const entry = id === null ? datasets[0] : datasets.find(({ dataset }) => dataset === id);
            if (entry === undefined) throw new Error(noDataset(id));
            state.datasetEntry.value = entry;
            if (entry.state === 'failed') throw new Error(importFailed(entry));
            if (entry.state === 'ready' || (entry.steps?.ready ?? 0) > 0) return entry;
            state.stage.value = 'importing';
            await new Promise((resolve) => setTimeout(resolve, importPollMs));
        }
        return null;
    }

    private async describe(dataset: string): Promise<void> {
        const { worker, state, scene } = this.options;
        const known = state.dataset.value;
        const description = await worker.call('dataset.describe', { dataset });
        state.dataset.value = description;
        void this.stepStates.load(dataset);
        if (known?.dataset === dataset) return;
        scene.setDomain(description.bounds);
        if (description.obstacle) void this.loadObstacle(description);
    }

    private async loadObstacle({ dataset, lattice }: DatasetDescription): Promise<void> {
        try {
            const geometry = await this.options.worker.obstacle(dataset, lattice);
            if (geometry !== null) {
                this.options.scene.setObstacle(geometry.positions, geometry.indices);
            }
        } catch (error) {
            this.options.state.notice.value = error instanceof Error ? error.message : String(error);
        }
    }

    /** A new session, with what the user had if the server has forgotten an earlier one. */
    private async createSession(dataset: string): Promise<SessionSnapshot> {
        const { worker, state } = this.options;
        const remembered = this.remembered(dataset);
        const shape = state.rakeShape.value;
        const active = state.rake.value?.rake;
        const forgotten = this.session;
        const { session } = await worker.call('session.create', {});
        this.rebuilding = true;
        try {
            await this.enter(session);
            await this.makeAnew(remembered, dataset, (record) =>
                record.rake === active && shape.points.length > 0 ? shape : record,
            );
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

    /** What this page has had, or else what its link says. */
    private remembered(dataset: string): Remembered {
        const { state, url } = this.options;
        const [rakes, surfaces] = [[...state.rakes.value.values()], [...state.surfaces.value.values()]];
        const known = rakes.length > 0 || url.state === null ? { rakes, surfaces } : url.state;
        return { rakes: known.rakes, surfaces: known.surfaces.filter((each) => each.dataset === dataset) };
    }

    /** `seen`: the shape on the screen, which may be ahead of the record that was lost. */
    private async makeAnew(
        remembered: Remembered,
        dataset: string,
        seen: (record: RakeRecord) => ShownRake,
    ): Promise<void> {
        const { worker } = this.options;
        const ids = new Map<string, string>();
        for (const record of remembered.rakes) {
            const { rake, seeds, name, colour } = record;
            const { kind, points } = seen(record);
            const tint = colour === undefined || colour === '' ? {} : { colour };
            const made = await worker.call('rake.set', { kind, points: [...points], seeds, name, ...tint });
            ids.set(rake, made.rake);
        }
        for (const record of remembered.surfaces) {
            const setting = settingAnew({ ...record, dataset }, ids);
            if (setting !== null) await worker.call('surface.set', setting);
        }
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
                this.datasetPatched(notification.dataset, notification.change);
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
                this.stepStates.patched(notification.dataset, notification.changes);
                break;
            case 'surface.progress':
                feed.progressed(notification.surface, notification.epoch, notification.seconds);
                break;
            case '$/progress':
                this.options.progress.progressed(notification.token, notification.fraction, notification.message);
                break;
            case 'cache.patched':
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
        if (state.stage.value === 'running') for (const id of added) void feed.subscribe(id);
    }

    private datasetPatched(dataset: string, change: Partial<DatasetEntry>): void {
        const { state } = this.options;
        const entry = state.datasetEntry.value;
        if (entry === null || entry.dataset !== dataset) return;
        const rest = { ...entry };
        delete rest.error; // a patch says what is wrong now
        state.datasetEntry.value = { ...rest, ...change };
        // The range of the velocity is known in full only now.
        if (change.state === 'ready') void this.describe(dataset).catch(() => undefined);
    }
}

function isNotFound(error: unknown): boolean {
    return error instanceof CallError && error.failure.code === notFound;
}

function sessionGone({ state }: UrlState): string {
    const like = state !== null && state.rakes.length > 0;
    return `The session of this link no longer exists; this is a new one${like ? ' with its rakes and surfaces' : ''}.`;
}

function noDataset(id: string | null): string {
    return id === null
        ? 'The server has no dataset. Start it with one: wakesurf serve DATASET.'
        : 'The server does not have the dataset of this link.';
}

function importFailed(entry: DatasetEntry): string {
    const why = entry.error === undefined ? '' : ` ${errorWords(entry.error)}`;
    return `${entry.name} could not be imported.${why}`;
}
