// A session that the server has forgotten, made again from what the page or its link remembers.
import type { RakeRecord, SurfaceRecord } from '../../protocol/messages.ts';
import type { AppState, ShownRake } from '../../state/appState.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';
import { settingAnew } from '../edits/surfaceIntent.ts';
import type { UrlState } from './urlState.ts';

export interface Remembered {
    rakes: RakeRecord[];
    surfaces: SurfaceRecord[];
}

/** Names in the former session -> names in the new one, of what could be made; and why the rest could not. */
export interface MadeAnew {
    rakes: Map<string, string>;
    surfaces: Map<string, string>;
    /** Null: all is there. */
    missing: string | null;
}

/** What this page has had, or else what its link says; surfaces of this dataset only. */
export function rememberedOf(state: AppState, url: UrlState, dataset: string): Remembered {
    const [rakes, surfaces] = [[...state.rakes.value.values()], [...state.surfaces.value.values()]];
    const known = rakes.length > 0 || url.state === null ? { rakes, surfaces } : url.state;
    return { rakes: known.rakes, surfaces: known.surfaces.filter((each) => each.dataset === dataset) };
}

/**
 * Each record by itself: what the server refuses of a link is missed, and the rest is there.
 * @param seen  the shape on the screen, which may be ahead of the record that was lost
 */
export async function makeAnew(
    worker: Pick<WorkerClient, 'call'>,
    remembered: Remembered,
    seen: (record: RakeRecord) => ShownRake,
): Promise<MadeAnew> {
    const [rakes, surfaces] = [new Map<string, string>(), new Map<string, string>()];
    let why = '';
    for (const record of remembered.rakes) {
        const { rake, seeds, name, colour } = record;
        const { kind, points } = seen(record);
        const tint = colour === undefined || colour === '' ? {} : { colour };
        try {
            const made = await worker.call('rake.set', { kind, points: [...points], seeds, name, ...tint });
            rakes.set(rake, made.rake);
        } catch (error) {
            why ||= refusalOf(error);
        }
    }
    for (const record of remembered.surfaces) {
        const setting = settingAnew(record, rakes);
        if (setting === null) continue;
        try {
            const made = await worker.call('surface.set', setting);
            surfaces.set(record.surface, made.surface);
        } catch (error) {
            why ||= refusalOf(error);
        }
    }
    const missing = [
        ...counted(remembered.rakes.length - rakes.size, 'rake'),
        ...counted(remembered.surfaces.length - surfaces.size, 'surface'),
    ].join(' and ');
    return { rakes, surfaces, missing: missing === '' ? null : `Not made again: ${missing}${why === '' ? '' : `. ${why}`}` };
}

/** What the server has said; without a connection nothing more can be made at all. */
function refusalOf(error: unknown): string {
    if (!(error instanceof CallError) || error.failure.kind === 'disconnected') throw error;
    return error.message;
}

function counted(count: number, word: string): string[] {
    return count === 0 ? [] : [`${count} ${word}${count === 1 ? '' : 's'}`];
}
