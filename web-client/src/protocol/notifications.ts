// Notifications of the server, checked as they come: what this client does not know is left out, and of what
// it cannot trust it says why. Shapes: docs/api.md.
import type { Check } from './checks.ts';
import { heldChangeCheck } from './generated/dataset.ts';
import { notificationChecks, type Notifications, type SessionPatched } from './generated/notifications.ts';
import { participantChangeCheck } from './generated/presence.ts';
import { patchCheck } from './generated/session.ts';
import { isObject } from './jsonRpc.ts';
import { recordChecks } from './records.ts';
import { faultIn } from './unreadable.ts';

export type { HeldChange } from './generated/dataset.ts';
export type { SurfaceDone } from './generated/notifications.ts';
export type { ParticipantChange } from './generated/presence.ts';

type PatchType = keyof typeof recordChecks;
type RecordOf<Type extends PatchType> = (typeof recordChecks)[Type] extends Check<infer Kept> ? Kept : never;

/** Describes what there is one of in every session. */
type Lasting = 'clock' | 'session';

/** Is a patch as described, with the record that its type says. */
export type Patch =
    | { [Type in PatchType]: { op: 'put'; type: Type; id: string; record: RecordOf<Type> } }[PatchType]
    | { op: 'delete'; type: Exclude<PatchType, Lasting>; id: string };

type Told = Omit<Notifications, 'session.patched'> & {
    'session.patched': Omit<SessionPatched, 'patches'> & { patches: Patch[] };
};

export type Notification = { [Method in keyof Told]: { method: Method } & Told[Method] }[keyof Told];

export interface Reading {
    /** Null: this client does not know it, or cannot trust it. */
    notification: Notification | null;
    /** Holds what is wrong with it, or with those of its parts that are left out. */
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
    const { kept, faults } = sifted(method, params);
    const fault = notificationChecks[method](kept);
    if (fault !== null) return { notification: null, faults: [...faults, faultIn(method, fault)] };
    return { notification: { ...kept, method } as Notification, faults };
}

function isKnown(method: string): method is keyof Notifications {
    return Object.hasOwn(notificationChecks, method);
}

function sifted(
    method: keyof Notifications,
    params: Record<string, unknown>,
): { kept: Record<string, unknown>; faults: string[] } {
    const sieve = sieves[method];
    const entries = sieve === undefined ? null : params[sieve.list];
    if (sieve === undefined || !Array.isArray(entries)) return { kept: params, faults: [] };
    const judged = entries.map((entry: unknown) => ({ entry, fault: sieve.faultOf(entry) }));
    const sound = judged.filter(({ fault }) => fault === null).map(({ entry }) => entry);
    const faults = judged.map(({ fault }) => fault).filter((fault) => typeof fault === 'string');
    return { kept: { ...params, [sieve.list]: sound }, faults };
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
