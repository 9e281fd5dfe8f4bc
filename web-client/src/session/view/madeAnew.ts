// What the server has forgotten, made again from what the page or its link remembers.
import type { RakeRecord, SessionSnapshot, SurfaceRecord } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
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

/** What this page has had, or else what its link says. Rakes have the shape on the screen, which may be ahead of the record. */
export function rememberedOf(state: AppState, url: UrlState): Remembered {
    const [records, surfaces] = [[...state.rakes.value.values()], [...state.surfaces.value.values()]];
    if (records.length === 0 && url.state !== null) return { rakes: url.state.rakes, surfaces: url.state.surfaces };
    const [active, shape] = [state.rake.value?.rake, state.rakeShape.value];
    const rakes = records.map((record) => {
        if (record.rake !== active || shape.points.length === 0) return record;
        return { ...record, kind: shape.kind, points: [...shape.points] };
    });
    return { rakes, surfaces };
}

/** Each record by itself: what the server refuses of a link is missed, and the rest is there. @param there  since an earlier attempt */
export async function makeAnew(
    worker: Pick<WorkerClient, 'call'>,
    remembered: Remembered,
    there: Pick<SessionSnapshot, 'rakes' | 'surfaces'> = { rakes: [], surfaces: [] },
): Promise<MadeAnew> {
    const [rakes, surfaces] = [new Map<string, string>(), new Map<string, string>()];
    const left = { rakes: [...there.rakes], surfaces: [...there.surfaces] };
    let why = '';
    for (const record of remembered.rakes) {
        const { rake, seeds, name, colour, kind, points } = record;
        const made = taken(left.rakes, (each) => each.name === name && JSON.stringify(each.points) === JSON.stringify(points));
        if (made !== undefined) {
            rakes.set(rake, made.rake);
            continue;
        }
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
        const same = taken(left.surfaces, (each) => each.rake === setting.rake && each.kind === setting.kind);
        if (same !== undefined) {
            surfaces.set(record.surface, same.surface);
            continue;
        }
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

/** The first that fits, which fits nothing else any more. */
function taken<Record>(from: Record[], fits: (each: Record) => boolean): Record | undefined {
    const at = from.findIndex(fits);
    return at < 0 ? undefined : from.splice(at, 1)[0];
}

/** What the server has said; without a connection nothing more can be made at all. */
function refusalOf(error: unknown): string {
    if (!(error instanceof CallError) || error.failure.kind === 'disconnected') throw error;
    return error.message;
}

function counted(count: number, word: string): string[] {
    return count === 0 ? [] : [`${count} ${word}${count === 1 ? '' : 's'}`];
}
