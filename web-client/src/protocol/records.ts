// The records of a session, of datasets and of people as the server tells them, and the checks that a record from the wire is
// one. Twins: protocol/messages_*.hpp; shapes: protocol/api/README.md, JSON-RPC.
import { isObject } from './jsonRpc.ts';

export type Vec3 = [number, number, number];

export const datasetStates = ['ready', 'importing', 'failed', 'stopped', 'incomplete'] as const;
export type DatasetState = (typeof datasetStates)[number];

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
    /** A word for programs. */
    kind?: string;
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
    /** What `fields` of a surface may name. */
    surfaceFields?: string[];
}

export interface LatticeDescription {
    origin: Vec3;
    step: number;
    bits: number;
}

const rakeKinds = ['line', 'polyline', 'circle', 'points'] as const;
export type RakeKind = (typeof rakeKinds)[number];

export interface RakeRecord {
    rake: string;
    rev: number;
    kind: RakeKind;
    points: Vec3[];
    seeds: number;
    name: string;
    clipped: boolean;
    /** #rrggbb */
    colour?: string;
    /** The name of whoever made it. */
    author?: string;
    /** Someone holds it just now. */
    dragging: boolean;
    /** The participant who does. */
    leasedBy?: string;
}

const surfaceKinds = ['stream', 'path', 'streak', 'time'] as const;
export type SurfaceKind = (typeof surfaceKinds)[number];
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

/** A view of the picture under a name; `view` is this client's own (state/pageView.ts). */
export interface BookmarkRecord {
    bookmark: string;
    rev: number;
    name: string;
    view: Record<string, unknown>;
    time?: number;
}

/** Words at a place in space. */
export interface AnnotationRecord {
    annotation: string;
    rev: number;
    text: string;
    position: Vec3;
    author: string;
    surface?: string;
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

export interface CameraPlace {
    position: Vec3;
    target: Vec3;
    up: Vec3;
    /** Vertical, in degrees; without it the view is orthographic or unknown. */
    fov?: number;
}

/** Where someone is, what they point at and hold. */
export interface Presence {
    pointer?: Vec3 | null;
    camera?: CameraPlace | null;
    dragging?: { rake: string; points: Vec3[] } | null;
    selected?: string | null;
}

export interface Participant extends Presence {
    participant: string;
    name: string;
    /** #rrggbb */
    colour: string;
    role: Role;
    connected: boolean;
}

/** What is in memory of a dataset, one state a time-step. */
export type StepState = 'resident' | 'loading' | 'cold';

export interface SessionSnapshot {
    session: string;
    name: string;
    rakes: RakeRecord[];
    surfaces: SurfaceRecord[];
    bookmarks?: BookmarkRecord[];
    annotations?: AnnotationRecord[];
    clock?: ClockRecord;
}

export function isVec3(value: unknown): value is Vec3 {
    return Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);
}

function isTexts(value: unknown): value is string[] {
    return Array.isArray(value) && value.every((each) => typeof each === 'string');
}

type Members = Record<string, unknown>;

export function isRakeRecord(value: unknown): value is RakeRecord & Members {
    return (
        isObject(value) &&
        typeof value['rake'] === 'string' &&
        typeof value['rev'] === 'number' &&
        rakeKinds.some((kind) => kind === value['kind']) &&
        typeof value['seeds'] === 'number' &&
        Array.isArray(value['points']) &&
        value['points'].every(isVec3)
    );
}

export function isClockRecord(value: unknown): value is ClockRecord & Members {
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

export function isSurfaceRecord(value: unknown): value is SurfaceRecord & Members {
    return (
        isObject(value) &&
        typeof value['surface'] === 'string' &&
        typeof value['rake'] === 'string' &&
        typeof value['dataset'] === 'string' &&
        surfaceKinds.some((kind) => kind === value['kind']) &&
        typeof value['epoch'] === 'number' &&
        typeof value['from'] === 'number' &&
        typeof value['to'] === 'number' &&
        typeof value['separation'] === 'number' &&
        isTexts(value['fields']) &&
        ['undefined', 'number'].includes(typeof value['releaseUntil']) &&
        ['undefined', 'string'].includes(typeof value['rake2']) &&
        (value['sweep'] === undefined || isVec3(value['sweep']))
    );
}

export function isBookmarkRecord(value: unknown): value is BookmarkRecord & Members {
    return (
        isObject(value) && typeof value['bookmark'] === 'string' && typeof value['name'] === 'string' && isObject(value['view'])
    );
}

export function isAnnotationRecord(value: unknown): value is AnnotationRecord & Members {
    return (
        isObject(value) &&
        typeof value['annotation'] === 'string' &&
        typeof value['text'] === 'string' &&
        isVec3(value['position'])
    );
}

/** Why something failed, as an object of that shape; null if it is none. */
export function readError(error: unknown): ReportedError | null {
    if (!isObject(error) || typeof error['message'] !== 'string') return null;
    const { message, hint, kind } = error;
    return {
        message,
        ...(typeof hint === 'string' && hint !== '' ? { hint } : {}),
        ...(typeof kind === 'string' ? { kind } : {}),
    };
}

/** What went wrong and what to do, as one text. */
export function errorWords({ message, hint }: ReportedError): string {
    return hint === undefined || hint === '' ? message : `${message}: ${hint}`;
}
