// Calls that a control makes for its user, and edits: what the server refuses is said over the picture, in words. Of a call that ends with
// the connection the connection's own banner says so, and what it said goes with the next connection.
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { MethodName, ParamsOf, ResultOf } from '../../protocol/messages.ts';
import type { Announcements } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';

const edits = new Set<MethodName>(['annotation.set', 'annotation.delete', 'bookmark.set', 'bookmark.delete']);

/** What names an act of the user's, and counts it once the server has taken it. */
export interface Acts {
    begin: () => string;
    taken: (gesture: string) => void;
}

export class Calls {
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;
    private readonly acts: Acts;

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>, acts: Acts) {
        this.state = state;
        this.worker = worker;
        this.acts = acts;
    }

    /** Null when it failed; why is on the screen by then. */
    async try<M extends MethodName>(method: M, params: ParamsOf<M>): Promise<ResultOf<M> | null> {
        try {
            // Named before it is sent: what plays meanwhile goes with it, here as on the server.
            const gesture = edits.has(method) ? this.acts.begin() : null;
            const result = await this.worker.call(method, gesture === null ? params : { ...params, gesture });
            this.state.problems.solved(method);
            if (gesture !== null) this.acts.taken(gesture);
            return result;
        } catch (error) {
            announceUnlessDisconnected(this.state.problems, method, error);
            return null;
        }
    }
}

export function isDisconnected(error: unknown): boolean {
    return error instanceof CallError && error.failure.kind === 'disconnected';
}

/** @param about as Announcements has it */
export function announceUnlessDisconnected(problems: Announcements, about: string, error: unknown): void {
    if (!isDisconnected(error)) problems.tell(about, error);
}

const { leased } = errorCodes;

/** Returns what the server has said against an edit; null: it has not answered. */
export function refusalWords(error: unknown): string | null {
    return error instanceof CallError && error.failure.kind === 'rpc' ? error.failure.message : null;
}

/** @param about what was edited */
export function announceFailure({ problems }: AppState, about: string, error: unknown): void {
    announceUnlessDisconnected(problems, about, error);
    // What was refused is as it was before; the next edit is about something else.
    const words = problems.all.value.get(about);
    if (words !== undefined) problems.sayUntil('edit', about, words);
    // The hint is for scripts, which can take the rake away from others.
    if (error instanceof CallError && error.failure.code === leased) {
        problems.sayUntil('edit', about, `${error.failure.message}: wait until it is released`);
    }
}
