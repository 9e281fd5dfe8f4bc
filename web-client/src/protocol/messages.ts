// The methods of the server that this client calls, one entry each: parameters -> result. Names and shapes are those of the
// method table in server/rpc; records.ts and notifications.ts hold the rest of what is said.
import type { PassSeconds } from './notifications.ts';
import type {
    BookmarkRecord,
    CameraPlace,
    ClockRecord,
    DatasetDescription,
    DatasetEntry,
    LatticeDescription,
    Participant,
    Role,
    SessionSnapshot,
    StepState,
    SurfaceRecord,
    Vec3,
} from './records.ts';
import type { SessionList, SessionMade } from './sessionEntries.ts';

export * from './notifications.ts';
export * from './records.ts';
export * from './sessionEntries.ts';

export interface ServerInfo {
    name: string;
    version: string;
    apiLevel: number;
    capabilities: string[];
    limits: Record<string, number>;
}

/** Why the particles of a surface went no further, by reason. */
export type Terminations = Record<'domain' | 'time' | 'obstacle' | 'stagnation' | 'budget', number>;

export interface SurfaceStats {
    surface: string;
    epoch: number;
    complete: boolean;
    crc: number;
    quads: number;
    vertices: number;
    steps: number;
    vertexSteps: number;
    approximated: number;
    terminated: Terminations;
    maxEdge: number;
    separation: number;
    seconds: Record<string, number>;
    /** What the pass that made the newest state took. */
    pass?: PassSeconds;
    peakBytes: number;
}

export interface SurfaceEpoch {
    surface: string;
    epoch: number;
}

/** Everything of a record but what the server gives; what is left out of a new one gets the server's usual value. */
export type SurfaceSetting = Pick<SurfaceRecord, 'rake' | 'kind' | 'dataset' | 'from' | 'to'> &
    Partial<Omit<SurfaceRecord, 'rev' | 'epoch'>> & { session?: string } & InGesture &
    AsDefault;

/** Edits that follow each other with one name are one step of undo. */
interface InGesture {
    gesture?: string;
}

/** For the first records of a session that no one has edited: no edit, and refused elsewhere. */
interface AsDefault {
    default?: boolean;
}

export interface RakeSetting extends InGesture, AsDefault {
    rake?: string;
    kind: string;
    points: Vec3[];
    seeds: number;
    name?: string;
    colour?: string;
    /** Takes or renews the lease; false ends it. */
    dragging?: boolean;
}

export interface Subscription {
    subscription: number;
    lattice: LatticeDescription;
    attributes: string[];
    epoch: number;
    /** The server goes on after the update that was asked for; otherwise a whole state comes first. */
    resumed?: boolean;
}

export interface JoinedSession {
    snapshot: SessionSnapshot;
    seq: number;
    participants: Participant[];
    you: string;
    role?: Role;
    resumeToken: string;
    /** When the session was made, UTC. */
    created?: string;
}

export interface ShareLink {
    grant: string;
    role: Role;
    /** Seconds since 1970; missing: it holds until it is taken back. */
    expires?: number;
    /** Where a host has lessened the role of someone who came by it: the role of those who come from then on. */
    newcomers?: Role;
    /** `grant` is the link its maker came by, if any; the name is empty for a script. */
    madeBy?: { grant?: string; name: string };
    /** Links in force that were made by it, or by those. */
    children?: number;
}

export interface SampledPoints {
    inside: boolean[];
    values: Record<string, (number | Vec3 | null)[]>;
}

export interface HistoryDepth {
    undo: number;
    redo: number;
    skipped: { type: string; id: string; why: string }[];
}

type Nothing = Record<string, never>;
type InSession<Params> = Params & { session?: string };

export interface Methods {
    'server.ping': { params: Nothing; result: object };
    'server.info': { params: Nothing; result: ServerInfo };
    'dataset.list': { params: Nothing; result: { datasets: DatasetEntry[] } };
    'dataset.open': { params: { dataset: string; timeoutMs?: number }; result: DatasetEntry };
    'dataset.describe': { params: { dataset: string }; result: DatasetDescription };
    'cache.status': {
        params: { dataset: string };
        result: { dataset: string; steps: StepState[]; bytes: number; budget: number };
    };
    'probe.sample': {
        params: { dataset: string; points: Vec3[]; time: number; fields?: string[] };
        result: SampledPoints;
    };
    'session.list': { params: { trash?: boolean }; result: SessionList };
    'session.create': { params: { name?: string }; result: SessionMade };
    'session.fork': { params: InSession<{ name?: string }>; result: SessionMade };
    'session.rename': { params: InSession<{ name: string }>; result: { session: string; name: string } };
    'session.delete': {
        params: { session: string; forever?: boolean };
        result: { session: string; deletedUntil?: string };
    };
    'session.restore': { params: { session: string }; result: { session: string; name: string } };
    'session.thumbnail': { params: InSession<{ image: string }>; result: object };
    'session.join': {
        params: { session?: string; name?: string; resumeToken?: string };
        result: JoinedSession;
    };
    'session.share': {
        params: InSession<{ role: Role; expiresIn?: number | null }>;
        result: ShareLink & { key: string; link: string };
    };
    'session.shares': { params: InSession<object>; result: { shares: ShareLink[] } };
    'session.unshare': {
        params: InSession<{ grant: string; children?: boolean }>;
        result: { children?: ShareLink[] };
    };
    'session.setRole': {
        params: InSession<{ participant: string; role: Role }>;
        result: { also?: string[]; newcomers?: Role };
    };
    'session.kick': { params: InSession<{ participant: string }>; result: object };
    'presence.update': {
        params: {
            pointer?: Vec3 | null;
            camera?: CameraPlace | null;
            dragging?: { rake: string; points: Vec3[] } | null;
            selected?: string | null;
        };
        result: object;
    };
    'rake.set': {
        params: RakeSetting;
        result: {
            rake: string;
            rev: number;
            clipped: boolean;
            points: Vec3[];
            surfaces: SurfaceEpoch[];
        };
    };
    'rake.delete': { params: InGesture & { rake: string }; result: object };
    'surface.set': { params: SurfaceSetting; result: SurfaceEpoch & { rev: number } };
    'surface.delete': { params: InGesture & { surface: string }; result: object };
    'surface.stop': { params: { surface: string }; result: object };
    'surface.stats': { params: InSession<{ surface: string }>; result: SurfaceStats };
    'surface.wait': {
        params: InSession<{ surface: string; epoch?: number; timeoutMs: number; workDoneToken?: string }>;
        result: SurfaceStats;
    };
    'surface.subscribe': {
        params: { surface: string; from?: { epoch: number; seq: number } };
        result: Subscription;
    };
    'surface.unsubscribe': { params: { subscription: number }; result: object };
    'time.set': { params: { time: number | null }; result: { clock: ClockRecord } };
    'time.play': {
        params: { speed?: number; loop?: boolean; from?: number; to?: number };
        result: { clock: ClockRecord };
    };
    'time.pause': { params: Nothing; result: { clock: ClockRecord } };
    'bookmark.set': {
        params: InGesture & Omit<BookmarkRecord, 'rev' | 'bookmark'> & { bookmark?: string };
        result: { bookmark: string };
    };
    'bookmark.delete': { params: InGesture & { bookmark: string }; result: object };
    'annotation.set': {
        params: InGesture & { annotation?: string; text: string; position: Vec3; surface?: string };
        result: { annotation: string };
    };
    'annotation.delete': { params: InGesture & { annotation: string }; result: object };
    'history.undo': { params: Nothing; result: HistoryDepth & { undone: unknown } };
    'history.redo': { params: Nothing; result: HistoryDepth & { redone: unknown } };
}

export type MethodName = keyof Methods;
export type ParamsOf<M extends MethodName> = Methods[M]['params'];
export type ResultOf<M extends MethodName> = Methods[M]['result'];
