// What a session begins with in which no user has edited anything: what the page had there before the server lost it, or what its link
// carries; else the rake and surface that the server suggests for the dataset, so that there is something to see. Suggestions are asked for
// once the dataset is known, and again when the series has become much longer, as after an import.
import { effect, untracked } from '@preact/signals-core';
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { SessionSnapshot } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';
import { announceUnlessDisconnected } from '../base/calls.ts';

export function isEmpty({ rakes, surfaces, slices, lines, bookmarks, annotations }: SessionSnapshot): boolean {
    return rakes.length + surfaces.length + slices.length + lines.length + bookmarks.length + annotations.length === 0;
}

/** Returns whether any user has: who has taken everything away wants it so. */
export async function wasEdited(worker: Pick<WorkerClient, 'call'>, session: string): Promise<boolean> {
    const { sessions } = await worker.call('session.list', {});
    return sessions.find((each) => each.session === session)?.edited ?? true;
}

/** No edit of any user's for the server, which takes it only where it is the first. False: it was not. */
export async function addDefaultScene(
    {
        worker,
        state,
        suggestions,
    }: { worker: Pick<WorkerClient, 'call'>; state: AppState; suggestions: Pick<Suggestions, 'here'> },
    dataset: string,
    { rakes, surfaces }: SessionSnapshot,
): Promise<boolean> {
    // A page that was closed in the middle of this has left a rake without a surface.
    if (surfaces.length > 0 || rakes.length > 1) return false;
    await suggestions.here();
    const suggested = state.suggestion.value;
    const surface = suggested?.surfaces[0];
    if (suggested === null || surface === undefined) return false;
    try {
        const first = { ...suggested.rake, name: 'Rake 1', default: true };
        const { rake } = rakes[0] ?? (await worker.call('rake.set', first));
        await worker.call('surface.set', { rake, dataset, ...surface, default: true });
        return true;
    } catch (error) {
        if (error instanceof CallError && error.failure.code === errorCodes.invalidParameters) return false;
        throw error;
    }
}

const muchLonger = 2;

export class Suggestions {
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;
    private requested = { dataset: '', steps: 0 };
    private answer: Promise<void> = Promise.resolve();

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>) {
        this.state = state;
        this.worker = worker;
        effect(() => {
            const [dataset, steps] = [state.dataset.value?.dataset, state.times.value.length];
            const running = state.stage.value === 'running';
            if (dataset !== undefined && running) untracked(() => void this.refresh(dataset, steps));
        });
    }

    /** Once it has been answered, or refused. */
    async here(): Promise<void> {
        const { dataset, times } = this.state;
        if (dataset.value !== null) await this.refresh(dataset.value.dataset, times.value.length);
    }

    private refresh(dataset: string, steps: number): Promise<void> {
        if (dataset !== this.requested.dataset || steps >= muchLonger * this.requested.steps) {
            this.requested = { dataset, steps };
            this.answer = this.ask(dataset);
        }
        return this.answer;
    }

    private async ask(dataset: string): Promise<void> {
        const { state } = this;
        if (state.suggestion.value?.dataset !== dataset) state.suggestion.value = null;
        try {
            const suggestion = await this.worker.call('dataset.suggest', { dataset });
            if (this.requested.dataset === dataset) state.suggestion.value = { dataset, ...suggestion };
            state.problems.solved('suggestion');
        } catch (error) {
            this.requested = { dataset: '', steps: 0 };
            announceUnlessDisconnected(state.problems, 'suggestion', error);
        }
    }
}
