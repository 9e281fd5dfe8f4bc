// What the page knows, as signals: the connection, and mirrors of the server's records. Written by
// session/, read by ui/.
import { computed, signal } from '@preact/signals-core';
import type { ConnectionState } from '../connection/liveSocket.ts';
import type { SurfacePart } from '../mesh/meshChange.ts';
import type { Phase } from '../protocol/meshFrame.ts';
import type {
    AnnotationRecord,
    BookmarkRecord,
    ClockRecord,
    DatasetDescription,
    DatasetEntry,
    Participant,
    RakeKind,
    RakeRecord,
    LinesRecord,
    SliceRecord,
    ResultOf,
    Role,
    StepHeld,
    SurfaceRecord,
    SurfaceStats,
    ValueRange,
    Vec3,
} from '../protocol/messages.ts';
import { Announcements } from './announcements.ts';
import type { LatencySample } from './latency.ts';

/** What is on the screen of one surface. */
export interface DisplayedSurface {
    surface: string;
    epoch: number;
    vertices: number;
    cells: number;
    triangles: number;
    stateSum: number;
    phase: Phase;
    /** Simulation time. */
    time: number;
    /** Updates from which it came, since the page knows it: whole states, and changes of the one before. */
    keys: number;
    deltas: number;
    /** Attributes that came with it and are not here; those that a look needs follow when the worker knows of
     *  it. */
    withheld: readonly string[];
    /** Drawn of curved cells. */
    curved: boolean;
}

export interface ShownRake {
    kind: RakeKind;
    points: readonly Vec3[];
}

/** `gone`: connected, but the session is not there (any more). */
export type Stage = 'starting' | 'importing' | 'running' | 'failed' | 'gone' | 'ended';

/** The session of this page, which the server does not have (any more). */
export interface GoneSession {
    session: string;
    name: string;
    /** Where it is in the trash: until when it can be restored from there, UTC. */
    restorableUntil: string | null;
    /** Rakes and surfaces are on this page or in its link, of which it can be made again. */
    remembered: boolean;
}

/** How much of the dataset's time-steps is in the server's memory, or on its way there; of large
 *  ones a part, which is read by brick. */
export interface HeldSteps {
    /** Bytes of each. */
    steps: readonly StepHeld[];
    /** Bytes of one that is all there. */
    whole: number;
}

export class AppState {
    /** Why nothing can be shown at all; null when all is well. */
    readonly fatal = signal<string | null>(null);
    readonly connection = signal<ConnectionState>({ state: 'connecting', attempt: 1 });
    /** On performance.now()'s clock, while waiting to try again. */
    readonly retryAt = signal(0);
    readonly everConnected = signal(false);
    readonly stage = signal<Stage>('starting');
    /** What the server says it can do; what is not named here it cannot. */
    readonly capabilities = signal<readonly string[]>([]);
    /** All that the server has. */
    readonly datasets = signal<readonly DatasetEntry[]>([]);
    /** The picture has what of the boundary is no part of the body, too. */
    readonly allPatchesShown = signal(false);
    readonly datasetEntry = signal<DatasetEntry | null>(null);
    /** The one that is worked on: that of what is chosen. */
    readonly dataset = signal<DatasetDescription | null>(null);
    /** The others of which the session has something, once they are known. */
    readonly otherDatasets = signal<ReadonlyMap<string, DatasetDescription>>(new Map());
    readonly rakes = signal<ReadonlyMap<string, RakeRecord>>(new Map());
    readonly surfaces = signal<ReadonlyMap<string, SurfaceRecord>>(new Map());
    readonly slices = signal<ReadonlyMap<string, SliceRecord>>(new Map());
    readonly lines = signal<ReadonlyMap<string, LinesRecord>>(new Map());
    readonly bookmarks = signal<ReadonlyMap<string, BookmarkRecord>>(new Map());
    readonly annotations = signal<ReadonlyMap<string, AnnotationRecord>>(new Map());
    /** Every user in the session, this page too. */
    readonly participants = signal<ReadonlyMap<string, Participant>>(new Map());
    readonly you = signal<string | null>(null);
    readonly session = signal<string | null>(null);
    readonly sessionName = signal('');
    /** The session that this one was copied from; null: none. */
    readonly copyOf = signal<{ session: string; name: string } | null>(null);
    /** The units that people of this session have typed; an empty one is as the dataset says. */
    readonly typedUnits = signal<Units>(noUnits);
    readonly gone = signal<GoneSession | null>(null);
    /** Empty where it is not told. */
    readonly heldSteps = signal<HeldSteps>({ steps: [], whole: 0 });
    /** The surface that the panel and the time bar act on: one of the active rake's, if that has any. */
    readonly activeSurface = signal<string | null>(null);
    readonly activeRake = signal<string | null>(null);
    /** The active rake as the user has it on the screen, ahead of the server's record while an edit is on its
     *  way. */
    readonly rakeShape = signal<ShownRake>({ kind: 'line', points: [] });
    readonly rakePoints = computed(() => this.rakeShape.value.points);
    /** Surfaces that this page does not show, and is sent nothing of. */
    readonly hiddenSurfaces = signal<ReadonlySet<string>>(new Set());
    readonly displayed = signal<ReadonlyMap<string, DisplayedSurface>>(new Map());
    /** Quads of which something is not drawn, at torn borders; by surface. */
    readonly trimmed = signal<ReadonlyMap<string, number>>(new Map());
    /** By surface, where they are asked for. */
    readonly parts = signal<ReadonlyMap<string, readonly SurfacePart[]>>(new Map());
    /** The newest epoch that an answer or a record of the server has named, by surface. */
    readonly requestedEpochs = signal<ReadonlyMap<string, number>>(new Map());
    /** What the server counted on the newest finished state of a surface. */
    readonly outcomes = signal<ReadonlyMap<string, SurfaceStats>>(new Map());
    /** What the values of a surface range over since it began to play, as every user is told. */
    readonly valueRanges = signal<ReadonlyMap<string, readonly ValueRange[]>>(new Map());
    readonly surfaceErrors = signal<ReadonlyMap<string, SurfaceFailure>>(new Map());
    /** Surfaces of which older states were left out, because this client is slower than the server. */
    readonly catchingUp = signal<ReadonlySet<string>>(new Set());
    /** Null where the server has none. */
    readonly clock = signal<ClockRecord | null>(null);
    readonly role = signal<Role>('host');
    /** Nothing of the session can be changed from here: it is for looking on, or the server does not hear. */
    readonly locked = computed(() => this.role.value === 'viewer' || this.stage.value !== 'running');
    readonly editsPending = signal(false);
    /** What was refused or has failed. */
    readonly problems = new Announcements();
    /** What is good to know, by its kind. */
    readonly notices = new Announcements();
    /** The progress of the selected surface, while it takes long. */
    readonly progress = signal<SurfaceStatus | null>(null);
    /** The time of a message to the server and back, in milliseconds. */
    readonly roundTripMs = signal<number | null>(null);
    /** What the server suggests to begin with in the dataset; null: not known yet. */
    readonly suggestion = signal<({ dataset: string } & ResultOf<'dataset.suggest'>) | null>(null);
    /** Belongs to the newest edit that is on the screen. */
    readonly latency = signal<LatencySample | null>(null);

    private readonly wantedText = computed(() => {
        const records = [this.surfaces, this.slices, this.lines].flatMap(({ value }) => [...value.values()]);
        return JSON.stringify([...new Set(records.map(({ dataset }) => dataset))].sort());
    });
    /** All of which the session has something: another set only when that changes, not with every edit. */
    readonly wantedDatasets = computed((): ReadonlySet<string> => new Set(JSON.parse(this.wantedText.value) as string[]));
    readonly surface = computed(() => this.surfaces.value.get(this.activeSurface.value ?? ''));
    readonly rake = computed(() => this.rakes.value.get(this.activeRake.value ?? ''));
    readonly phase = computed((): SurfacePhase => {
        if (this.stage.value === 'ended' || this.stage.value === 'gone') return this.stage.value;
        if (this.stage.value !== 'running') return 'waiting';
        const id = this.activeSurface.value ?? '';
        return surfacePhase({
            displayed: this.displayed.value.get(id),
            requestedEpoch: this.requestedEpochs.value.get(id) ?? 0,
            editsPending: this.editsPending.value,
            error: this.surfaceErrors.value.get(id),
            outcome: this.outcomes.value.get(id),
            hidden: this.hiddenSurfaces.value.has(id),
        });
    });
    /** Times of the time-steps that can be used now: all of them once the import has finished. */
    readonly times = computed(() => usableTimes(this.dataset.value, this.datasetEntry.value));
    readonly speedRange = computed(() => speedRangeOf(this.dataset.value));
    /** Of all data in the picture. */
    readonly pictured = computed((): readonly DatasetDescription[] =>
        this.dataset.value === null ? [] : [this.dataset.value, ...this.otherDatasets.value.values()],
    );

    /** Of the selected surface, which need not be the one that is worked on; null: it is not known. */
    readonly surfaceDataset = computed(() =>
        this.surface.value === undefined ? this.dataset.value : this.described(this.surface.value.dataset),
    );
    readonly surfaceTimes = computed(() => {
        const dataset = this.surfaceDataset.value;
        if (dataset === this.dataset.value) return this.times.value;
        return usableTimes(dataset, this.datasets.value.find((each) => each.dataset === dataset?.dataset) ?? null);
    });

    /** Null: it is not known. */
    described(dataset: string): DatasetDescription | null {
        return this.pictured.value.find((each) => each.dataset === dataset) ?? null;
    }
}

function usableTimes(dataset: DatasetDescription | null, entry: DatasetEntry | null): readonly number[] {
    const times = dataset?.times ?? [];
    return times.slice(0, Math.max(1, entry?.steps?.ready ?? times.length));
}

/** The range of the speed over the whole dataset: colours mean the same at all times. */
export function speedRangeOf(dataset: DatasetDescription | null): [number, number] {
    const field = dataset?.fields.find(({ name }) => name === dataset.velocity);
    const [low, high] = field?.range ?? [null, null];
    if (low === null || high === null) return [0, 1];
    return high > low ? [low, high] : [low, low + 1];
}

/** How far the server has come with a surface; null: not known. */
export interface SurfaceStatus {
    surface: string;
    /** The part of the way to the final one, 0 to 1. */
    fraction: number | null;
    message: string;
    /** Simulation time that a streak or time surface has come to. */
    time: number | null;
    quads: number | null;
    /** Seconds that it may still take. */
    remaining: number | null;
    /** How long people have been waiting. */
    lasting: 'briefly' | 'a while' | 'long';
}

/** Why a surface is not all that was asked for. */
export interface SurfaceFailure {
    epoch: number;
    text: string;
    /** A user did not want to wait for it. */
    stopped: boolean;
}

export type SurfacePhase =
    | 'waiting'
    | 'ended'
    | 'gone'
    | 'hidden'
    | 'none'
    | 'updating'
    | 'coarse'
    | 'live'
    | 'final'
    | 'coarsened'
    | 'empty'
    | 'stopped'
    | 'error';

export interface SurfaceProgress {
    displayed: DisplayedSurface | undefined;
    requestedEpoch: number;
    /** An edit has not been answered yet, so that `requestedEpoch` may be old. */
    editsPending: boolean;
    error: SurfaceFailure | undefined;
    outcome?: SurfaceStats | undefined;
    /** Its user has hidden it. */
    hidden?: boolean;
}

/** In which state the picture of a surface is, compared with what has been asked for. */
export function surfacePhase(progress: SurfaceProgress): SurfacePhase {
    const { displayed, requestedEpoch, editsPending, error, outcome, hidden } = progress;
    if (hidden === true) return 'hidden';
    if (error !== undefined && error.epoch >= requestedEpoch && !editsPending) {
        return error.stopped ? 'stopped' : 'error';
    }
    if (displayed === undefined) return 'none';
    if (displayed.epoch < requestedEpoch || editsPending) return 'updating';
    if (displayed.phase === 'live') return 'live';
    if (displayed.phase !== 'final') return 'coarse';
    // What is told of another state says nothing of this one.
    const counted = outcome?.stateSum === displayed.stateSum ? outcome : undefined;
    if (displayed.cells === 0 || counted?.empty !== undefined) return 'empty';
    return counted?.coarsened === true ? 'coarsened' : 'final';
}

/** A copy of a map with one entry set, for signals that compare by identity. */
export function withEntry<V>(map: ReadonlyMap<string, V>, key: string, value: V): Map<string, V> {
    return new Map(map).set(key, value);
}

export function withoutEntry<V>(map: ReadonlyMap<string, V>, key: string): Map<string, V> {
    const copy = new Map(map);
    copy.delete(key);
    return copy;
}

/** Names of units, which are written and never computed with. */
export interface Units {
    length: string;
    time: string;
}

/** Not known. */
export const noUnits: Units = { length: '', time: '' };
