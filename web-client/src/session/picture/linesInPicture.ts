// Streamlines of the session: their records in the picture, at the time of the picture, and the edits of this page, which are drawn before
// the server has answered. Loaded after the first picture.
import { effect, type ReadonlySignal, signal, untracked } from '@preact/signals-core';
import type { LinesRecord } from '../../protocol/messages.ts';
import type { LinesFile } from '../../protocol/linesFile.ts';
import { LineLayer } from '../../scene/lines/lineLayer.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import { opacityOf, shows } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { OwnServer } from '../../connection/ownServer.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { putInto } from '../base/mapSignal.ts';
import { RecordDrafts, type RecordDraftsOptions } from '../edits/recordDrafts.ts';
import { dataTime } from '../time/timeSteps.ts';
import type { FieldColours, FieldMeaning } from './fieldColours.ts';
import { LinesValues, type LinesWish } from './linesValues.ts';
import { onOtherData } from './newestValues.ts';

export interface LinesOptions {
    state: AppState;
    view: Pick<ViewState, 'lines' | 'visibility'>;
    /** Shared with slices. */
    colours: FieldColours;
    scene: Pick<FlowScene, 'add'> & { loop: Pick<FlowScene['loop'], 'request'> };
    server: Pick<OwnServer, 'fetch'>;
    worker: Pick<WorkerClient, 'call'>;
    edits: RecordDraftsOptions<LinesRecord, LinesPlace>['edits'];
    /** Returns the time of the picture in some data; no number where nothing has one. */
    time: (dataset: string) => number;
}

/** What of a set can be edited. */
export type LinesPlace = Omit<LinesRecord, 'lines' | 'rev' | 'dataset' | 'low' | 'high'> & {
    /** Of the colours; null: as the values have it. */
    range: readonly [number, number] | null;
};

/** So many values are enough to know between which they lie. */
const enoughValues = 20_000;

export class Lines {
    /** As they are drawn: as records say, or as this page edits them. */
    readonly places: ReadonlySignal<ReadonlyMap<string, LinesPlace>>;
    /** What the colours of each mean. */
    readonly meanings = signal<ReadonlyMap<string, FieldMeaning>>(new Map());
    /** Why nothing is seen of one. */
    readonly faults = signal<ReadonlyMap<string, string>>(new Map());
    /** The server has not answered for long. */
    readonly late = signal<ReadonlyMap<string, true>>(new Map());
    /** What there is of one. */
    readonly told = signal<ReadonlyMap<string, string>>(new Map());
    /** One is not there. */
    readonly waiting = signal(false);
    private readonly options: LinesOptions;
    private readonly layer = new LineLayer();
    private readonly values: LinesValues;
    private readonly colours: FieldColours;
    private readonly drafts: RecordDrafts<LinesRecord, LinesPlace>;
    private readonly files = new Map<string, LinesFile>();

    constructor(options: LinesOptions) {
        this.options = options;
        this.colours = options.colours;
        const { state, view, scene, server, worker, edits } = options;
        scene.add(this.layer);
        this.values = new LinesValues({
            fetch: (path, init) => server.fetch(path, init),
            arrived: (id, lines, wish) => this.arrived(id, lines, wish),
            told: (id, fault) => this.tell(id, fault),
            late: (id, late) => putInto(this.late, id, late ? true : null),
            changed: () => (this.waiting.value = this.values.unfinished),
        });
        this.drafts = new RecordDrafts<LinesRecord, LinesPlace>({
            ...{ state, edits, noun: 'lines', records: state.lines, placeOf },
            own: ['field', 'range'],
            set: async (id, dataset, { range, ...place }, gesture) => {
                const colours = range === null ? {} : { low: range[0], high: range[1] };
                const known = id === undefined ? {} : { lines: id };
                return (await worker.call('lines.set', { ...known, dataset, ...place, ...colours, gesture })).lines;
            },
            remove: (lines, gesture) => worker.call('lines.delete', { lines, gesture }),
            gone: (id) => this.forget(id),
        });
        this.places = this.drafts.places;
        effect(() => this.wishAll());
        effect(() => this.paint());
        effect(() => {
            this.layer.setWidth(view.lines.value.width);
            scene.loop.request();
        });
        onOtherData(state, () => this.values.again());
    }

    like(chosen: string | null): LinesPlace | undefined {
        return this.drafts.like(chosen);
    }

    add(place: LinesPlace): Promise<string | null> {
        return this.drafts.add(place);
    }

    /** Draws it so at once, and tells the server. */
    change(id: string, change: Partial<LinesPlace>): void {
        this.drafts.change(id, change);
    }

    retry(id: string): void {
        this.values.retry(id);
    }

    remove(id: string): Promise<void> {
        return this.drafts.remove(id);
    }

    /** Lines of another time are not left where these could not be had. */
    private tell(id: string, fault: string | null): void {
        putInto(this.faults, id, fault);
        if (fault === null) return;
        this.layer.remove(id);
        this.files.delete(id);
        this.options.scene.loop.request();
    }

    private wishAll(): void {
        const { state, view, time } = this.options;
        if (state.stage.value !== 'running') return;
        for (const [id, place] of this.places.value) {
            const description = state.described(state.lines.value.get(id)?.dataset ?? '');
            if (description === null) continue;
            const shown = { dataset: description.dataset, time: dataTime(description, time(description.dataset)) };
            if (!shows(view.visibility.value, id)) {
                untracked(() => this.forget(id));
                continue;
            }
            // Another range needs no other lines.
            const { range: _range, ...wanted } = place;
            this.values.want(id, { ...shown, ...wanted });
        }
    }

    private arrived(id: string, lines: LinesFile, { field }: LinesWish): void {
        this.files.set(id, lines);
        this.colours.show(id, field, usualRange(lines.values));
        untracked(() => this.paint());
        putInto(this.told, id, linesWords(lines));
    }

    /** Colours where someone has chosen them, else those of the field. */
    private paint(): void {
        const meanings = new Map<string, FieldMeaning>();
        const usual = this.colours.meanings.value;
        const visibility = this.options.view.visibility.value;
        for (const [id, { range, field }] of this.places.value) {
            const lines = this.files.get(id);
            const meaning = usual.get(id) ?? { field, less: '', map: 'viridis' as const, range: [0, 1] as [number, number] };
            const shown = range === null ? meaning : { ...meaning, range: [...range] as [number, number] };
            if (lines === undefined) continue;
            this.layer.set(id, lines, { ...shown, opacity: opacityOf(visibility, id) });
            if (usual.has(id) && shown.field === field) meanings.set(id, shown);
        }
        if (JSON.stringify([...meanings]) !== JSON.stringify([...this.meanings.peek()])) this.meanings.value = meanings;
        this.options.scene.loop.request();
    }

    private forget(id: string): void {
        this.values.remove(id);
        this.layer.remove(id);
        this.files.delete(id);
        this.colours.forget(id);
        putInto(this.faults, id, null);
        putInto(this.told, id, null);
        this.options.scene.loop.request();
    }
}

/** Between which values all but one per cent at each end lie; null: there are none. */
function usualRange(values: Float32Array): [number, number] | null {
    const stride = Math.max(1, Math.floor(values.length / enoughValues));
    const known = values.filter((value, i) => i % stride === 0 && Number.isFinite(value)).sort();
    const at = (part: number): number => known[Math.round(part * (known.length - 1))]!;
    return known.length === 0 ? null : [at(0.01), at(0.99)];
}

/** As what is left out must be told: seeds without a line, lines that were cut. */
export function linesWords({ offsets, seeds, outside, ends }: LinesFile): string {
    const lines = offsets.length - 1;
    const said = [lines === 1 ? '1 line.' : `${lines} lines.`];
    if (outside > 0) {
        said.push(`${outside} of ${seeds} ${seeds === 1 ? 'seed lies' : 'seeds lie'} outside of the flow or in a body.`);
    }
    if (ends.cut > 0) said.push(`${ends.cut === 1 ? '1 end is' : `${ends.cut} ends are`} at the limit of points.`);
    return said.join(' ');
}

/** Without what the server alone writes. */
function placeOf({ lines: _lines, rev: _rev, dataset: _dataset, low, high, ...place }: LinesRecord): LinesPlace {
    const range = low === undefined || high === undefined ? null : ([low, high] as const);
    return { ...place, range };
}
