// What page and server say to each other, under the names that this client has for it: methods, records and notifications, with the checks
// of all that the server sends. What this client does not know is left out, and of what it cannot trust it says why. Shapes and checks are
// made from the description of the API (generated/, docs/api.md).
import { type Check, is } from './checks.ts';
import { type AnnotationRecord, annotationRecordCheck } from './generated/annotation.ts';
import { type BookmarkRecord, bookmarkRecordCheck } from './generated/bookmark.ts';
import { heldChangeCheck } from './generated/dataset.ts';
import type { Methods as DescribedMethods } from './generated/methods.ts';
import { notificationChecks, type Notifications, type SessionPatched } from './generated/notifications.ts';
import { participantChangeCheck } from './generated/presence.ts';
import { type RakeRecord, rakeRecordCheck } from './generated/rake.ts';
import { resultChecks } from './generated/results.ts';
import { type Joined, patchCheck, sessionNameCheck, type Snapshot } from './generated/session.ts';
import { type LinesRecord, linesRecordCheck } from './generated/lines.ts';
import { type SliceRecord, sliceRecordCheck } from './generated/slice.ts';
import { type SurfaceRecord, surfaceRecordCheck } from './generated/surface.ts';
import { type ClockRecord, clockRecordCheck } from './generated/time.ts';
import { isObject } from './jsonRpc.ts';

export type { AnnotationRecord, BookmarkRecord, ClockRecord, LinesRecord, RakeRecord, SliceRecord, SurfaceRecord };
export {
    type Dataset as DatasetDescription,
    type DatasetEntry,
    type DatasetState,
    datasetStates,
    type Field as FieldDescription,
    type HeldChange,
    type ProbeSampleResult as SampledPoints,
    type StepHeld,
    type StepState,
} from './generated/dataset.ts';
export type { SurfaceDone } from './generated/notifications.ts';
export type {
    Camera as CameraPlace,
    Participant,
    ParticipantChange,
    PresenceUpdateParams as Presence,
} from './generated/presence.ts';
export type { RakeKind, RakeSetParams as RakeSetting, SurfaceEpoch } from './generated/rake.ts';
export type { ServerInfoResult as ServerInfo } from './generated/server.ts';
export type {
    SessionEntry,
    SessionImportResult as SessionImported,
    SessionMade,
    Snapshot as SessionSnapshot,
} from './generated/session.ts';
export type { Share as ShareLink } from './generated/share.ts';
export type { Lattice as LatticeDescription, Role } from './generated/shared.ts';
export type {
    PassSeconds,
    StatedTwin,
    Statistics as SurfaceStats,
    SurfaceSubscribeResult as Subscription,
    Terminations,
    TwinDistance,
    ValueRange,
} from './generated/subscription.ts';
export type {
    Accuracy,
    Between,
    Direction,
    Interpolation,
    Refine,
    SurfaceKind,
    SurfaceSetParams,
    Twin,
} from './generated/surface.ts';
export { isVec3, type Vec3 } from './vec3.ts';

/** What this client speaks; the server names its own level in `server.info`. */
export const subprotocol = 'wakesurf.v1';
export const apiLevel = 5;

/** This page never sends `lastSeq`, so that a snapshot always comes. */
export type JoinedSession = Joined & { snapshot: Snapshot };

export interface Methods extends Omit<DescribedMethods, 'session.join'> {
    'session.join': { params: DescribedMethods['session.join']['params']; result: JoinedSession };
}

export type MethodName = keyof Methods;
export type ParamsOf<M extends MethodName> = Methods[M]['params'];
export type ResultOf<M extends MethodName> = Methods[M]['result'];

/** What history.undo and history.redo answer. */
export type HistoryDepth = Omit<ResultOf<'history.undo'>, 'undone'>;

/** What surface.set takes from this page: a surface that says when it begins. */
export type SurfaceSetting = Methods['surface.set']['params'] & { from: number };

/** Why something failed, as records and notifications carry it. */
export interface ReportedError {
    message: string;
    hint?: string;
    /** A word for programs. */
    kind?: string;
}

export function isRakeRecord(value: unknown): value is RakeRecord {
    return is(value, rakeRecordCheck);
}

export function isSurfaceRecord(value: unknown): value is SurfaceRecord {
    return is(value, surfaceRecordCheck);
}

export function isSliceRecord(value: unknown): value is SliceRecord {
    return is(value, sliceRecordCheck);
}

export function isLinesRecord(value: unknown): value is LinesRecord {
    return is(value, linesRecordCheck);
}

/** Checks of records, by the type that patches name. */
const recordChecks = {
    rake: rakeRecordCheck,
    surface: surfaceRecordCheck,
    slice: sliceRecordCheck,
    lines: linesRecordCheck,
    bookmark: bookmarkRecordCheck,
    annotation: annotationRecordCheck,
    clock: clockRecordCheck,
    session: sessionNameCheck,
} as const;

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

/** Returns what went wrong and what to do, as one text. */
export function errorWords({ message, hint }: ReportedError): string {
    return hint === undefined || hint === '' ? message : `${message}: ${hint}`;
}

type PatchType = keyof typeof recordChecks;
type RecordOf<Type extends PatchType> = (typeof recordChecks)[Type] extends Check<infer Checked> ? Checked : never;

/** What there is one of in every session. */
type Lasting = 'clock' | 'session';

/** A patch as described, with the record that its type says. */
export type Patch =
    | { [Type in PatchType]: { op: 'put'; type: Type; id: string; record: RecordOf<Type> } }[PatchType]
    | { op: 'delete'; type: Exclude<PatchType, Lasting>; id: string };

type TypedNotifications = Omit<Notifications, 'session.patched'> & {
    'session.patched': Omit<SessionPatched, 'patches'> & { patches: Patch[] };
};

export type Notification = {
    [Method in keyof TypedNotifications]: { method: Method } & TypedNotifications[Method];
}[keyof TypedNotifications];

export interface Reading {
    /** Null: this client does not know it, or cannot trust it. */
    notification: Notification | null;
    /** What is wrong with it, or with those of its parts that are left out. */
    faults: string[];
}

const newer = Symbol('of a newer server');

interface Sieve {
    list: string;
    /** Returns what is wrong with an entry; null: nothing. */
    faultOf: (entry: unknown) => string | null | typeof newer;
}

/** Lists of which an entry that cannot be trusted is left out alone. */
const sieves: { [Method in keyof Notifications]?: Sieve } = {
    'session.patched': { list: 'patches', faultOf: patchFault },
    'presence.patched': { list: 'participants', faultOf: participantFault },
    'cache.patched': { list: 'held', faultOf: heldChangeFault },
};

export function readNotification(method: string, params: Record<string, unknown>): Reading {
    if (!isKnown(method)) return { notification: null, faults: [] };
    const { checked, faults } = sifted(method, params);
    const fault = notificationChecks[method](checked);
    if (fault !== null) return { notification: null, faults: [...faults, faultIn(method, fault)] };
    return { notification: { ...checked, method } as Notification, faults };
}

function isKnown(method: string): method is keyof Notifications {
    return Object.hasOwn(notificationChecks, method);
}

function sifted(
    method: keyof Notifications,
    params: Record<string, unknown>,
): { checked: Record<string, unknown>; faults: string[] } {
    const sieve = sieves[method];
    const entries = sieve === undefined ? null : params[sieve.list];
    if (sieve === undefined || !Array.isArray(entries)) return { checked: params, faults: [] };
    const judged = entries.map((entry: unknown) => ({ entry, fault: sieve.faultOf(entry) }));
    const sound = judged.filter(({ fault }) => fault === null).map(({ entry }) => entry);
    const faults = judged.map(({ fault }) => fault).filter((fault) => typeof fault === 'string');
    return { checked: { ...params, [sieve.list]: sound }, faults };
}

/** The description of a patch leaves open which of its records belongs to which type. */
function patchFault(patch: unknown): string | null | typeof newer {
    if (!isObject(patch)) return 'a patch is not an object';
    const { op, type, id, record } = patch;
    if (typeof type !== 'string') return 'the type of a patch is not a text';
    if (!Object.hasOwn(recordChecks, type)) return newer;
    const what = `${type} ${String(id)}`;
    if (op === 'delete' && (type === 'clock' || type === 'session')) return `${what} cannot be deleted`;
    const fault = (op === 'put' ? recordChecks[type as PatchType](record) : null) ?? patchCheck(patch);
    return fault === null ? null : what + fault;
}

function participantFault(change: unknown): string | null {
    const fault = participantChangeCheck(change);
    if (fault === null) return null;
    const id = isObject(change) ? change['participant'] : null;
    return typeof id === 'string' ? `participant ${id}${fault}` : `a participant${fault}`;
}

function heldChangeFault(change: unknown): string | null {
    const fault = heldChangeCheck(change);
    return fault === null ? null : faultIn('a change of time-steps in memory', fault);
}

function joinedSession(value: unknown): string | null {
    const fault = resultChecks['session.join'](value);
    return fault === null && isObject(value) && value['snapshot'] === undefined ? '.snapshot is missing' : fault;
}

/** The check of what a method answers: as described, but for what an answer to this page always has. */
export function resultCheck(method: MethodName): Check<unknown> {
    return method === 'session.join' ? joinedSession : resultChecks[method];
}

/** Returns what is wrong in something with a name; a check of it has found that. */
function faultIn(what: string, fault: string): string {
    return fault.startsWith(' ') ? what + fault : `in ${what}, ${fault.replace(/^\./, '')}`;
}

export function unreadableWords(what: string): string {
    return `This page cannot read what the server sent: ${what}. Reload the page.`;
}

/** The answer to a call is not what the method answers. */
export class UnreadableAnswer extends Error {
    /** @param fault of a check, which begins with the path to what is wrong */
    constructor(method: string, fault: string) {
        super(unreadableWords(faultIn(`the answer to ${method}`, fault)));
        this.name = 'UnreadableAnswer';
    }
}
