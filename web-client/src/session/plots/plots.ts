// The plot below the picture: what it shows follows the rake, the measured line, the probe and the clock. Of what changes while the server
// samples, the newest is asked for next. Loaded when the first plot is opened.
import { computed, effect, signal, untracked } from '@preact/signals-core';
import type { DatasetDescription, Vec3 } from '../../protocol/messages.ts';
import { centreOf } from '../../scene/domain/domainAxes.ts';
import { curveOf } from '../../scene/rake/rakeShape.ts';
import type { AppState } from '../../state/appState.ts';
import type { PlotOf, ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { CallError } from '../../worker/workerClient.ts';
import { LateWaits } from '../base/lateWaits.ts';
import type { MeshDownload } from '../out/meshDownload.ts';
import { ownerName } from '../picture/surfaceOwner.ts';
import { attributeOf } from '../picture/surfaceStyleOf.ts';
import { coordinateText, timeWords } from '../picture/writtenNumbers.ts';
import { averagedFields, type NumberTable, readNumbers } from '../surface/numberTable.ts';
import { dataTime } from '../time/timeSteps.ts';
import type { Plot } from './plot.ts';
import { type PointsAlong, pointsAlong } from './plotLine.ts';
import { type Quantity, quantitiesOf } from './quantities.ts';
import { History, type HistoryWish, type Sample, sampleLine } from './sampling.ts';
import { plotOfNumbers, quantitiesIn } from './surfaceNumbers.ts';

export interface PlotsOptions {
    state: AppState;
    view: ViewState;
    worker: Pick<WorkerClient, 'call'>;
    mesh: Pick<MeshDownload, 'numbers'>;
    /** Returns the time of the picture; no number where nothing has one. */
    time: () => number;
}

/** Along a line. */
const pointCount = 401;
/** Rows of the numbers of a surface. */
const numberTimes = 50;
/** As many lines can be told from each other. */
export const mostSeries = 6;
const drawEveryMs = 100;

const oneTime = 'These data have one time: there is nothing to plot over time.';

export class Plots {
    readonly plot = signal<Plot | null>(null);
    /** Why there is none. */
    readonly fault = signal('');
    /** The part that is there; null: nothing is awaited. */
    readonly progress = signal<number | null>(null);
    /** The server has not answered for long. */
    readonly late = signal(false);
    /** Names of the quantities that are drawn, of the data and of surfaces. */
    readonly chosen = signal<{ data: readonly string[]; surface: readonly string[] }>({ data: [], surface: ['area'] });
    private readonly options: PlotsOptions;
    private readonly waits = new LateWaits((late) => (this.late.value = late));
    private readonly table = signal<{ of: string; table: NumberTable } | null>(null);
    private of: PlotOf | null = null;
    private asked = '';
    private abort = new AbortController();
    /** Of a line: one request at a time, the newest next. */
    private sampling = false;
    private next: (() => Promise<void>) | null = null;
    private history = { of: '', values: new History() };

    constructor(options: PlotsOptions) {
        this.options = options;
        effect(() => this.follow());
    }

    /** What can be chosen. */
    readonly quantities = computed((): readonly Quantity[] => {
        if (this.options.view.plot.value === 'surface') {
            const table = this.table.value?.table;
            return table === undefined ? [] : quantitiesIn(table);
        }
        const dataset = this.options.state.dataset.value;
        return dataset === null ? [] : quantitiesOf(dataset);
    });

    /** Those that are drawn, in the order in which they were chosen, so that a line keeps its colour; else what the surface is coloured by. */
    readonly drawn = computed((): readonly Quantity[] => {
        const all = this.quantities.value;
        const names = this.chosen.value[this.options.view.plot.value === 'surface' ? 'surface' : 'data'];
        const found = names.map((name) => all.find((each) => each.name === name)).filter((each) => each !== undefined);
        if (found.length > 0) return found;
        const { state, view } = this.options;
        const surface = state.activeSurface.value;
        const coloured = surface === null ? null : attributeOf(view.lookOf(surface).colourBy);
        const first = all.find(({ name }) => name === coloured) ?? all[0];
        return first === undefined ? [] : [first];
    });

    choose(name: string, on: boolean): void {
        const names = this.drawn.value.map((each) => each.name).filter((each) => each !== name);
        const chosen = on ? [...names, name].slice(0, mostSeries) : names;
        if (chosen.length === 0) return;
        const kind = this.options.view.plot.value === 'surface' ? 'surface' : 'data';
        this.chosen.value = { ...this.chosen.value, [kind]: chosen };
    }

    close(): void {
        this.point(null);
        this.options.view.plot.value = null;
    }

    /** The time of the picture where the plot is over time; null: it is not. */
    get clock(): number | null {
        const of = this.options.view.plot.value;
        const time = this.options.time();
        const overTime = of === 'point' || (of === 'surface' && this.plot.value?.x.name === 'time');
        return overTime && Number.isFinite(time) ? time : null;
    }

    private follow(): void {
        const { state, view } = this.options;
        const of = view.plot.value;
        const dataset = state.dataset.value;
        if (of !== this.of) {
            this.of = of;
            this.begin('');
            this.show(null, '');
            untracked(() => this.place());
        }
        if (of === null || dataset === null || state.stage.value !== 'running') return;
        if (of === 'surface') this.followSurface();
        else if (of === 'point') this.followPoint(dataset);
        else this.followLine(of, dataset);
    }

    /** Where no place has been chosen, one that shows something. */
    private place(): void {
        const { state, view } = this.options;
        const bounds = state.dataset.value?.bounds;
        if (bounds === undefined) return;
        const centre = centreOf(bounds);
        if (this.of === 'point') view.probeHeld.value ??= view.probePlace.value ?? centre;
        if (this.of !== 'line' || view.measured.value.length > 0) return;
        view.measured.value = [
            [bounds[0], centre[1], centre[2]],
            [bounds[1], centre[1], centre[2]],
        ];
    }

    /** Tells the picture where the pointer is on the line; null: nowhere. */
    point(index: number | null): void {
        const { view } = this.options;
        const at = (name: string): number =>
            this.plot.value?.places.find((each) => each.name === name)?.values[index ?? -1] ?? Number.NaN;
        const place: Vec3 = [at('x'), at('y'), at('z')];
        view.plotPlace.value = place.some(Number.isNaN) ? null : place;
    }

    private followLine(of: 'rake' | 'line', dataset: DatasetDescription): void {
        const { state, view } = this.options;
        const curve = of === 'rake' ? curveOf(state.rakeShape.value) : view.measured.value;
        const line = pointsAlong(curve, pointCount);
        const time = dataTime(dataset, this.options.time()) ?? dataset.times[0] ?? 0;
        const quantities = this.drawn.value;
        const title = `${this.lineName(of, line)}, t = ${timeWords(state, view, time)}`;
        const key = JSON.stringify([of, curve, time, quantities, this.dataMark]);
        if (line.points.length === 0) {
            this.begin(key);
            this.show(
                null,
                of === 'rake' ? 'There is no rake.' : 'Choose Measure over the picture and click both ends, or type them here.',
            );
            return;
        }
        const [lengthUnit, timeUnit] = [view.units.value.length, view.units.value.time];
        const wish = { dataset, quantities, line, time, title, lengthUnit, timeUnit };
        if (key === this.asked) return;
        // A line that follows a drag is drawn as fast as it is sampled: the request under way is nearly here.
        this.asked = key;
        const { signal } = this.abort;
        this.next = async () => {
            try {
                const plot = await sampleLine(wish, this.sample, signal);
                if (!signal.aborted) this.show(plot, '');
            } catch (error) {
                this.failed(error, signal);
            }
        };
        untracked(() => void this.goOn());
    }

    private lineName(of: 'rake' | 'line', { points }: PointsAlong): string {
        const { state } = this.options;
        const words = (point: Vec3 | undefined): string =>
            point === undefined ? '' : `(${point.map((value, axis) => coordinateText(state, axis, value)).join(', ')})`;
        if (of === 'line') return `From ${words(points[0])} to ${words(points.at(-1))}`;
        return `Along ${state.rake.value?.name || 'the rake'}`;
    }

    /** What has not been answered for long is asked for again. */
    retry(): void {
        this.waits.again();
    }

    private readonly sample: Sample = (params, ended) =>
        this.waits.until((stop) => this.options.worker.call('probe.sample', params, stop), ended);

    private async goOn(): Promise<void> {
        if (this.sampling) return;
        this.sampling = true;
        while (this.next !== null) {
            const next = this.next;
            this.next = null;
            await next();
        }
        this.sampling = false;
    }

    private followPoint(dataset: DatasetDescription): void {
        const { state, view } = this.options;
        const point = view.probeHeld.value;
        const times = state.times.value;
        const quantities = this.drawn.value;
        const place = JSON.stringify([point, quantities, this.dataMark]);
        const key = `point ${place} ${times.length}`;
        if (key === this.asked) return;
        const signal = this.begin(key);
        if (dataset.steady || times.length < 2) return this.show(null, oneTime);
        if (point === null) return this.show(null, '');
        if (this.history.of !== place) this.history = { of: place, values: new History() };
        const title = `At (${point.map((value, axis) => coordinateText(state, axis, value)).join(', ')})`;
        const [lengthUnit, timeUnit] = [view.units.value.length, view.units.value.time];
        untracked(() => void this.overTime({ dataset, quantities, point, times, title, lengthUnit, timeUnit }, signal));
    }

    /** Draws what has come now and then. */
    private async overTime(wish: HistoryWish, signal: AbortSignal): Promise<void> {
        const { values } = this.history;
        let drawnAt = 0;
        const draw = (part: number): void => {
            if (signal.aborted || (part < 1 && performance.now() - drawnAt < drawEveryMs)) return;
            drawnAt = performance.now();
            this.show(values.plot(wish), '', part);
        };
        draw(0);
        try {
            await values.sample(wish, this.sample, signal, draw);
            if (!signal.aborted) this.show(values.plot(wish), '');
        } catch (error) {
            this.failed(error, signal);
        }
    }

    private followSurface(): void {
        const { state } = this.options;
        const record = state.surface.value;
        const displayed = state.displayed.value.get(record?.surface ?? '');
        const complete = state.phase.value === 'final' || state.phase.value === 'coarsened';
        const fields = record === undefined ? [] : averagedFields(state.dataset.value, record);
        const of = `surface ${record?.surface} ${record?.epoch} ${fields.join()}`;
        if (record === undefined) {
            this.begin(of);
            return this.show(null, 'There is no surface.');
        }
        const table = this.table.value;
        if (table?.of === of) {
            this.asked = of;
            const title = `The ${record.kind} surface of ${ownerName(state, record)}`;
            return this.show(plotOfNumbers(table.table, this.drawn.value, title), '');
        }
        if (!complete || displayed === undefined) return untracked(() => this.show(null, 'Once the surface is complete.'));
        if (of !== this.asked) untracked(() => void this.askNumbers(of, fields, this.begin(of)));
    }

    private async askNumbers(of: string, fields: readonly string[], signal: AbortSignal): Promise<void> {
        const { state, mesh } = this.options;
        const { from, to, surface } = state.surface.value!;
        if (!(Math.abs(to - from) > 0)) return this.show(null, 'This surface has one time: there is nothing to plot over time.');
        this.show(null, 'Being computed …');
        const times = `${from}:${to}:${Math.abs(to - from) / numberTimes}`;
        const query = { times, fields: fields.join('\n') };
        const session = state.session.value ?? '';
        const { text, fault } = await this.waits
            .until((stop) => mesh.numbers(session, surface, query, stop), signal)
            .catch(() => ({ text: null, fault: '' }));
        if (signal.aborted) return;
        if (text === null) this.show(null, fault);
        else this.table.value = { of, table: readNumbers(text) };
    }

    /** Values of another state of the data are others. */
    private get dataMark(): unknown {
        const { dataset, datasetEntry } = this.options.state;
        return [dataset.value?.dataset, datasetEntry.value?.values];
    }

    /** What was asked for before is no longer wanted. */
    private begin(key: string): AbortSignal {
        this.asked = key;
        this.abort.abort();
        this.abort = new AbortController();
        this.next = null;
        return this.abort.signal;
    }

    private show(plot: Plot | null, fault: string, progress: number | null = null): void {
        this.plot.value = plot;
        this.fault.value = fault;
        this.progress.value = progress;
    }

    private failed(error: unknown, signal: AbortSignal): void {
        if (signal.aborted) return;
        this.asked = '';
        this.show(null, error instanceof CallError ? error.message : String(error));
    }
}
