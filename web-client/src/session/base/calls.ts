// Calls that a control makes for its user: what the server refuses is said over the picture, in words.
import type { MethodName, ParamsOf, ResultOf } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { tellUnlessCut } from './lostConnection.ts';

const edits = new Set<MethodName>(['annotation.set', 'annotation.delete', 'bookmark.set', 'bookmark.delete']);

/** Describes what names an act of the user's, and counts it once the server has taken it. */
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
            tellUnlessCut(this.state.problems, method, error);
            return null;
        }
    }
}
