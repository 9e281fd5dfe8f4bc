// Slices of the session: their records in the picture, at the time of the picture, and the edits of this page, which are drawn before the
// server has answered. Loaded after the first picture.
import { effect, type ReadonlySignal, signal, untracked } from '@preact/signals-core';
import type { SliceRecord, Vec3 } from '../../protocol/messages.ts';
import { type SliceRaster, usualRange } from '../../protocol/sliceFile.ts';
import type { FlowScene } from '../../scene/scene.ts';
import { SliceLayer } from '../../scene/slices/sliceLayer.ts';
import type { AppState } from '../../state/appState.ts';
import type { OwnServer } from '../../connection/ownServer.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { putInto } from '../base/mapSignal.ts';
import type { Edits } from '../edits/edits.ts';
import { RecordDrafts } from '../edits/recordDrafts.ts';
import { dataTime } from '../time/timeSteps.ts';
import { FieldColours, type FieldMeaning } from './fieldColours.ts';
import { onOtherData } from './newestValues.ts';
import { SliceValues, type SliceWish } from './sliceValues.ts';

export interface SlicesOptions {
    state: AppState;
    scene: Pick<FlowScene, 'add' | 'size'> & { loop: Pick<FlowScene['loop'], 'request'> };
    server: Pick<OwnServer, 'fetch'>;
    worker: Pick<WorkerClient, 'call'>;
    edits: Pick<Edits, 'gestures' | 'history'>;
    /** Returns the time of the picture; no number where nothing has one. */
    time: () => number;
}

/** What of a slice can be edited. */
export type SlicePlace = Pick<SliceRecord, 'origin' | 'normal' | 'field'>;

export class Slices {
    /** As they are drawn: as records say, or as this page edits them. */
    readonly places: ReadonlySignal<ReadonlyMap<string, SlicePlace>>;
    readonly meanings: ReadonlySignal<ReadonlyMap<string, FieldMeaning>>;
    /** Why nothing is seen of one. */
    readonly faults = signal<ReadonlyMap<string, string>>(new Map());
    /** One is not there, or not as fine as the screen. */
    readonly waiting = signal(false);
    /** Lines of equal values of each; a look of this page. */
    readonly contours = signal(0);
    private readonly options: SlicesOptions;
    private readonly layer = new SliceLayer();
    private readonly values: SliceValues;
    private readonly colours = new FieldColours();
    private readonly drafts: RecordDrafts<SliceRecord, SlicePlace>;
    private readonly rasters = new Map<string, SliceRaster>();

    constructor(options: SlicesOptions) {
        this.options = options;
        const { state, scene, server, worker, edits } = options;
        scene.add(this.layer);
        this.meanings = this.colours.meanings;
        this.values = new SliceValues({
            fetch: (path, init) => server.fetch(path, init),
            fullSamples: () => Math.max(scene.size.width, scene.size.height),
            arrived: (id, raster, wish) => this.arrived(id, raster, wish),
            told: (id, fault) => putInto(this.faults, id, fault),
            changed: () => (this.waiting.value = this.values.unfinished),
        });
        this.drafts = new RecordDrafts<SliceRecord, SlicePlace>({
            ...{ state, edits, noun: 'slice', records: state.slices, placeOf },
            set: async (id, dataset, place, gesture) =>
                (await worker.call('slice.set', { ...(id === undefined ? {} : { slice: id }), dataset, ...place, gesture }))
                    .slice,
            remove: (slice, gesture) => worker.call('slice.delete', { slice, gesture }),
            gone: (id) => this.forget(id),
        });
        this.places = this.drafts.places;
        effect(() => this.wishAll());
        onOtherData(state, () => this.values.again());
        effect(() => {
            void this.contours.value;
            untracked(() => this.rasters.forEach((raster, id) => this.draw(id, raster)));
        });
    }

    /** Adds a slice through a point. */
    add(origin: Vec3, normal: Vec3, field = this.options.state.dataset.value?.velocity ?? ''): Promise<string | null> {
        return this.drafts.add({ origin, normal, field });
    }

    /** Draws it so at once, and tells the server. */
    change(id: string, change: Partial<SlicePlace>): void {
        this.drafts.change(id, change);
    }

    remove(id: string): Promise<void> {
        return this.drafts.remove(id);
    }

    private wishAll(): void {
        const { state } = this.options;
        const description = state.dataset.value;
        if (description === null || state.stage.value !== 'running') return;
        const { dataset } = description;
        const time = dataTime(description, this.options.time());
        for (const [id, { origin, normal, field }] of this.places.value) {
            // The edit is about to be refused, in words.
            if (!meets(description.bounds, origin, normal)) continue;
            this.values.want(id, { dataset, origin, normal, field, time });
        }
    }

    private forget(id: string): void {
        this.values.remove(id);
        this.layer.remove(id);
        this.rasters.delete(id);
        putInto(this.faults, id, null);
        this.colours.forget(id);
        this.options.scene.loop.request();
    }

    private arrived(id: string, raster: SliceRaster, { field }: SliceWish): void {
        this.rasters.set(id, raster);
        const usual = usualRange(raster);
        if (this.colours.show(id, field, usual)) {
            for (const [each, meaning] of this.meanings.peek()) {
                const other = this.rasters.get(each);
                if (each !== id && meaning.field === field && other !== undefined) this.draw(each, other);
            }
        }
        this.draw(id, raster);
        const lacks = raster.inFlow === 0 ? 'This plane meets only bodies.' : `${field} has no values here at this time.`;
        putInto(this.faults, id, usual === null ? lacks : null);
    }

    private draw(id: string, raster: SliceRaster): void {
        const meaning = this.meanings.peek().get(id);
        const seen = meaning !== undefined && usualRange(raster) !== null;
        this.layer.set(id, raster, seen ? { ...meaning, contours: this.contours.peek() } : null);
        this.options.scene.loop.request();
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
