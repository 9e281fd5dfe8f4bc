// The page's session without picture and network, for tests of panels: the server keeps what it is asked for and answers with it; for tests
// of edits it answers when the test lets it. The data are like those of the bundled flow.
import type { MethodName, Patch, RakeRecord, SurfaceKind, SurfaceRecord, Vec3 } from '../protocol/messages.ts';
import { Calls } from '../session/base/calls.ts';
import { Edits } from '../session/edits/edits.ts';
import { adoptSnapshot, applyPatches } from '../session/recordMirror.ts';
import { Families } from '../session/surface/families.ts';
import { ClockControl } from '../session/time/clockControl.ts';
import { chooseKind } from '../session/time/kindChoice.ts';
import { Playback } from '../session/time/playback.ts';
import { AppState, withEntry } from '../state/appState.ts';
import { LatencyLog } from '../state/latency.ts';
import { ViewState } from '../state/viewState.ts';
import { answering, FakeClock, type Params, settled } from './fakes.ts';
import { datasetOf, displayedOf, emptySnapshot, fieldOf, rakeOf, surfaceOf } from './records.ts';

const spacing = 0.1675;
const points: [Vec3, Vec3] = [
    [-1.48, 0.204, 0.176],
    [-1.48, 0.204, 5.696],
];

export class PageBench {
    readonly state = new AppState();
    readonly view = new ViewState();
    readonly calls: Call[] = [];
    /** What the server says to a method instead, or throws. */
    readonly answers: Partial<Record<MethodName, (params: Params) => unknown>> = {};
    readonly worker = answering((method, params) => this.answer(method, params));
    readonly edits: Edits;
    readonly clock: ClockControl;
    readonly playback: Playback;
    readonly families: Families;
    readonly tries: Calls;
    readonly time = new FakeClock();
    /** A handle is held. */
    dragging = false;
    readonly chooseKind = (kind: SurfaceKind): void => chooseKind(this, kind);

    constructor() {
        const { state, worker } = this;
        const requestFrame = (): void => queueMicrotask(() => this.frame());
        this.edits = new Edits({ state, worker, requestFrame, latency: new LatencyLog(), dragging: () => this.dragging });
        this.clock = new ClockControl({ state, worker, requestFrame });
        this.playback = new Playback({ state, edits: this.edits, clock: this.clock, time: this.time });
        const { edits, clock, playback } = this;
        this.families = new Families({ state, worker, edits, clock, time: () => playback.time.value });
        this.tries = new Calls(state, worker, { begin: () => 'act', taken: () => undefined });
        state.stage.value = 'running';
        state.session.value = 'session';
        state.capabilities.value = ['stream', 'path', 'streak', 'time', 'level', 'stop', 'lease'];
        const times = Array.from({ length: 16 }, (_, i) => 8.5 + i / 2);
        const bounds: [number, number, number, number, number, number] = [-3, 12.92, -4, 3.92, 0, 5.87];
        const fields = [fieldOf('U', { components: 3, range: [0.002, 1.79] })];
        state.dataset.value = datasetOf({ times, bounds, fields, finestSpacing: spacing, obstacle: true });
        const moving = { from: 8.5, to: 16, separation: spacing };
        state.suggestion.value = {
            ...{ dataset: 'flow', why: 'The rake is ahead of a body.', rake: { kind: 'line', points, seeds: 32 } },
            surfaces: [
                { kind: 'stream', from: 16, to: 36, separation: spacing },
                { kind: 'path', ...moving },
                { kind: 'streak', ...moving },
                { kind: 'time', ...moving, from: 9, sweep: [0, -0.947, 0] },
            ],
        };
        adoptSnapshot(state, emptySnapshot('session'));
        const rake = rakeOf('rake-1', { name: 'Rake 1', points, seeds: 32 });
        const surface = surfaceOf('surface-1', { rake: 'rake-1', from: 16, to: 36, separation: spacing });
        this.tell([put('rake', 'rake-1', rake), put('surface', 'surface-1', surface)]);
    }

    get surfaces(): SurfaceRecord[] {
        return [...this.state.surfaces.value.values()];
    }

    get rakes(): RakeRecord[] {
        return [...this.state.rakes.value.values()];
    }

    /** The parameters of the calls of a method. */
    asked(method: MethodName): Params[] {
        return this.calls.filter(([name]) => name === method).map(([, params]) => params);
    }

    /** Tells patches, as the server does when a user has changed records. */
    tell(patches: readonly Patch[]): void {
        for (const { surface, epoch } of applyPatches(this.state, patches).requested) {
            const { requestedEpochs, displayed } = this.state;
            requestedEpochs.value = withEntry(requestedEpochs.value, surface, epoch);
            // It is computed in no time, to the end of its time.
            const time = Math.max(this.state.surfaces.value.get(surface)?.to ?? 0, 0);
            displayed.value = withEntry(displayed.value, surface, displayedOf(surface, { epoch, time }));
        }
        this.edits.recordsChanged();
    }

    private frame(): void {
        this.edits.flush();
        this.clock.flush();
    }

    private answer(method: MethodName, params: Params): unknown {
        this.calls.push([method, params]);
        const other = this.answers[method];
        return other === undefined ? this.keep(method, params) : other(params);
    }

    /** The records as the server would have them after the call. */
    private keep(method: MethodName, { gesture: _, ...params }: Params): unknown {
        const { state } = this;
        if (method === 'surface.set') {
            const id = (params['surface'] as string | undefined) ?? `surface-${state.surfaces.value.size + 1}`;
            const { rev = 0, epoch = 0 } = state.surfaces.value.get(id) ?? {};
            const record = surfaceOf(id, { ...params, rev: rev + 1, epoch: epoch + 1 });
            if (record.kind === 'level') delete record.rake;
            this.tell([put('surface', id, record)]);
            return record;
        }
        if (method === 'rake.set') {
            const id = (params['rake'] as string | undefined) ?? `rake-${state.rakes.value.size + 1}`;
            const before = state.rakes.value.get(id);
            const record = rakeOf(id, { ...before, ...params, rev: (before?.rev ?? 0) + 1 });
            this.tell([put('rake', id, record)]);
            return { ...record, surfaces: [], skipped: [] };
        }
        if (method === 'surface.delete' || method === 'rake.delete') {
            const type = method === 'surface.delete' ? 'surface' : 'rake';
            this.tell([{ op: 'delete', type, id: String(params[type]) }]);
        } else if (method.startsWith('time.')) {
            const change = method === 'time.set' ? { playing: false, ...params } : { ...params, playing: method === 'time.play' };
            this.tell([put('clock', 'clock', { ...state.clock.value!, ...change })]);
        }
        return {};
    }
}

export function put(type: Patch['type'], id: string, record: object): Patch {
    return { op: 'put', type, id, record } as unknown as Patch;
}

export type Call = [method: string, params: Record<string, unknown>];

export class Bench {
    state = new AppState();
    calls: Call[] = [];
    waiting: { resolve: (result: unknown) => void; reject: (error: Error) => void }[] = [];
    held = false;
    edits: Edits;

    constructor() {
        const worker = answering((...call) => {
            this.calls.push([call[0], call[1]]);
            return new Promise((resolve, reject) => this.waiting.push({ resolve, reject }));
        });
        const options = { state: this.state, worker, latency: new LatencyLog(), requestFrame: () => undefined };
        this.edits = new Edits({ ...options, dragging: () => this.held });
        this.state.capabilities.value = ['lease'];
        this.state.dataset.value = datasetOf({ bounds: [-1e3, 1e3, -1e3, 1e3, -1e3, 1e3] });
        this.records([rakeOf('r1'), rakeOf('r2')], [surfaceOf('s1', { rake: 'r1' }), surfaceOf('s2', { rake: 'r2' })]);
    }

    records(rakes: RakeRecord[], surfaces = [...this.state.surfaces.value.values()]): void {
        this.state.rakes.value = new Map(rakes.map((each) => [each.rake, each]));
        this.state.surfaces.value = new Map(surfaces.map((each) => [each.surface, each]));
        this.edits.recordsChanged();
    }

    drag(x: number, dragging = true): void {
        this.held = dragging;
        const shape = {
            kind: 'line',
            points: [
                [x, 0, 0],
                [0, 0, 1],
            ] as Vec3[],
        } as const;
        this.edits.moveRake({ shape, dragging, movedAt: 1000 + x });
    }

    async answer(rev = 2, rest: object = {}): Promise<void> {
        this.waiting.shift()?.resolve({ rake: 'r1', rev, clipped: false, points: [], surfaces: [], skipped: [], ...rest });
        for (let i = 0; i < 6; ++i) await settled();
    }

    async refuse(error: Error): Promise<void> {
        this.waiting.shift()?.reject(error);
        for (let i = 0; i < 6; ++i) await settled();
    }

    /** Returns what the problems that are told are about. */
    get told(): string[] {
        return [...this.state.problems.all.value.keys()];
    }

    get sent(): unknown[] {
        return this.calls.map(([, params]) => (params['points'] as Vec3[] | undefined)?.[0]?.[0] ?? params);
    }
}
