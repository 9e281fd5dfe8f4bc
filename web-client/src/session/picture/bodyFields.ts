// The values along the body, for its texture and its colours: asked for while they are wanted, at the time of the picture. One
// request at a time; of what comes meanwhile only the newest is asked for.
import { computed, effect, signal } from '@preact/signals-core';
import { faultOf, type OwnServer } from '../../connection/ownServer.ts';
import type { BodyValues } from '../../mesh/meshChange.ts';
import { niceStep } from '../../scene/base/numbers.ts';
import type { FlowScene } from '../../scene/scene.ts';
import { showsBeyondBody } from '../../state/bodyPatches.ts';
import type { AppState } from '../../state/appState.ts';
import type { ColourMap } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { type LateWaits, waitsSaid } from '../base/lateWaits.ts';
import { attributeOf, canCome } from './surfaceStyleOf.ts';
import { coloursOf } from './usualColours.ts';

export interface BodyFieldsOptions {
    state: Pick<AppState, 'dataset' | 'datasetEntry' | 'notices' | 'stage' | 'times'>;
    view: Pick<ViewState, 'body'>;
    scene: { body: Pick<FlowScene['body'], 'setColours' | 'setTime' | 'setValues'> };
    worker: Pick<WorkerClient, 'bodyValues'>;
    server: Pick<OwnServer, 'fetch'>;
    /** Returns the time of the picture; no number where nothing has one. */
    time: () => number;
    /** A clock moves it. */
    moves: () => boolean;
}

const about = 'body values';
const aboutFile = 'body file';
/** More lines of equal values run into each other. */
const contourLines = 15;

/** What is wanted: the same again is not asked for twice. */
interface Wish {
    key: string;
    time: number;
    /** As the server knows it; empty: the flow alone. */
    field: string;
    allPatches: boolean;
}

/** What a field's values on the body lie between. */
export interface BodyExtent {
    least: number;
    greatest: number;
    /** Without the last hundredth at each end. */
    most: readonly [number, number];
}

export interface BodySpan {
    /** As the server knows it. */
    field: string;
    map: ColourMap;
    /** What both ends of the colours stand for. */
    colours: readonly [number, number];
    /** The least and the greatest value, where they lie beyond colours that nobody has chosen. */
    beyond: readonly [number | null, number | null];
}

export class BodyFields {
    /** failed: the server did not send them for this time. */
    readonly status = computed((): 'off' | 'waiting' | 'shown' | 'failed' => {
        const wish = this.wish.value;
        if (wish === null) return 'off';
        if (this.answered.value !== wish.key) return 'waiting';
        return this.failed.value ? 'failed' : 'shown';
    });
    /** Null where no field colours the body, or it has no values. */
    readonly span = computed((): BodySpan | null => {
        const [field, extent] = [this.field.value, this.extent.value];
        if (field === '' || extent === null || extent.field !== field) return null;
        const { map, range } = this.options.view.body.value;
        const usual = coloursOf(...mostOf(extent));
        const colours = range ?? usual.range;
        const [low, high] = colours;
        return {
            ...{ field, colours, map: map ?? usual.map },
            beyond: [
                range === null && extent.least < low ? extent.least : null,
                range === null && extent.greatest > high ? extent.greatest : null,
            ],
        };
    });
    private readonly options: BodyFieldsOptions;
    /** The key of the wish that was answered last. */
    private readonly answered = signal('');
    private readonly failed = signal(false);
    private readonly extent = signal<(BodyExtent & { dataset: string; field: string }) | null>(null);
    private readonly waits: LateWaits;
    private asking = false;
    /** Ends what is asked for of data that are not shown any more. */
    private ended = new AbortController();

    constructor(options: BodyFieldsOptions) {
        this.options = options;
        const { state, scene, view } = options;
        this.waits = waitsSaid(state.notices, 'the values along the body');
        effect(() => {
            const [first = 0] = state.times.value;
            scene.body.setTime(options.moves() ? this.time() - first : null);
        });
        effect(() => {
            void this.isOf.value;
            return () => this.ended.abort();
        });
        effect(() => {
            const wish = this.wish.value;
            if (wish === null) this.forget();
            // What is on the screen stays while the server does not hear.
            else if (state.stage.value === 'running') void this.ask();
        });
        effect(() => {
            const span = this.span.value;
            const { invert, contours } = view.body.value;
            if (span === null) return;
            const [low, high] = span.colours;
            const contourStep = contours ? niceStep((high - low) / contourLines) : 0;
            scene.body.setColours({ map: span.map, inverted: invert, range: span.colours, contourStep });
        });
    }

    /** A look may have been made for other data: what these do not have is not asked for. */
    private readonly field = computed((): string => {
        const dataset = this.options.state.dataset.value;
        const attribute = attributeOf(this.options.view.body.value.colourBy) ?? '';
        if (attribute === 'speed') return dataset?.velocity ?? '';
        return attribute !== '' && canCome(dataset, attribute) ? attribute : '';
    });

    /** Whose values are wanted; none: empty. */
    private readonly isOf = computed(() => (this.wish.value === null ? '' : this.options.state.dataset.value!.dataset));

    private readonly wish = computed((): Wish | null => {
        const { state, view } = this.options;
        const dataset = state.dataset.value;
        const field = this.field.value;
        if ((!view.body.value.texture && field === '') || dataset === null) return null;
        const allPatches = showsBeyondBody(dataset, view.body.value);
        if (!dataset.obstacle && !allPatches) return null;
        const time = this.timeInData();
        const key = JSON.stringify([
            dataset.dataset,
            state.datasetEntry.value?.values,
            time,
            field,
            allPatches,
            view.body.value.texture,
        ]);
        return { key, time, field, allPatches };
    });

    /** The body as a .vtp file, with the field that is shown on it; null where the server did not send it, and why is told. */
    async file(signal: AbortSignal): Promise<Blob | null> {
        const { server, state, view } = this.options;
        const dataset = state.dataset.value;
        const field = this.field.value;
        const query = new URLSearchParams({
            ...(field === '' ? {} : { field, time: String(this.timeInData()) }),
            ...(showsBeyondBody(dataset, view.body.value) ? { patches: 'all' } : {}),
        });
        try {
            const reply = await server.fetch(
                `api/v1/datasets/${encodeURIComponent(dataset?.dataset ?? '')}/body.vtp?${query.toString()}`,
                { signal },
            );
            if (!reply.ok) throw await faultOf(reply);
            state.notices.solved(aboutFile);
            return await reply.blob();
        } catch (error) {
            if (!signal.aborted) state.notices.tell(aboutFile, error);
            return null;
        }
    }

    private timeInData(): number {
        const { state } = this.options;
        const times = state.times.value;
        const [first, last] = [times[0] ?? 0, times.at(-1) ?? 0];
        // A flow that stands still is the same at all times.
        return state.dataset.value?.steady === true ? first : Math.min(last, Math.max(first, this.time()));
    }

    private time(): number {
        const time = this.options.time();
        return Number.isFinite(time) ? time : (this.options.state.times.value[0] ?? 0);
    }

    private forget(): void {
        const { scene, state } = this.options;
        this.answered.value = '';
        this.extent.value = null;
        scene.body.setValues(null, false);
        state.notices.solved(about);
    }

    private async ask(): Promise<void> {
        if (this.asking) return;
        this.asking = true;
        const { state, worker, scene, view } = this.options;
        for (let wish = this.next(); wish !== null; wish = this.next()) {
            const { dataset, lattice } = state.dataset.value!;
            let failure: unknown = null;
            this.ended = new AbortController();
            // Asked for again, what is wanted by then.
            const ask = (): Promise<BodyValues | null> => {
                wish = this.next() ?? wish!;
                return worker.bodyValues(dataset, lattice, wish.time, wish.field, wish.allPatches);
            };
            const values = await this.waits.until(ask, this.ended.signal).catch((error: unknown) => {
                failure = error ?? new Error('The values along the body could not be loaded.');
                return null;
            });
            // Switched off, or another dataset, meanwhile.
            if (this.wish.value === null || state.dataset.value?.dataset !== dataset) continue;
            if (failure === null) {
                this.show(values, dataset, wish.field);
                scene.body.setValues(values, view.body.value.texture);
                state.notices.solved(about);
            } else state.notices.tell(about, failure);
            this.failed.value = failure !== null;
            this.answered.value = wish.key;
        }
        this.asking = false;
    }

    private show(values: BodyValues | null, dataset: string, field: string): void {
        const extent = values?.field === null || values === null ? null : extentOf(values.field);
        const before = this.extent.value;
        const same = before?.field === field && before.dataset === dataset;
        this.extent.value = extent === null ? null : { ...(same ? widened(before, extent) : extent), dataset, field };
    }

    private next(): Wish | null {
        const wish = this.wish.value;
        return wish === null || wish.key === this.answered.value || this.options.state.stage.value !== 'running' ? null : wish;
    }
}

/** Null without a value. */
export function extentOf(values: Float32Array): BodyExtent | null {
    const known = values.filter((value) => Number.isFinite(value)).sort();
    if (known.length === 0) return null;
    const at = (part: number): number => known[Math.round(part * (known.length - 1))]!;
    return { least: at(0), greatest: at(1), most: [at(0.01), at(0.99)] };
}

/** As those of slices, colours must not flicker while the time moves. */
function widened(a: BodyExtent, b: BodyExtent): BodyExtent {
    return {
        least: Math.min(a.least, b.least),
        greatest: Math.max(a.greatest, b.greatest),
        most: [Math.min(a.most[0], b.most[0]), Math.max(a.most[1], b.most[1])],
    };
}

/** All values; without the last hundredth at each end where those take more than half of the range: at edges of bodies a few are far
 *  larger than all others. */
function mostOf({ least, greatest, most: [low, high] }: BodyExtent): readonly [number, number] {
    return greatest - least > 2 * (high - low) && high > low ? [low, high] : [least, greatest];
}
