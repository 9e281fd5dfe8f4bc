// What a page puts into a session in which no one has edited anything: what it had there before the server lost it, or what its link
// carries; else a first rake and surface, so that there is something to see.
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { SessionSnapshot } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';
import { defaultLength, defaultRake, defaultSeeds } from '../edits/defaults.ts';

export function isEmpty({ rakes, surfaces, bookmarks, annotations }: SessionSnapshot): boolean {
    return rakes.length + surfaces.length + bookmarks.length + annotations.length === 0;
}

/** Whether anyone has: who has taken everything away wants it so. */
export async function wasEdited(worker: Pick<WorkerClient, 'call'>, session: string): Promise<boolean> {
    const { sessions } = await worker.call('session.list', {});
    return sessions.find((each) => each.session === session)?.edited ?? true;
}

/** No edit of anyone's for the server, which takes it only where it is the first. False: it was not. */
export async function addDefaultScene(
    { worker, state }: { worker: Pick<WorkerClient, 'call'>; state: AppState },
    dataset: string,
    { rakes, surfaces }: SessionSnapshot,
): Promise<boolean> {
    const description = state.dataset.value;
    // A page that was closed in the middle of this has left a rake without a surface.
    if (description === null || surfaces.length > 0 || rakes.length > 1) return false;
    const kind = 'line' as const;
    const first = { kind, points: defaultRake(description.bounds), seeds: defaultSeeds, name: 'Rake 1', default: true };
    try {
        const { rake } = rakes[0] ?? (await worker.call('rake.set', first));
        const from = state.times.value[0] ?? 0;
        const to = from + defaultLength(description.bounds, state.speedRange.value[1]);
        await worker.call('surface.set', { rake, dataset, kind: 'stream', from, to, default: true });
        return true;
    } catch (error) {
        if (error instanceof CallError && error.failure.code === errorCodes.invalidParameters) return false;
        throw error;
    }
}
