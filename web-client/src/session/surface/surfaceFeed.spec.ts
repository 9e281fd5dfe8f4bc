import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { LatencyLog } from '../../state/latency.ts';
import { answering } from '../../testing/fakes.ts';
import { surfaceOf } from '../../testing/records.ts';
import type { SurfaceState } from '../../worker/workerMessages.ts';
import { SurfaceFeed } from './surfaceFeed.ts';

function stateOfEpoch(epoch: number, change: Partial<SurfaceState> = {}): SurfaceState {
    return {
        ...{
            surface: 's1',
            epoch,
            phase: 'final',
            time: 0,
            stateSum: epoch,
            cells: 1,
            vertices: 4,
            meshVertices: 4,
            triangles: 2,
        },
        ...{ keys: 1, deltas: 0, withheld: [], curved: false, decodeMs: 2 },
        ...{ fromVertex: 0, positions: new Float32Array(12), normals: new Float32Array(12) },
        ...{
            fromNormal: 0,
            fromSeed: 0,
            tFrom: 0,
            seeds: new Float32Array(8),
            scalars: [],
            parts: null,
            cut: null,
            units: null,
            unresolved: null,
        },
        ...{ fromIndex: 0, indices: new Uint32Array(6) },
        ...change,
    };
}

class Bench {
    state = new AppState();
    calls: string[] = [];
    shown: number[] = [];
    taken = 0;
    resumed = false;
    stats: unknown = {};
    feed: SurfaceFeed;

    constructor() {
        const worker = {
            ...answering((method) => {
                if (method === 'surface.stats') return this.stats;
                this.calls.push(method);
                return { subscription: 7, resumed: this.resumed };
            }),
            taken: () => ++this.taken,
            forget: (surface: string) => this.calls.push(`forget ${surface}`),
        };
        const scene = {
            loop: { request: () => undefined },
            setSurface: (_: string, change: SurfaceState) => this.shown.push(change.epoch),
            whenDrawn: () => undefined,
            removeSurface: (surface: string) => this.calls.push(`remove ${surface}`),
        };
        const parts = { state: this.state, latency: new LatencyLog(), worker, scene };
        this.feed = new SurfaceFeed(parts);
    }
}

describe('SurfaceFeed', () => {
    beforeEach(() => {
        vi.useFakeTimers();
    });
    afterEach(() => {
        vi.useRealTimers();
    });

    it('says why there is no surface where that was told before the page came, until it is computed', async () => {
        const bench = new Bench();
        const { state, feed } = bench;
        state.stage.value = 'running';
        state.surfaces.value = new Map([['s1', surfaceOf('s1')]]);
        state.activeSurface.value = 's1';
        const error = { code: -32800, message: 'the server died 3 times in a row', kind: 'cancelled', hint: 'set a surface' };
        bench.stats = { surface: 's1', epoch: 4, error };
        await feed.subscribe('s1');
        await vi.advanceTimersByTimeAsync(0);
        expect(state.phase.value).toBe('stopped');
        expect(state.surfaceErrors.value.get('s1')).toEqual({ epoch: 4, text: error.message, stopped: true });
        feed.requested('s1', 5);
        expect(state.phase.value).toBe('none');
    });

    it('ends the subscription of a surface that is hidden, and begins another when it is shown', async () => {
        const bench = new Bench();
        bench.state.stage.value = 'running';
        bench.state.surfaces.value = new Map([['s1', surfaceOf('s1')]]);
        await bench.feed.subscribe('s1');
        bench.feed.receive(stateOfEpoch(3));
        bench.feed.apply();
        bench.calls.length = 0;
        bench.state.hiddenSurfaces.value = new Set(['s1']);
        expect(bench.calls).toEqual(['forget s1', 'remove s1', 'surface.unsubscribe']);
        expect(bench.state.displayed.value.size).toBe(0);
        bench.feed.receive(stateOfEpoch(4));
        bench.feed.apply();
        expect(bench.shown).toEqual([3]);
        bench.calls.length = 0;
        bench.state.hiddenSurfaces.value = new Set();
        expect(bench.calls).toEqual(['surface.subscribe']);
        bench.feed.receive(stateOfEpoch(5));
        bench.feed.apply();
        expect(bench.shown).toEqual([3, 5]);
    });

    it('subscribes to nothing that is hidden, and ends what was agreed while it was being hidden', async () => {
        const bench = new Bench();
        bench.state.hiddenSurfaces.value = new Set(['s1']);
        await bench.feed.subscribe('s1');
        expect(bench.calls).toEqual([]);
        const asked = bench.feed.subscribe('s2');
        bench.state.hiddenSurfaces.value = new Set(['s1', 's2']);
        await asked;
        expect(bench.calls.at(-1)).toBe('surface.unsubscribe');
    });

    it('shows only the newest whole state of a frame, and takes every one', async () => {
        const bench = new Bench();
        await bench.feed.subscribe('s1');
        bench.feed.receive(stateOfEpoch(3));
        bench.feed.receive(stateOfEpoch(4, { phase: 'coarse' }));
        bench.feed.receive(stateOfEpoch(5));
        bench.feed.apply();
        bench.feed.apply();
        expect(bench.shown).toEqual([5]);
        expect(bench.taken).toBe(3);
        expect(bench.state.displayed.value.get('s1')).toMatchObject({ epoch: 5, phase: 'final' });
    });

    it('shows every state that builds on the one before, in order', async () => {
        const bench = new Bench();
        await bench.feed.subscribe('s1');
        bench.feed.receive(stateOfEpoch(3));
        bench.feed.receive(stateOfEpoch(4, { fromVertex: 2, fromIndex: 3 }));
        bench.feed.receive(stateOfEpoch(5, { fromIndex: 3 }));
        bench.feed.apply();
        expect(bench.shown).toEqual([3, 4, 5]);
        expect(bench.taken).toBe(3);
    });

    it('does not leave the worker waiting for a surface that is gone', () => {
        const bench = new Bench();
        bench.feed.receive(stateOfEpoch(1));
        bench.feed.apply();
        expect([bench.shown, bench.taken]).toEqual([[], 1]);
    });

    it('calls what is on the screen the surface only where the server goes on with it', async () => {
        const bench = new Bench();
        await bench.feed.subscribe('s1');
        bench.feed.receive(stateOfEpoch(3));
        bench.feed.apply();
        bench.state.surfaces.value = new Map([['s1', surfaceOf('s1')]]);
        for (const resumed of [true, false]) {
            bench.resumed = resumed;
            bench.feed.reset();
            await bench.feed.subscribe('s1');
            expect(bench.state.displayed.value.has('s1')).toBe(resumed);
        }
        expect(bench.calls).not.toContain('remove s1');
        bench.state.surfaces.value = new Map();
        bench.feed.reset();
        expect(bench.calls).toEqual(expect.arrayContaining(['remove s1', 'forget s1']));
    });

    it('asks again after damaged frames, ever later, and gives up with a reason', async () => {
        const bench = new Bench();
        await bench.feed.subscribe('s1');
        for (let i = 0; i < 10; ++i) {
            void bench.feed.troubled('s1', 7, 'bad frame');
            await vi.advanceTimersByTimeAsync(499);
            expect(bench.calls.filter((call) => call === 'surface.unsubscribe').length).toBe(Math.min(i, 4));
            await vi.advanceTimersByTimeAsync(60_000);
        }
        expect(bench.calls.filter((call) => call === 'surface.subscribe')).toHaveLength(5);
        expect(bench.state.notices.all.value.get('surface s1')).toMatch(/bad frame/);
    });

    it('forgets earlier damage once a state has arrived whole', async () => {
        const bench = new Bench();
        await bench.feed.subscribe('s1');
        for (let i = 0; i < 10; ++i) {
            void bench.feed.troubled('s1', 7, 'bad frame');
            await vi.advanceTimersByTimeAsync(600);
            bench.feed.receive(stateOfEpoch(i + 1));
        }
        expect(bench.calls.filter((call) => call === 'surface.subscribe')).toHaveLength(11);
        expect(bench.state.notices.all.value.size).toBe(0);
    });
});
