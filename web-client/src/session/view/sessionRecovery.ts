// Recovery of a session that the server has forgotten, from what the page or its link remembers.
import type {
    AnnotationRecord,
    BookmarkRecord,
    LinesRecord,
    RakeRecord,
    SessionSnapshot,
    SliceRecord,
    SurfaceRecord,
    SurfaceSetting,
} from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import { readPageView, renamedView } from '../../state/pageView.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';
import { settingForRecovery } from '../edits/surfaceIntent.ts';
import type { UrlState } from './urlState.ts';

export interface SessionContent {
    rakes: RakeRecord[];
    surfaces: SurfaceRecord[];
    slices: SliceRecord[];
    lines: LinesRecord[];
    bookmarks: BookmarkRecord[];
    annotations: AnnotationRecord[];
}

/** Names in the former session -> names in the new one, of what could be made; and why the rest could not. */
export interface Recovered {
    rakes: Map<string, string>;
    /** And of slices and streamlines. */
    surfaces: Map<string, string>;
    /** Null: all is there. */
    missing: string | null;
}

/** Returns what this page has had, or else what its link says. Rakes have the shape on the screen, which may
 *  be ahead of the record. */
export function knownContent(state: AppState, url: UrlState): SessionContent {
    const all = <Record>({ value }: { value: ReadonlyMap<string, Record> }): Record[] => [...value.values()];
    const others = { slices: all(state.slices), lines: all(state.lines), bookmarks: all(state.bookmarks) };
    const known = { rakes: all(state.rakes), surfaces: all(state.surfaces), ...others, annotations: all(state.annotations) };
    if (isEmptyContent(known) && url.state !== null) {
        const { view: _, ...records } = url.state;
        return { ...known, ...records };
    }
    const [active, shape] = [state.rake.value?.rake, state.rakeShape.value];
    const rakes = known.rakes.map((record) => {
        if (record.rake !== active || shape.points.length === 0) return record;
        return { ...record, kind: shape.kind, points: [...shape.points] };
    });
    return { ...known, rakes };
}

export function isEmptyContent(content: SessionContent): boolean {
    return Object.values(content).every((records: readonly unknown[]) => records.length === 0);
}

function isAsked({ rake, kind, field }: SurfaceRecord, setting: SurfaceSetting): boolean {
    return rake === setting.rake && kind === setting.kind && field === setting.field;
}

/**
 * Each record by itself: what the server refuses of a link is missed, and the rest is there.
 * @param there  made in an earlier attempt, which a lost connection has ended
 */
export async function recoverSession(
    worker: Pick<WorkerClient, 'call'>,
    remembered: SessionContent,
    there: Pick<SessionSnapshot, 'rakes' | 'surfaces'> & Partial<SessionSnapshot> = { rakes: [], surfaces: [] },
): Promise<Recovered> {
    const [rakes, surfaces] = [new Map<string, string>(), new Map<string, string>()];
    const refusals = new Refusals();
    const left = {
        rakes: [...there.rakes],
        surfaces: [...there.surfaces],
        slices: [...(there.slices ?? [])],
        lines: [...(there.lines ?? [])],
    };
    for (const { rake, seeds, name, colour = '', kind, points } of remembered.rakes) {
        const setting = { kind, points: [...points], seeds, name, ...(colour === '' ? {} : { colour }) };
        const now =
            taken(left.rakes, (each) => each.name === name && JSON.stringify(each.points) === JSON.stringify(points)) ??
            (await refusals.of('rake', () => worker.call('rake.set', setting)));
        if (now !== null) rakes.set(rake, now.rake);
    }
    for (const record of remembered.surfaces) {
        const setting = settingForRecovery(record, rakes);
        const now =
            taken(left.surfaces, (each) => setting !== null && isAsked(each, setting)) ??
            (await refusals.of('surface', setting === null ? null : () => worker.call('surface.set', setting)));
        if (now !== null) surfaces.set(record.surface, now.surface);
    }
    for (const { slice, rev: _, ...setting } of remembered.slices) {
        const now =
            taken(left.slices, (each) => holds(each, setting)) ??
            (await refusals.of('slice', () => worker.call('slice.set', setting)));
        if (now !== null) surfaces.set(slice, now.slice);
    }
    for (const { lines, rev: _, ...setting } of remembered.lines) {
        const now =
            taken(left.lines, (each) => holds(each, setting)) ??
            (await refusals.of('set of streamlines', () => worker.call('lines.set', setting)));
        if (now !== null) surfaces.set(lines, now.lines);
    }
    const notes = (there.annotations ?? []).map(({ text }) => text);
    for (const { text, position, surface = '' } of remembered.annotations) {
        const on = surfaces.get(surface);
        if (taken(notes, (each) => each === text) !== null) continue;
        await refusals.of('note', () =>
            worker.call('annotation.set', { text, position, ...(on === undefined ? {} : { surface: on }) }),
        );
    }
    const views = (there.bookmarks ?? []).map(({ name }) => name);
    for (const { name, view, time } of remembered.bookmarks) {
        if (taken(views, (each) => each === name) !== null) continue;
        const setting = {
            name,
            view: { ...renamedView(readPageView(view), surfaces, rakes) },
            ...(time === undefined ? {} : { time }),
        };
        await refusals.of('view', () => worker.call('bookmark.set', setting));
    }
    return { rakes, surfaces, missing: refusals.words };
}

const plurals = {
    rake: 'rakes',
    surface: 'surfaces',
    slice: 'slices',
    'set of streamlines': 'sets of streamlines',
    note: 'notes',
    view: 'views',
};
type Kind = keyof typeof plurals;

/** What could not be made, by its kind, and the first reason. */
export class Refusals {
    private readonly counts = new Map<Kind, number>();
    private why = '';

    /** Null where it is refused. @param make null: something that it needs is missing */
    async of<Made>(kind: Kind, make: (() => Promise<Made>) | null): Promise<Made | null> {
        try {
            if (make !== null) return await make();
        } catch (error) {
            this.why ||= refusalOf(error);
        }
        this.counts.set(kind, (this.counts.get(kind) ?? 0) + 1);
        return null;
    }

    get words(): string | null {
        return this.says('Not recreated');
    }

    says(what: string): string | null {
        if (this.counts.size === 0) return null;
        const missing = [...this.counts].map(([kind, count]) => `${count} ${count === 1 ? kind : plurals[kind]}`).join(' and ');
        return `${what}: ${missing}${this.why === '' ? '' : `. ${this.why}`}`;
    }
}

/** A record has all of a setting. */
function holds(record: object, setting: object): boolean {
    return Object.entries(setting).every(([name, value]) => {
        return JSON.stringify((record as Record<string, unknown>)[name]) === JSON.stringify(value);
    });
}

/** The first that fits, which fits nothing else any more. */
function taken<Record>(from: Record[], fits: (each: Record) => boolean): Record | null {
    const at = from.findIndex(fits);
    return at < 0 ? null : from.splice(at, 1)[0]!;
}

/** Returns what the server has said; without a connection nothing more can be made at all. */
function refusalOf(error: unknown): string {
    if (!(error instanceof CallError) || error.failure.kind === 'disconnected') throw error;
    return error.message;
}
