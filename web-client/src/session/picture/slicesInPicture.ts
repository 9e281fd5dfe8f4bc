// Slices of the session: their records in the picture, at the time of the picture, and the edits of this page, which are drawn before the
// server has answered. Loaded after the first picture.
import { computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals-core';
import type { SliceRecord, Vec3 } from '../../protocol/messages.ts';
import { sliceNumbers, type SliceRaster, usualRange } from '../../protocol/sliceFile.ts';
import type { FlowScene } from '../../scene/scene.ts';
import { dot } from '../../scene/rake/rakeShape.ts';
import { spanAcross } from '../../scene/slices/planeSection.ts';
import { SliceArrowLayer } from '../../scene/slices/sliceArrows.ts';
import { SliceHandles } from '../../scene/slices/sliceHandles.ts';
import { SliceLayer } from '../../scene/slices/sliceLayer.ts';
import type { AppState } from '../../state/appState.ts';
import { opacityOf, shows } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { OwnServer } from '../../connection/ownServer.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { putInto } from '../base/mapSignal.ts';
import { RecordDrafts, type RecordDraftsOptions } from '../edits/recordDrafts.ts';
import { dataTime } from '../time/timeSteps.ts';
import { SlicePoints } from '../tools/slicePoints.ts';
import type { FieldColours, FieldMeaning } from './fieldColours.ts';
import { planeWords } from './planeWords.ts';
import { SliceArrows } from './sliceArrows.ts';
import { onOtherData } from './newestValues.ts';
import { membersOf, minusOf, type SliceMinus, minusWish } from './sliceMinus.ts';
import { SliceValues, type SliceWish } from './sliceValues.ts';

export interface SlicesOptions {
    state: AppState;
    view: Pick<ViewState, 'besidePointer' | 'chosenThing' | 'clip' | 'slicePoints' | 'slices' | 'tool' | 'units' | 'visibility'>;
    scene: Pick<FlowScene, 'add' | 'hold' | 'pick' | 'size' | 'view' | 'whenDrawn'> & {
        rakes: Pick<FlowScene['rakes'], 'pointUnder'>;
        loop: Pick<FlowScene['loop'], 'request'>;
        pointerTools: Pick<FlowScene['pointerTools'], 'add'>;
    };
    /** Shared with streamlines. */
    colours: FieldColours;
    server: Pick<OwnServer, 'fetch'>;
    worker: Pick<WorkerClient, 'call'>;
    edits: RecordDraftsOptions<SliceRecord, SlicePlace>['edits'];
    /** Returns the time of the picture in some data; no number where nothing has one. */
    time: (dataset: string) => number;
}

/** What of a slice can be edited. */
export type SlicePlace = Pick<SliceRecord, 'origin' | 'normal' | 'field'> & {
    /** Null: nothing is subtracted. */
    minus: SliceMinus | null;
};

const mostLags = 1000;

export class Slices {
    /** As they are drawn: as records say, or as this page edits them. */
    readonly places: ReadonlySignal<ReadonlyMap<string, SlicePlace>>;
    readonly meanings: ReadonlySignal<ReadonlyMap<string, FieldMeaning>>;
    private readonly numbers = signal<ReadonlyMap<string, { area: number; mean: number; key: string }>>(new Map());
    /** Why nothing is seen of one. */
    readonly faults = signal<ReadonlyMap<string, string>>(new Map());
    /** The server has not answered for long. */
    readonly late = signal<ReadonlyMap<string, true>>(new Map());
    /** One is not there, or not as fine as the screen. */
    readonly waiting = signal(false);
    /** From changes by this page to their pictures, in milliseconds: the last ones. */
    readonly lags: number[] = [];
    readonly handles: SliceHandles;
    readonly arrows: SliceArrows;
    private readonly options: SlicesOptions;
    private readonly layer = new SliceLayer();
    private readonly values: SliceValues;
    private readonly colours: FieldColours;
    private readonly drafts: RecordDrafts<SliceRecord, SlicePlace>;
    private readonly rasters = new Map<string, SliceRaster>();
    /** When this page put a slice there, on performance.now()'s clock; while that is not drawn. */
    private readonly changedAt = new Map<string, number>();

    constructor(options: SlicesOptions) {
        this.options = options;
        const { state, scene, server, worker, edits } = options;
        scene.add(this.layer);
        this.handles = this.handlesIn(scene);
        this.colours = options.colours;
        this.values = new SliceValues({
            fetch: (path, init) => server.fetch(path, init),
            fullSamples: () => Math.max(scene.size.width, scene.size.height),
            arrived: (id, raster, wish) => this.arrived(id, raster, wish),
            told: (id, fault) => this.tell(id, fault),
            late: (id, late) => putInto(this.late, id, late ? true : null),
            changed: () => this.count(),
        });
        const arrows = new SliceArrowLayer();
        scene.add(arrows);
        this.arrows = new SliceArrows({
            layer: arrows,
            fetch: (path, init) => server.fetch(path, init),
            requestFrame: () => scene.loop.request(),
            changed: () => this.count(),
        });
        this.drafts = new RecordDrafts<SliceRecord, SlicePlace>({
            ...{ state, edits, noun: 'slice', records: state.slices, placeOf },
            own: ['field', 'minus'],
            set: async (id, dataset, { minus, ...place }, gesture) => {
                const slice = id === undefined ? {} : { slice: id };
                return (await worker.call('slice.set', { ...slice, dataset, ...place, ...membersOf(minus), gesture })).slice;
            },
            remove: (slice, gesture) => worker.call('slice.delete', { slice, gesture }),
            gone: (id) => this.forget(id),
        });
        this.places = this.drafts.places;
        this.meanings = computed(() => new Map([...this.colours.meanings.value].filter(([id]) => this.places.value.has(id))));
        effect(() => this.wishAll());
        onOtherData(state, () => {
            this.values.again();
            this.arrows.again();
        });
        effect(() => {
            const id = options.view.chosenThing.value ?? '';
            const place = shows(options.view.visibility.value, id) ? (this.places.value.get(id) ?? null) : null;
            const bounds = state.dataset.value?.bounds ?? [];
            untracked(() => this.handles.set(place, bounds));
        });
        effect(() => {
            const visibility = options.view.visibility.value;
            for (const id of this.places.value.keys()) if (!shows(visibility, id)) untracked(() => this.forget(id));
        });
        effect(() => {
            void [options.view.slices.value, options.view.visibility.value, this.meanings.value];
            untracked(() => this.rasters.forEach((raster, id) => this.draw(id, raster)));
        });
    }

    /** Adds a slice through a point, of the field of the chosen one if its data are worked on, and chooses it. */
    async add(origin: Vec3, normal: Vec3): Promise<void> {
        const { view } = this.options;
        const field = this.drafts.like(view.chosenThing.value)?.field ?? this.options.state.dataset.value?.velocity ?? '';
        const made = await this.drafts.add({ origin, normal, field, minus: null });
        if (made !== null) view.chosenThing.value = made;
    }

    /** Draws it so at once, and tells the server. */
    change(id: string, change: Partial<SlicePlace>): void {
        this.drafts.change(id, change);
        const place = this.places.value.get(id);
        if (place !== undefined) this.changedAt.set(keyOf(id, place), performance.now());
    }

    /** Of what is seen of one, an area and the mean over it; null: that is not known yet, or nothing is seen. */
    numbersOf(id: string): { area: number; mean: number } | null {
        const [numbers, place] = [this.numbers.value.get(id), this.places.value.get(id)];
        return numbers !== undefined && place !== undefined && numbers.key === shownKey(id, place, place) ? numbers : null;
    }

    retry(id: string): void {
        this.values.retry(id);
    }

    remove(id: string): Promise<void> {
        return this.drafts.remove(id);
    }

    private handlesIn(scene: SlicesOptions['scene']): SliceHandles {
        const { state, view } = this.options;
        const handles = new SliceHandles({
            ...{ view: () => scene.view(), requestFrame: () => scene.loop.request(), onHold: (held) => scene.hold(held) },
            mayMove: () => !state.locked.value && view.tool.value === 'none',
            moved: ({ origin, normal }, at) => {
                this.change(view.chosenThing.value!, { origin, normal });
                view.besidePointer.value = { at, words: planeWords(origin, normal) };
            },
            released: () => (view.besidePointer.value = null),
        });
        scene.add(handles);
        scene.pointerTools.add(handles);
        scene.pointerTools.add(
            new SlicePoints({
                view,
                pick: (at) => scene.pick(at),
                rakeAt: (at) => scene.rakes.pointUnder(at, scene.view()),
                add: (origin, normal) => void this.add(origin, normal),
            }),
        );
        // A click on a slice chooses it; one beside all of them takes the handles away.
        scene.pointerTools.add({
            click: ({ at }) => {
                if (view.tool.value !== 'none') return false;
                const seen = this.layer.pick(scene.view(), at);
                const isFirst = seen !== null && scene.pick(at)?.distance === seen.distance;
                if (isFirst) view.chosenThing.value = seen.slice;
                else if (this.places.value.has(view.chosenThing.value ?? '')) view.chosenThing.value = null;
                return isFirst;
            },
        });
        return handles;
    }

    /** A slice of another time is not left where this one could not be had. */
    private tell(id: string, fault: string | null): void {
        putInto(this.faults, id, fault);
        if (fault === null) return;
        putInto(this.numbers, id, null);
        this.layer.remove(id);
        this.rasters.delete(id);
        this.options.scene.loop.request();
    }

    private wishAll(): void {
        const { state, view } = this.options;
        if (state.stage.value !== 'running') return;
        const visibility = view.visibility.value;
        for (const [id, { origin, normal, field, minus }] of this.places.value) {
            const dataset = state.slices.value.get(id)?.dataset ?? '';
            const description = state.described(dataset);
            // Beside its data: the edit is about to be refused, in words.
            if (description === null || !shows(visibility, id) || !meets(description.bounds, origin, normal)) continue;
            const time = dataTime(description, this.options.time(dataset));
            const less = minus === null ? {} : { minus: minusWish(minus, dataset, time, (other) => this.nameOf(other)) };
            const wish = { dataset, origin, normal, field, time, ...less };
            this.values.want(id, wish);
            if (this.options.view.slices.value.arrows) this.arrows.want(id, wish);
            else this.arrows.remove(id);
        }
    }

    private count(): void {
        this.waiting.value = this.values.unfinished || this.arrows.unfinished;
    }

    private forget(id: string): void {
        this.values.remove(id);
        this.arrows.remove(id);
        this.layer.remove(id);
        this.rasters.delete(id);
        putInto(this.faults, id, null);
        putInto(this.numbers, id, null);
        this.colours.forget(id);
        this.options.scene.loop.request();
    }

    private arrived(id: string, raster: SliceRaster, wish: SliceWish): void {
        const { field } = wish;
        this.rasters.set(id, raster);
        const usual = usualRange(raster);
        this.colours.show(id, field, usual, wish.minus?.words);
        this.draw(id, raster);
        this.measure(keyOf(id, wish));
        const lacks = raster.inFlow === 0 ? 'This plane meets only bodies.' : `${field} has no values here at this time.`;
        putInto(this.faults, id, usual === null ? lacks : null);
        const numbers = sliceNumbers(raster);
        putInto(this.numbers, id, numbers === null ? null : { ...numbers, key: shownKey(id, wish, this.places.peek().get(id)) });
    }

    private nameOf(dataset: string): string {
        return this.options.state.datasets.peek().find((each) => each.dataset === dataset)?.name ?? dataset;
    }

    private measure(key: string): void {
        const changed = this.changedAt.get(key);
        if (changed === undefined) return;
        // Places in between that were never asked for are not drawn any more.
        for (const [each, at] of this.changedAt) if (at <= changed) this.changedAt.delete(each);
        this.options.scene.whenDrawn((at) => {
            this.lags.push(at - changed);
            if (this.lags.length > mostLags) this.lags.shift();
        });
    }

    private draw(id: string, raster: SliceRaster): void {
        const meaning = this.meanings.peek().get(id);
        const seen = meaning !== undefined && usualRange(raster) !== null;
        const { contours } = this.options.view.slices.peek();
        const opacity = opacityOf(this.options.view.visibility.peek(), id);
        this.layer.set(id, raster, seen ? { ...meaning, contours, opacity } : null);
        this.options.scene.loop.request();
    }
}

/** A plane has something of the box in it, or on it. */
function meets(bounds: readonly number[], origin: Vec3, normal: Vec3): boolean {
    const [low, high] = spanAcross(bounds, normal);
    const at = dot(origin, normal);
    return low <= at && at <= high;
}

function keyOf(id: string, { origin, normal, field }: Pick<SlicePlace, 'origin' | 'normal' | 'field'>): string {
    return JSON.stringify([id, origin, normal, field]);
}

function shownKey(id: string, at: Pick<SlicePlace, 'origin' | 'normal' | 'field'>, place: SlicePlace | undefined): string {
    return keyOf(id, at) + JSON.stringify(place?.minus ?? null);
}

/** Without what the server alone writes. */
function placeOf({ origin, normal, field, ...rest }: SliceRecord): SlicePlace {
    return { origin, normal, field, minus: minusOf(rest) };
}
