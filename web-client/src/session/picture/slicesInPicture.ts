// Slices of the session: their records in the picture, at the time of the picture, and the edits of this page, which are drawn before the
// server has answered. Loaded after the first picture.
import { computed, effect, signal, untracked } from '@preact/signals-core';
import type { SliceRecord, Vec3 } from '../../protocol/messages.ts';
import { type SliceRaster, usualRange } from '../../protocol/sliceFile.ts';
import { coloursOf } from './usualColours.ts';
import type { FlowScene } from '../../scene/scene.ts';
import { SliceLayer, type SliceColours } from '../../scene/slices/sliceLayer.ts';
import type { AppState } from '../../state/appState.ts';
import { opacityOf, shows } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { OwnServer } from '../../connection/ownServer.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { announceUnlessDisconnected } from '../base/calls.ts';
import type { Edits } from '../edits/edits.ts';
import { dataTime } from '../time/timeSteps.ts';
import { SliceValues, type SliceWish } from './sliceValues.ts';

export interface SlicesOptions {
    state: AppState;
    view: Pick<ViewState, 'visibility'>;
    scene: Pick<FlowScene, 'add' | 'size'> & { loop: Pick<FlowScene['loop'], 'request'> };
    server: Pick<OwnServer, 'fetch'>;
    worker: Pick<WorkerClient, 'call'>;
    edits: Pick<Edits, 'gestures' | 'history'>;
    /** Returns the time of the picture; no number where nothing has one. */
    time: () => number;
}

/** What of a slice can be edited. */
export type SlicePlace = Pick<SliceRecord, 'origin' | 'normal' | 'field'>;

/** What the colours of a slice mean. */
export interface SliceMeaning extends SliceColours {
    field: string;
}

export class Slices {
    /** As they are drawn: as records say, or as this page edits them. */
    readonly places = signal<ReadonlyMap<string, SlicePlace>>(new Map());
    readonly meanings = signal<ReadonlyMap<string, SliceMeaning>>(new Map());
    /** Why nothing is seen of one. */
    readonly faults = signal<ReadonlyMap<string, string>>(new Map());
    /** One is not there, or not as fine as the screen. */
    readonly waiting = signal(false);
    /** Lines of equal values of each; a look of this page. */
    readonly contours = signal(0);
    private readonly options: SlicesOptions;
    private readonly layer = new SliceLayer();
    private readonly values: SliceValues;
    private readonly rasters = new Map<string, SliceRaster>();
    /** Between which values of a field lie, by field, as far as slices have shown. */
    private readonly spans = new Map<string, [number, number]>();
    private readonly drafts = new Map<string, SlicePlace>();
    private readonly acts = new Map<string, string>();
    private readonly sending = new Set<string>();

    constructor(options: SlicesOptions) {
        this.options = options;
        const { state, scene, server } = options;
        scene.add(this.layer);
        this.values = new SliceValues({
            fetch: (path, init) => server.fetch(path, init),
            fullSamples: () => Math.max(scene.size.width, scene.size.height),
            arrived: (id, raster, wish) => this.arrived(id, raster, wish),
            told: (id, fault) => this.tell(id, fault),
            changed: () => (this.waiting.value = this.values.unfinished),
        });
        effect(() => {
            const records = state.slices.value;
            void state.dataset.value;
            for (const [id, record] of records) if (!this.sending.has(id) && this.agrees(id, record)) this.drafts.delete(id);
            untracked(() => this.publish());
        });
        effect(() => this.wishAll());
        // What could not be had may be there now, or be other values.
        const data = computed(() => JSON.stringify([state.datasetEntry.value?.values, state.datasetEntry.value?.steps.ready]));
        effect(() => {
            void data.value;
            if (state.stage.value === 'running') untracked(() => this.values.again());
        });
        effect(() => {
            const visibility = options.view.visibility.value;
            for (const id of this.places.value.keys()) if (!shows(visibility, id)) untracked(() => this.forget(id));
        });
        effect(() => {
            void [this.contours.value, options.view.visibility.value];
            untracked(() => this.rasters.forEach((raster, id) => this.draw(id, raster)));
        });
    }

    /** Adds a slice through a point. */
    async add(origin: Vec3, normal: Vec3, field?: string): Promise<string | null> {
        const { state, worker, edits } = this.options;
        const dataset = state.dataset.value?.dataset;
        if (dataset === undefined) return null;
        const gesture = edits.gestures.begin();
        try {
            const what = { dataset, origin, normal, ...(field === undefined ? {} : { field }) };
            const { slice } = await worker.call('slice.set', { ...what, gesture });
            edits.history.noted(gesture);
            state.problems.solved('slice.set');
            return slice;
        } catch (error) {
            announceUnlessDisconnected(state.problems, 'slice.set', error);
            return null;
        }
    }

    /** Draws it so at once, and tells the server. */
    change(id: string, change: Partial<SlicePlace>): void {
        const place = this.places.value.get(id);
        if (place === undefined) return;
        this.drafts.set(id, { ...place, ...change });
        // Another field is another act than another place, also where one follows the other fast.
        this.acts.set(id, `slice ${id} ${Object.keys(change).join(' ')}`);
        this.publish();
        if (!this.sending.has(id)) void this.send(id);
    }

    async remove(id: string): Promise<void> {
        const { state, worker, edits } = this.options;
        const gesture = edits.gestures.begin();
        try {
            await worker.call('slice.delete', { slice: id, gesture });
            edits.history.noted(gesture);
        } catch (error) {
            announceUnlessDisconnected(state.problems, 'slice.delete', error);
        }
    }

    /** Of the edits of one slice only the newest waits. */
    private async send(id: string): Promise<void> {
        const { state, worker, edits } = this.options;
        this.sending.add(id);
        try {
            for (let sent: SlicePlace | undefined; sent !== this.drafts.get(id);) {
                sent = this.drafts.get(id)!;
                const { dataset } = state.slices.value.get(id)!;
                const gesture = edits.gestures.slid(this.acts.get(id) ?? id, performance.now());
                await worker.call('slice.set', { slice: id, dataset, ...sent, gesture });
                edits.history.noted(gesture);
            }
            state.problems.solved('slice.set');
        } catch (error) {
            this.drafts.delete(id);
            announceUnlessDisconnected(state.problems, 'slice.set', error);
        }
        this.sending.delete(id);
        const record = state.slices.value.get(id);
        if (record === undefined || this.agrees(id, record)) this.drafts.delete(id);
        this.publish();
    }

    /** The server has what this page draws, or nothing is drawn ahead. */
    private agrees(id: string, { origin, normal, field }: SliceRecord): boolean {
        const draft = this.drafts.get(id);
        return (
            draft === undefined ||
            JSON.stringify([draft.origin, draft.normal, draft.field]) === JSON.stringify([origin, normal, field])
        );
    }

    private publish(): void {
        const { state } = this.options;
        const places = new Map<string, SlicePlace>();
        for (const [id, record] of state.slices.peek()) {
            if (record.dataset === state.dataset.peek()?.dataset) places.set(id, this.drafts.get(id) ?? placeOf(record));
        }
        for (const id of this.places.peek().keys()) if (!places.has(id)) this.forget(id);
        this.places.value = places;
    }

    private wishAll(): void {
        const { state, view } = this.options;
        const description = state.dataset.value;
        if (description === null || state.stage.value !== 'running') return;
        const { dataset } = description;
        const time = dataTime(description, this.options.time());
        const visibility = view.visibility.value;
        for (const [id, { origin, normal, field }] of this.places.value) {
            // The edit is about to be refused, in words.
            if (!shows(visibility, id) || !meets(description.bounds, origin, normal)) continue;
            this.values.want(id, { dataset, origin, normal, field, time });
        }
    }

    private forget(id: string): void {
        this.values.remove(id);
        this.layer.remove(id);
        this.rasters.delete(id);
        this.tell(id, null);
        const meanings = new Map(this.meanings.peek());
        if (meanings.delete(id)) this.meanings.value = meanings;
        this.options.scene.loop.request();
    }

    private arrived(id: string, raster: SliceRaster, { field }: SliceWish): void {
        this.rasters.set(id, raster);
        const usual = usualRange(raster);
        if (usual !== null) this.widen(field, usual);
        this.mean(id, field);
        this.draw(id, usual === null ? null : raster, raster);
        const lacks = raster.inFlow === 0 ? 'This plane meets only bodies.' : `${field} has no values here at this time.`;
        this.tell(id, usual === null ? lacks : null);
    }

    /** All slices of a field have the same colours. Wider only: they must not flicker while a plane or the time moves. */
    private widen(field: string, [low, high]: [number, number]): void {
        const before = this.spans.get(field);
        const span: [number, number] = before === undefined ? [low, high] : [Math.min(before[0], low), Math.max(before[1], high)];
        this.spans.set(field, span);
        if (JSON.stringify(span) === JSON.stringify(before)) return;
        for (const [id, meaning] of this.meanings.peek()) {
            if (meaning.field !== field) continue;
            this.mean(id, field);
            const raster = this.rasters.get(id);
            if (raster !== undefined) this.draw(id, usualRange(raster) === null ? null : raster, raster);
        }
    }

    private mean(id: string, field: string): void {
        const meanings = new Map(this.meanings.peek());
        const span = this.spans.get(field);
        if (span === undefined) meanings.delete(id);
        else meanings.set(id, { field, ...coloursOf(...span), contours: this.contours.peek(), opacity: 1 });
        if (JSON.stringify([...meanings]) !== JSON.stringify([...this.meanings.peek()])) this.meanings.value = meanings;
        // A field that is shown again begins with what is seen then.
        const shown = new Set([...meanings.values()].map((each) => each.field));
        for (const each of this.spans.keys()) if (!shown.has(each)) this.spans.delete(each);
    }

    private draw(id: string, known: SliceRaster | null, raster = known!): void {
        const meaning = this.meanings.peek().get(id);
        const contours = this.contours.peek();
        const opacity = opacityOf(this.options.view.visibility.peek(), id);
        this.layer.set(id, raster, known === null || meaning === undefined ? null : { ...meaning, contours, opacity });
        this.options.scene.loop.request();
    }

    private tell(id: string, fault: string | null): void {
        if ((this.faults.peek().get(id) ?? null) === fault) return;
        const faults = new Map(this.faults.peek());
        if (fault === null) faults.delete(id);
        else faults.set(id, fault);
        this.faults.value = faults;
    }
}

/** A plane has something of the box in it, or on it. */
function meets(bounds: readonly number[], origin: Vec3, normal: Vec3): boolean {
    const heights = [0, 1, 2].map((k) => [0, 1].map((end) => (bounds[2 * k + end]! - origin[k]!) * normal[k]!));
    const [low, high] = [Math.min, Math.max].map((end) => heights.reduce((sum, pair) => sum + end(...pair), 0)) as [
        number,
        number,
    ];
    return low <= 0 && high >= 0;
}

/** Without what the server alone writes. */
function placeOf({ origin, normal, field }: SliceRecord): SlicePlace {
    return { origin, normal, field };
}
