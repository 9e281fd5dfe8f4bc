// Calls that a control makes for its user: what the server refuses is said over the picture, in words.
import type { MethodName, ParamsOf, ResultOf } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { tellUnlessCut } from './lostConnection.ts';

const edits = new Set<MethodName>(['annotation.set', 'annotation.delete', 'bookmark.set', 'bookmark.delete']);

export class Calls {
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;
    /** Called when the server has taken one that undo can take back. */
    private readonly edited: () => void;

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>, edited: () => void) {
        this.state = state;
        this.worker = worker;
        this.edited = edited;
    }

    /** Null when it failed; why is on the screen by then. */
    async try<M extends MethodName>(method: M, params: ParamsOf<M>): Promise<ResultOf<M> | null> {
        try {
            const result = await this.worker.call(method, params);
            this.state.problems.solved(method);
            if (edits.has(method)) this.edited();
            return result;
        } catch (error) {
            tellUnlessCut(this.state.problems, method, error);
            return null;
        }
    }
}
