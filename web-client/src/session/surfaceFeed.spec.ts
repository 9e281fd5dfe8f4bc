import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { AppState } from '../state/appState.ts';
import { LatencyLog } from '../state/latency.ts';
import type { SurfaceState } from '../worker/workerMessages.ts';
import { SurfaceFeed, type SurfaceFeedOptions } from './surfaceFeed.ts';

function stateOfEpoch(epoch: number, final = true): SurfaceState {
    return {
        ...{ subscription: 7, epoch, final, stateCrc: epoch, vertices: 4, cells: 1, triangles: 2 },
        speedRange: [0, 1],
        positions: new Float32Array(12),
        normals: new Float32Array(12),
        scalars: new Float32Array(4),
        indices: new Uint32Array(6),
    };
}

class Bench {
    state = new AppState();
    calls: string[] = [];
    shown: number[] = [];
    feed: SurfaceFeed;

    constructor() {
        const worker = {
            call: (method: string) => {
                this.calls.push(method);
                return Promise.resolve({ subscription: 7 });
            },
        };
        const scene = {
            loop: { request: () => undefined },
            setSurface: (_: string, arrays: SurfaceState) => this.shown.push(arrays.epoch),
        };
        const parts = { state: this.state, latency: new LatencyLog(), worker, scene };
        this.feed = new SurfaceFeed(parts as unknown as SurfaceFeedOptions);
    }
}

describe('SurfaceFeed', () => {
    beforeEach(() => {
        vi.useFakeTimers();
    });
    afterEach(() => {
        vi.useRealTimers();
    });

    it('shows only the newest state of a frame, and nothing older afterwards', async () => {
        const bench = new Bench();
        await bench.feed.subscribe('s1');
        bench.feed.receive(stateOfEpoch(3));
        bench.feed.receive(stateOfEpoch(4, false));
        bench.feed.receive(stateOfEpoch(4));
        bench.feed.receive(stateOfEpoch(3));
        bench.feed.apply();
        bench.feed.receive(stateOfEpoch(2));
        bench.feed.apply();
        expect(bench.shown).toEqual([4]);
        expect(bench.state.displayed.value.get('s1')).toMatchObject({ epoch: 4, final: true });
    });

    it('asks again after damaged frames, ever later, and gives up with a reason', async () => {
        const bench = new Bench();
        await bench.feed.subscribe('s1');
        for (let i = 0; i < 10; ++i) {
            void bench.feed.troubled(7, 'bad frame');
            await vi.advanceTimersByTimeAsync(499);
            expect(bench.calls.filter((call) => call === 'surface.unsubscribe').length).toBe(
                Math.min(i, 4),
            );
            await vi.advanceTimersByTimeAsync(60_000);
        }
        expect(bench.calls.filter((call) => call === 'surface.subscribe')).toHaveLength(5);
        expect(bench.state.notice.value).toMatch(/bad frame/);
    });

    it('forgets earlier damage once a state has arrived whole', async () => {
        const bench = new Bench();
        await bench.feed.subscribe('s1');
        for (let i = 0; i < 10; ++i) {
            void bench.feed.troubled(7, 'bad frame');
            await vi.advanceTimersByTimeAsync(600);
            bench.feed.receive(stateOfEpoch(i + 1));
        }
        expect(bench.calls.filter((call) => call === 'surface.subscribe')).toHaveLength(11);
        expect(bench.state.notice.value).toBeNull();
    });
});
