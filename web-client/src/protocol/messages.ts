// The methods and notifications of the server that this client uses, one entry each: parameters ->
// result. Mirrors protocol/ on the C++ side; names and shapes are those of the method table there.
import { isObject } from './jsonRpc.ts';
import { type Phase, phases } from './meshFrame.ts';

export type Vec3 = [number, number, number];

export interface ServerInfo {
    name: string;
    version: string;
    apiLevel: number;
    capabilities: string[];
    limits: Record<string, number>;
}

export type DatasetState = 'ready' | 'importing' | 'failed';

export interface DatasetEntry {
    dataset: string;
    name: string;
    state: DatasetState;
    progress?: number;
    /** Seconds an import will still take. */
    remaining?: number;
    steps?: { ready: number; total: number };
    error?: ReportedError;
}

/** Why something failed, as records and notifications carry it. */
export interface ReportedError {
    message: string;
    hint?: string;
}

export interface FieldDescription {
    name: string;
    components: number;
    source: 'point' | 'cell';
    range: [number, number];
    unit?: string;
}

export interface DatasetDescription {
    dataset: string;
    name: string;
    reader: string;
    grid: string;
    bounds: [number, number, number, number, number, number];
    points: number;
    cells: number;
    times: number[];
    steady: boolean;
    fields: FieldDescription[];
    velocity: string;
    why: string;
    obstacle: boolean;
    bytesPerStep: number;
    finestSpacing: number;
    lattice: LatticeDescription;
}

export interface LatticeDescription {
    origin: Vec3;
    step: number;
    bits: number;
}

export interface RakeRecord {
    rake: string;
    rev: number;
    kind: string;
    points: Vec3[];
    seeds: number;
    name: string;
    clipped: boolean;
    /** Somebody holds it just now. */
    dragging: boolean;
}

export type SurfaceKind = 'stream' | 'path' | 'streak' | 'time';
export type Direction = 'forward' | 'backward' | 'both';
export type Accuracy = 'fast' | 'balanced' | 'exact';

export interface SurfaceRecord {
    surface: string;
    rev: number;
    epoch: number;
    rake: string;
    kind: SurfaceKind;
    dataset: string;
    from: number;
    to: number;
    direction: Direction;
    separation: number;
    accuracy: Accuracy;
    merge: number;
    angle: number;
    maxQuads: number;
    fields: string[];
    /** Streak: when the release stops; without it, at `to`. */
    releaseUntil?: number;
    /** Time: the patch is the rake swept along this vector, or lies between the rake and `rake2`. */
    sweep?: Vec3;
    rake2?: string;
}

export interface SurfaceStats {
    surface: string;
    epoch: number;
    complete: boolean;
    crc: number;
    quads: number;
    vertices: number;
    [name: string]: unknown;
}

export interface Participant {
    participant: string;
    name: string;
}

export interface SessionSnapshot {
    session: string;
    name: string;
    rakes: RakeRecord[];
    surfaces: SurfaceRecord[];
    clock?: ClockRecord;
}

/** The clock that all participants share. */
export interface ClockRecord {
    /** Simulation time when the record was made; null: never set, surfaces are shown at their end. */
    time: number | null;
    playing: boolean;
    /** Simulation time a second. */
    speed: number;
    loop: boolean;
    /** What is played; null before it first was. */
    from: number | null;
    to: number | null;
}

export type Role = 'viewer' | 'editor' | 'host';

export interface SurfaceEpoch {
    surface: string;
    epoch: number;
}

export interface SurfaceSetting {
    surface?: string;
    rake: string;
    kind: SurfaceKind;
    dataset: string;
    from: number;
    to: number;
    direction?: Direction;
    separation?: number;
    accuracy?: Accuracy;
    merge?: number;
    angle?: number;
    maxQuads?: number;
    releaseUntil?: number;
    sweep?: Vec3;
    rake2?: string;
    session?: string;
}

export interface Subscription {
    subscription: number;
    lattice: LatticeDescription;
    attributes: string[];
    epoch: number;
    /** The server goes on after the update that was asked for; otherwise a whole state comes first. */
    resumed?: boolean;
}

type Nothing = Record<string, never>;

export interface Methods {
    'server.ping': { params: Nothing; result: object };
    'server.info': { params: Nothing; result: ServerInfo };
    'dataset.list': { params: Nothing; result: { datasets: DatasetEntry[] } };
    'dataset.describe': { params: { dataset: string }; result: DatasetDescription };
    'session.create': { params: { name?: string }; result: { session: string } };
    'session.join': {
        params: { session: string; name?: string; resumeToken?: string };
        result: {
            snapshot: SessionSnapshot;
            seq: number;
            participants: Participant[];
            you: string;
            role?: Role;
            resumeToken: string;
        };
    };
    'rake.set': {
        params: {
            rake?: string;
            kind: string;
            points: Vec3[];
            seeds: number;
            name?: string;
            dragging?: boolean;
        };
        result: {
            rake: string;
            rev: number;
            clipped: boolean;
            points: Vec3[];
            surfaces: SurfaceEpoch[];
        };
    };
    'surface.set': { params: SurfaceSetting; result: SurfaceEpoch & { rev: number } };
    'surface.stats': { params: { surface: string; session?: string }; result: SurfaceStats };
    'surface.wait': {
        params: { surface: string; epoch?: number; timeoutMs: number; session?: string };
        result: SurfaceStats;
    };
    'surface.subscribe': {
        params: { surface: string; from?: { epoch: number; seq: number } };
        result: Subscription;
    };
    'surface.unsubscribe': { params: { subscription: number }; result: object };
    'time.set': { params: { time: number | null }; result: { clock: ClockRecord } };
    'time.play': { params: { speed?: number; loop?: boolean }; result: { clock: ClockRecord } };
    'time.pause': { params: Nothing; result: { clock: ClockRecord } };
}

export type MethodName = keyof Methods;
export type ParamsOf<M extends MethodName> = Methods[M]['params'];
export type ResultOf<M extends MethodName> = Methods[M]['result'];

export type Patch =
    | { op: 'put'; type: 'rake'; id: string; record: RakeRecord }
    | { op: 'put'; type: 'surface'; id: string; record: SurfaceRecord }
    | { op: 'put'; type: 'clock'; record: ClockRecord }
    | { op: 'delete'; type: 'rake' | 'surface'; id: string };

export type Notification =
    | { method: 'session.patched'; session: string; seq: number; patches: Patch[] }
    | { method: 'surface.progress'; surface: string; epoch: number; phase: Phase }
    | { method: 'surface.done'; surface: string; epoch: number; error: ReportedError | null }
    | { method: 'dataset.patched'; dataset: string; change: Partial<DatasetEntry> }
    /** `kind` is for programs, `text`, if there is one, for people. */
    | { method: 'server.notice'; kind: string; text: string | null; surface: string | null };

/** Checks a notification field by field; null for one this client does not know or cannot trust. */
export function readNotification(
    method: string,
    params: Record<string, unknown>,
): Notification | null {
    switch (method) {
        case 'session.patched':
            return readSessionPatched(params);
        case 'surface.progress': {
            const { surface, epoch, phase } = params;
            if (typeof surface !== 'string' || typeof epoch !== 'number') return null;
            const known = phases.find((each) => each === phase);
            return known === undefined ? null : { method, surface, epoch, phase: known };
        }
        case 'surface.done': {
            const { surface, epoch, error, stats } = params;
            if (typeof surface !== 'string' || typeof epoch !== 'number') return null;
            return { method, surface, epoch, error: readError(error) ?? readStopped(stats) };
        }
        case 'dataset.patched':
            return readDatasetPatched(params);
        case 'server.notice': {
            const { kind, text, surface } = params;
            const textOr = (value: unknown): string | null => (typeof value === 'string' ? value : null);
            return { method, kind: textOr(kind) ?? '', text: textOr(text), surface: textOr(surface) };
        }
        default:
            return null;
    }
}

function readSessionPatched(params: Record<string, unknown>): Notification | null {
    const { session, seq, patches } = params;
    if (typeof session !== 'string' || typeof seq !== 'number' || !Array.isArray(patches)) {
        return null;
    }
    const known = patches.map(readPatch).filter((patch) => patch !== null);
    return { method: 'session.patched', session, seq, patches: known };
}

function readPatch(value: unknown): Patch | null {
    if (!isObject(value)) return null;
    const { op, type, id, record } = value;
    if (type === 'clock') return op === 'put' && isClockRecord(record) ? { op, type, record } : null;
    if (typeof id !== 'string' || (type !== 'rake' && type !== 'surface')) return null;
    if (op === 'delete') return { op, type, id };
    if (op !== 'put') return null;
    if (type === 'rake' && isRakeRecord(record)) return { op, type, id, record };
    if (type === 'surface' && isSurfaceRecord(record)) return { op, type, id, record };
    return null;
}

function readDatasetPatched(params: Record<string, unknown>): Notification | null {
    const { dataset, state, progress, remaining, steps, error } = params;
    if (typeof dataset !== 'string') return null;
    const change: Partial<DatasetEntry> = {};
    if (state === 'ready' || state === 'importing' || state === 'failed') change.state = state;
    if (typeof progress === 'number') change.progress = progress;
    if (typeof remaining === 'number') change.remaining = remaining;
    if (isObject(steps)) {
        const { ready, total } = steps;
        if (typeof ready === 'number' && typeof total === 'number') change.steps = { ready, total };
    }
    const reported = readError(error);
    if (reported !== null) change.error = reported;
    return { method: 'dataset.patched', dataset, change };
}

export function isVec3(value: unknown): value is Vec3 {
    return Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);
}

function isRakeRecord(value: unknown): value is RakeRecord & Record<string, unknown> {
    return (
        isObject(value) &&
        typeof value['rake'] === 'string' &&
        typeof value['rev'] === 'number' &&
        typeof value['seeds'] === 'number' &&
        Array.isArray(value['points']) &&
        value['points'].every(isVec3)
    );
}

export function isClockRecord(value: unknown): value is ClockRecord & Record<string, unknown> {
    const isTime = (time: unknown): boolean => time === null || Number.isFinite(time);
    return (
        isObject(value) &&
        typeof value['playing'] === 'boolean' &&
        typeof value['speed'] === 'number' &&
        typeof value['loop'] === 'boolean' &&
        isTime(value['time']) &&
        isTime(value['from']) &&
        isTime(value['to'])
    );
}

function isSurfaceRecord(value: unknown): value is SurfaceRecord & Record<string, unknown> {
    return (
        isObject(value) &&
        typeof value['surface'] === 'string' &&
        typeof value['rake'] === 'string' &&
        typeof value['epoch'] === 'number' &&
        typeof value['from'] === 'number' &&
        typeof value['to'] === 'number' &&
        ['undefined', 'number'].includes(typeof value['releaseUntil']) &&
        ['undefined', 'string'].includes(typeof value['rake2']) &&
        (value['sweep'] === undefined || isVec3(value['sweep']))
    );
}

/** A surface that ends before a time-step which cannot be read is there, but not all that was asked for. */
function readStopped(stats: unknown): ReportedError | null {
    if (!isObject(stats) || typeof stats['stopped'] !== 'string') return null;
    return { message: `The surface ends early: ${stats['stopped']}` };
}

function readError(error: unknown): ReportedError | null {
    if (!isObject(error) || typeof error['message'] !== 'string') return null;
    const { message, hint } = error;
    return typeof hint === 'string' && hint !== '' ? { message, hint } : { message };
}

/** What went wrong and what to do, as one text. */
export function errorWords({ message, hint }: ReportedError): string {
    return hint === undefined || hint === '' ? message : `${message}: ${hint}`;
}
