// A session that the server has forgotten, made again from what the page or its link remembers.
import type { RakeRecord, SurfaceRecord } from '../protocol/messages.ts';
import type { AppState, ShownRake } from '../state/appState.ts';
import type { WorkerClient } from '../worker/workerClient.ts';
import { settingAnew } from './surfaceIntent.ts';
import type { UrlState } from './urlState.ts';

export interface Remembered {
    rakes: RakeRecord[];
    surfaces: SurfaceRecord[];
}

/** What this page has had, or else what its link says; surfaces of this dataset only. */
export function rememberedOf(state: AppState, url: UrlState, dataset: string): Remembered {
    const [rakes, surfaces] = [[...state.rakes.value.values()], [...state.surfaces.value.values()]];
    const known = rakes.length > 0 || url.state === null ? { rakes, surfaces } : url.state;
    return { rakes: known.rakes, surfaces: known.surfaces.filter((each) => each.dataset === dataset) };
}

/** @param seen  the shape on the screen, which may be ahead of the record that was lost */
export async function makeAnew(
    worker: Pick<WorkerClient, 'call'>,
    { rakes, surfaces }: Remembered,
    seen: (record: RakeRecord) => ShownRake,
): Promise<void> {
    const ids = new Map<string, string>();
    for (const record of rakes) {
        const { rake, seeds, name, colour } = record;
        const { kind, points } = seen(record);
        const tint = colour === undefined || colour === '' ? {} : { colour };
        const made = await worker.call('rake.set', { kind, points: [...points], seeds, name, ...tint });
        ids.set(rake, made.rake);
    }
    for (const record of surfaces) {
        const setting = settingAnew(record, ids);
        if (setting !== null) await worker.call('surface.set', setting);
    }
}
