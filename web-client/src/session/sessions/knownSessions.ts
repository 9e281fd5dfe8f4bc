// The sessions that this browser was in, newest first: the printed link leads back to the last of them.
// Another server may stand at the same address later and call its sessions alike, so the time at which one
// was made tells them apart.
import { isObject } from '../../protocol/jsonRpc.ts';
import { keep, recall } from '../../state/browserMemory.ts';

export interface KnownSession {
    session: string;
    /** Is the time that the server says; empty where it says none. */
    created: string;
    /** Is the dataset that was shown there. */
    dataset: string;
}

const mostKnown = 20;

/** Several servers may be behind one name, each under a path of its own. */
const kept = (): string => `sessions ${location.pathname.replace(/[^/]*$/, '')}`;

export function knownSessions(): KnownSession[] {
    try {
        const value: unknown = JSON.parse(recall(kept()) ?? '[]');
        return Array.isArray(value) ? value.filter(isKnown) : [];
    } catch {
        return [];
    }
}

export function rememberSession(known: KnownSession): void {
    const others = knownSessions().filter(({ session }) => session !== known.session);
    keep(kept(), JSON.stringify([known, ...others].slice(0, mostKnown)));
}

/** The one that was visited last. @param dataset only where this was shown; null: any */
export function latestSession(dataset: string | null): KnownSession | null {
    return knownSessions().find((each) => dataset === null || each.dataset === dataset) ?? null;
}

function isKnown(value: unknown): value is KnownSession & Record<string, unknown> {
    if (!isObject(value)) return false;
    return ['session', 'created', 'dataset'].every((name) => typeof value[name] === 'string');
}
