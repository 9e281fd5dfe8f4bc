// Into a session: that of the address; else the one that this browser was in last, if it is still there; else
// the server's choice, `main` or the share link's, where every user meets. None is made by coming.
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { JoinedSession } from '../../protocol/messages.ts';
import { recall } from '../../state/browserMemory.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';
import { latestSession } from './knownSessions.ts';

const { notFound, notPermitted } = errorCodes;
export const nameKept = 'name';

export function isNotFound(error: unknown): boolean {
    return error instanceof CallError && error.failure.code === notFound;
}

export class Arrival {
    private readonly worker: Pick<WorkerClient, 'call'>;
    /** Is the session of the address, then the one that this page is in. */
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
        const name = recall(nameKept);
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
