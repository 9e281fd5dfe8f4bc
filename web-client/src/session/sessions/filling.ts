// Puts what a page has into a session in which no user has edited anything: what it had there before the
// server lost it, or what its link carries; else the rake and surface that the server suggests, so that there
// is something to see.
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { SessionSnapshot } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { Suggestions } from './suggestions.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';

export function isEmpty({ rakes, surfaces, bookmarks, annotations }: SessionSnapshot): boolean {
    return rakes.length + surfaces.length + bookmarks.length + annotations.length === 0;
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
