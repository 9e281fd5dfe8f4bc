// Notifications of the server, checked as they come: what this client does not know is left out, and of what it cannot trust it says
// why. Shapes: docs/api.md.
import { is } from './checks.ts';
import { type DatasetEntry, datasetStateCheck, stepStateCheck } from './generated/dataset.ts';
import { cameraCheck, draggedRakeCheck } from './generated/presence.ts';
import type { RecordType } from './generated/session.ts';
import { recordTypes } from './generated/session.ts';
import { problemCheck, roleCheck } from './generated/shared.ts';
import { type PassSeconds, passSecondsCheck } from './generated/subscription.ts';
import { isObject } from './jsonRpc.ts';
import { type Phase, phases } from './meshFrame.ts';
import {
    type AnnotationRecord,
    type BookmarkRecord,
    type ClockRecord,
    isVec3,
    type Participant,
    type RakeRecord,
    readError,
    recordChecks,
    type ReportedError,
    type StepState,
    type SurfaceRecord,
} from './records.ts';

export type { RecordType };

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

export type Notification =
    /** `faults`: what is wrong with patches that are left out. */
    | { method: 'session.patched'; session: string; seq: number; patches: Patch[]; faults: string[] }
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
    const known: Patch[] = [];
    const faults: string[] = [];
    for (const each of patches) {
        const patch = readPatch(each);
        if (typeof patch === 'string') faults.push(patch);
        else if (patch !== null) known.push(patch);
    }
    return { method: 'session.patched', session, seq, patches: known, faults };
}

/** What is wrong with it, where it is of a type that is known; null: of another, which newer servers may have. */
function readPatch(value: unknown): Patch | string | null {
    if (!isObject(value)) return 'a patch is not an object';
    const { op, type, id, record } = value;
    if (type === 'session') {
        const name = isObject(record) ? record['name'] : null;
        return op === 'put' && typeof name === 'string' ? { op, type, record: { name } } : 'session.name is not a text';
    }
    if (type === 'clock') {
        if (op !== 'put') return 'clock is not put';
        return is(record, recordChecks.clock) ? { op, type, record } : `clock${recordChecks.clock(record) ?? ''}`;
    }
    const kind = recordTypes.find((each) => each === type);
    if (kind === undefined) return null;
    if (typeof id !== 'string') return `${kind} has no id`;
    if (op === 'delete') return { op, type: kind, id };
    if (op !== 'put') return `${kind} ${id} is neither put nor deleted`;
    const fault = recordChecks[kind](record);
    return fault === null ? ({ op, type: kind, id, record } as Patch) : `${kind} ${id}${fault}`;
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
    if (is(role, roleCheck)) change.role = role;
    if (typeof connected === 'boolean') change.connected = connected;
    if (pointer === null || isVec3(pointer)) change.pointer = pointer;
    if (camera === null || is(camera, cameraCheck)) change.camera = camera;
    if (dragging === null || is(dragging, draggedRakeCheck)) change.dragging = dragging;
    if (selected === null || typeof selected === 'string') change.selected = selected;
    return change;
}

function readCachePatched({ dataset, changes }: Record<string, unknown>): Notification | null {
    if (typeof dataset !== 'string' || !Array.isArray(changes)) return null;
    const known = changes.flatMap((change: unknown) => {
        if (!Array.isArray(change) || typeof change[0] !== 'number') return [];
        const state: unknown = change[1];
        return is(state, stepStateCheck) ? [{ step: change[0], state }] : [];
    });
    return { method: 'cache.patched', dataset, changes: known };
}

function readSeconds(value: unknown): PassSeconds | null {
    return is(value, passSecondsCheck) ? value : null;
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

function readDatasetPatched(params: Record<string, unknown>): Notification | null {
    const { dataset, state, progress, remaining, steps, error } = params;
    if (typeof dataset !== 'string') return null;
    const change: Partial<DatasetEntry> = {};
    if (is(state, datasetStateCheck)) change.state = state;
    if (typeof progress === 'number') change.progress = progress;
    if (typeof remaining === 'number') change.remaining = remaining;
    if (isObject(steps)) {
        const { ready, total } = steps;
        if (typeof ready === 'number' && typeof total === 'number') change.steps = { ready, total };
    }
    if (is(error, problemCheck)) change.error = error;
    return { method: 'dataset.patched', dataset, change };
}

/** A surface that ends before a time-step which cannot be read is there, but not all that was asked for. */
function readStopped(stats: unknown): ReportedError | null {
    if (!isObject(stats) || typeof stats['stopped'] !== 'string') return null;
    return { message: `The surface ends early: ${stats['stopped']}` };
}
