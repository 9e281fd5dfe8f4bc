// Into a session: that of the address; else the one that this browser was in last, if it is still there; else the server's choice, `main`
// or the share link's, where every user meets. None is made by coming. The sessions that this browser was in are remembered, newest first;
// another server may stand at the same address later and call its sessions alike, so the time at which one was made tells them apart.
import { errorCodes } from '../../protocol/generated/errors.ts';
import { isObject } from '../../protocol/jsonRpc.ts';
import type { JoinedSession } from '../../protocol/messages.ts';
import { keep, recall } from '../../state/browserMemory.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';

const { notFound, notPermitted } = errorCodes;
export const personNameKey = 'name';

export function isNotFound(error: unknown): boolean {
    return error instanceof CallError && error.failure.code === notFound;
}

export class SessionJoin {
    private readonly worker: Pick<WorkerClient, 'call'>;
    /** The session of the address, then the one that this page is in. */
    session: string | null;
    resumeToken: string | undefined;

    constructor(worker: Pick<WorkerClient, 'call'>, session: string | null) {
        this.worker = worker;
        this.session = session;
    }

    /** Null: the session that this page is to be in is not there. @param dataset what its address asks to
     *  see; null: nothing */
    async join(dataset: string | null): Promise<JoinedSession | null> {
        if (this.session === null) return (await this.joinLatest(dataset)) ?? this.enter(null);
        try {
            return await this.enter(this.session);
        } catch (error) {
            if (!isNotFound(error)) throw error;
            this.resumeToken = undefined;
            return null;
        }
    }

    /** @param session null: the server chooses */
    async enter(session: string | null): Promise<JoinedSession> {
        const [named, resume] = [session === null ? {} : { session }, this.resume(session)];
        const name = recall(personNameKey);
        const joined = await this.worker.call('session.join', { ...named, ...resume, ...(name === null ? {} : { name }) });
        this.session = joined.snapshot.session;
        this.resumeToken = joined.resumeToken;
        return joined;
    }

    private resume(session: string | null): { resumeToken?: string } {
        return this.resumeToken === undefined || session !== this.session ? {} : { resumeToken: this.resumeToken };
    }

    private async joinLatest(dataset: string | null): Promise<JoinedSession | null> {
        const latest = latestSession(dataset);
        if (latest === null) return null;
        try {
            const joined = await this.enter(latest.session);
            if ((joined.created ?? '') === latest.created) return joined;
        } catch (error) {
            const code = error instanceof CallError ? error.failure.code : 0;
            if (code !== notFound && code !== notPermitted) throw error;
        }
        [this.session, this.resumeToken] = [null, undefined];
        return null;
    }
}

export interface KnownSession {
    session: string;
    /** The time that the server says; empty where it says none. */
    created: string;
    /** The dataset that was shown there. */
    dataset: string;
}

const maxKnownSessions = 20;

/** Several servers may be behind one name, each under a path of its own. */
const storageKey = (): string => `sessions ${location.pathname.replace(/[^/]*$/, '')}`;

function knownSessions(): KnownSession[] {
    try {
        const value: unknown = JSON.parse(recall(storageKey()) ?? '[]');
        return Array.isArray(value) ? value.filter(isKnown) : [];
    } catch {
        return [];
    }
}

export function rememberSession(known: KnownSession): void {
    const others = knownSessions().filter(({ session }) => session !== known.session);
    keep(storageKey(), JSON.stringify([known, ...others].slice(0, maxKnownSessions)));
}

/** The one that was visited last. @param dataset only where this was shown; null: any */
export function latestSession(dataset: string | null): KnownSession | null {
    return knownSessions().find((each) => dataset === null || each.dataset === dataset) ?? null;
}

function isKnown(value: unknown): value is KnownSession & Record<string, unknown> {
    if (!isObject(value)) return false;
    return ['session', 'created', 'dataset'].every((name) => typeof value[name] === 'string');
}
