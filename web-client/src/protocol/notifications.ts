// Notifications of the server, checked field by field as they come: what this client does not know or cannot trust is left
// out. Shapes: protocol/api/README.md, JSON-RPC.
import { isObject } from './jsonRpc.ts';
import { type Phase, phases } from './meshFrame.ts';
import {
    type AnnotationRecord,
    type BookmarkRecord,
    type CameraPlace,
    type ClockRecord,
    type DatasetEntry,
    type DatasetState,
    datasetStates,
    isAnnotationRecord,
    isBookmarkRecord,
    isClockRecord,
    isRakeRecord,
    isSurfaceRecord,
    isVec3,
    type Participant,
    type RakeRecord,
    readError,
    type ReportedError,
    type StepState,
    type SurfaceRecord,
    type Vec3,
} from './records.ts';

export type RecordType = 'rake' | 'surface' | 'bookmark' | 'annotation';

export type Patch =
    | { op: 'put'; type: 'rake'; id: string; record: RakeRecord }
    | { op: 'put'; type: 'surface'; id: string; record: SurfaceRecord }
    | { op: 'put'; type: 'bookmark'; id: string; record: BookmarkRecord }
    | { op: 'put'; type: 'annotation'; id: string; record: AnnotationRecord }
    | { op: 'put'; type: 'clock'; record: ClockRecord }
    | { op: 'put'; type: 'session'; record: { name: string } }
    | { op: 'delete'; type: RecordType; id: string };

/** What changed of a participant; what is null has been taken away. */
export type ParticipantChange = Partial<Participant> & { participant: string };

/** Seconds that the pass behind a state took on the server. */
export interface PassSeconds {
    queue: number;
    load: number;
    compute: number;
    encode: number;
}

export type Notification =
    | { method: 'session.patched'; session: string; seq: number; patches: Patch[] }
    | { method: 'presence.patched'; participants: ParticipantChange[]; left: string[] }
    | { method: 'cache.patched'; dataset: string; changes: { step: number; state: StepState }[] }
    | { method: 'surface.progress'; surface: string; epoch: number; phase: Phase; seconds: PassSeconds | null }
    | { method: 'surface.done'; surface: string; epoch: number; error: ReportedError | null }
    | { method: 'dataset.patched'; dataset: string; change: Partial<DatasetEntry> }
    | { method: '$/progress'; token: string | number; fraction: number | null; message: string; ended: boolean }
    /** `kind` is for programs, `text`, if there is one, for people. */
    | { method: 'server.notice'; kind: string; text: string | null; surface: string | null };

/** Null for a notification this client does not know or cannot trust. */
export function readNotification(method: string, params: Record<string, unknown>): Notification | null {
    const { surface, epoch } = params;
    switch (method) {
        case 'session.patched':
            return readSessionPatched(params);
        case 'presence.patched':
            return readPresencePatched(params);
        case 'cache.patched':
            return readCachePatched(params);
        case 'surface.progress': {
            const phase = phases.find((each) => each === params['phase']);
            if (typeof surface !== 'string' || typeof epoch !== 'number' || phase === undefined) return null;
            return { method, surface, epoch, phase, seconds: readSeconds(params['seconds']) };
        }
        case 'surface.done': {
            if (typeof surface !== 'string' || typeof epoch !== 'number') return null;
            return { method, surface, epoch, error: readError(params['error']) ?? readStopped(params['stats']) };
        }
        case 'dataset.patched':
            return readDatasetPatched(params);
        case '$/progress':
            return readProgress(params);
        case 'server.notice': {
            const { kind, text } = params;
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

const recordTypes: readonly RecordType[] = ['rake', 'surface', 'bookmark', 'annotation'];

function readPatch(value: unknown): Patch | null {
    if (!isObject(value)) return null;
    const { op, id, record } = value;
    if (value['type'] === 'clock') {
        return op === 'put' && isClockRecord(record) ? { op, type: 'clock', record } : null;
    }
    if (value['type'] === 'session') {
        const name = isObject(record) ? record['name'] : null;
        return op === 'put' && typeof name === 'string' ? { op, type: 'session', record: { name } } : null;
    }
    const type = recordTypes.find((known) => known === value['type']);
    if (typeof id !== 'string' || type === undefined) return null;
    if (op === 'delete') return { op, type, id };
    if (op !== 'put') return null;
    if (type === 'rake' && isRakeRecord(record)) return { op, type, id, record };
    if (type === 'surface' && isSurfaceRecord(record)) return { op, type, id, record };
    if (type === 'bookmark' && isBookmarkRecord(record)) return { op, type, id, record };
    if (type === 'annotation' && isAnnotationRecord(record)) return { op, type, id, record };
    return null;
}

function readPresencePatched({ participants, left }: Record<string, unknown>): Notification | null {
    if (!Array.isArray(participants) || !Array.isArray(left)) return null;
    return {
        method: 'presence.patched',
        participants: participants.map(readParticipant).filter((each) => each !== null),
        left: left.filter((each) => typeof each === 'string'),
    };
}

/** Members that are not as they should be are left out. */
export function readParticipant(value: unknown): ParticipantChange | null {
    if (!isObject(value) || typeof value['participant'] !== 'string') return null;
    const change: ParticipantChange = { participant: value['participant'] };
    const { name, colour, role, connected, pointer, camera, dragging, selected } = value;
    if (typeof name === 'string') change.name = name;
    if (typeof colour === 'string' && /^#[0-9a-f]{6}$/i.test(colour)) change.colour = colour;
    if (role === 'viewer' || role === 'editor' || role === 'host') change.role = role;
    if (typeof connected === 'boolean') change.connected = connected;
    if (pointer === null || isVec3(pointer)) change.pointer = pointer;
    if (camera === null || isCamera(camera)) change.camera = camera;
    if (dragging === null || isDragged(dragging)) change.dragging = dragging;
    if (selected === null || typeof selected === 'string') change.selected = selected;
    return change;
}

function isCamera(value: unknown): value is CameraPlace & Record<string, unknown> {
    return isObject(value) && isVec3(value['position']) && isVec3(value['target']) && isVec3(value['up']);
}

function isDragged(value: unknown): value is { rake: string; points: Vec3[] } & Record<string, unknown> {
    return (
        isObject(value) && typeof value['rake'] === 'string' && Array.isArray(value['points']) && value['points'].every(isVec3)
    );
}

const stepStates: readonly StepState[] = ['resident', 'loading', 'cold'];

function readCachePatched({ dataset, changes }: Record<string, unknown>): Notification | null {
    if (typeof dataset !== 'string' || !Array.isArray(changes)) return null;
    const known = changes.flatMap((change: unknown) => {
        if (!Array.isArray(change) || typeof change[0] !== 'number') return [];
        const state = stepStates.find((each) => each === change[1]);
        return state === undefined ? [] : [{ step: change[0], state }];
    });
    return { method: 'cache.patched', dataset, changes: known };
}

function readSeconds(value: unknown): PassSeconds | null {
    if (!isObject(value)) return null;
    const of = (name: string): number => (typeof value[name] === 'number' ? value[name] : 0);
    return { queue: of('queue'), load: of('load'), compute: of('compute'), encode: of('encode') };
}

function readProgress({ token, value }: Record<string, unknown>): Notification | null {
    if ((typeof token !== 'string' && typeof token !== 'number') || !isObject(value)) return null;
    const { kind, message, percentage } = value;
    return {
        method: '$/progress',
        token,
        fraction: typeof percentage === 'number' ? percentage / 100 : null,
        message: typeof message === 'string' ? message : '',
        ended: kind === 'end',
    };
}

function isDatasetState(state: unknown): state is DatasetState {
    return datasetStates.some((each) => each === state);
}

function readDatasetPatched(params: Record<string, unknown>): Notification | null {
    const { dataset, state, progress, remaining, steps, error } = params;
    if (typeof dataset !== 'string') return null;
    const change: Partial<DatasetEntry> = {};
    if (isDatasetState(state)) change.state = state;
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

/** A surface that ends before a time-step which cannot be read is there, but not all that was asked for. */
function readStopped(stats: unknown): ReportedError | null {
    if (!isObject(stats) || typeof stats['stopped'] !== 'string') return null;
    return { message: `The surface ends early: ${stats['stopped']}` };
}
