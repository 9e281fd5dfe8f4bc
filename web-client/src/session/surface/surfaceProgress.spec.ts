import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { answering } from '../../testing/fakes.ts';
import { SurfaceProgress, type ToldProgress } from './surfaceProgress.ts';

interface Asked {
    method: string;
    params: Record<string, unknown>;
}

function told(change: Partial<ToldProgress>): ToldProgress {
    return { fraction: null, message: '', time: null, quads: null, remaining: null, seconds: null, ...change };
}

function bench() {
    const state = new AppState();
    state.stage.value = 'running';
    state.activeSurface.value = 's1';
    const asked: Asked[] = [];
    const answers: (() => void)[] = [];
    const worker = answering((method, params) => {
        asked.push({ method, params });
        return new Promise((resolve) => answers.push(() => resolve({})));
    });
    const calls = { try: worker.call };
    return { state, asked, answers, progress: new SurfaceProgress({ state, worker, calls }) };
}

describe('SurfaceProgress', () => {
    beforeEach(() => void vi.useFakeTimers());
    afterEach(() => void vi.useRealTimers());

    it('says nothing of what is quickly done', () => {
        const { state, asked } = bench();
        vi.advanceTimersByTime(400);
        state.stage.value = 'starting';
        vi.advanceTimersByTime(1000);
        expect(asked).toEqual([]);
        expect(state.progress.value).toBeNull();
    });

    it('follows what takes longer until it is done, and stops it', async () => {
        const { state, asked, answers, progress } = bench();
        state.requestedEpochs.value = new Map([['s1', 4]]);
        vi.advanceTimersByTime(300);
        // What others do with other surfaces is no new beginning.
        state.requestedEpochs.value = new Map([
            ['s1', 4],
            ['s2', 9],
        ]);
        vi.advanceTimersByTime(300);
        expect(asked).toMatchObject([{ method: 'surface.wait', params: { surface: 's1', epoch: 4 } }]);
        progress.progressed('someone else’s', told({ fraction: 0.9 }));
        const news = told({ fraction: 0.25, message: 'refining', time: 3, quads: 1200, remaining: 8 });
        progress.progressed(String(asked[0]!.params['workDoneToken']), news);
        const { seconds: _seconds, ...standing } = news;
        expect(state.progress.value).toEqual({ surface: 's1', ...standing, lasting: 'briefly' });
        void progress.stop();
        expect(asked[1]).toMatchObject({ method: 'surface.stop', params: { surface: 's1' } });
        answers[0]!();
        await vi.advanceTimersByTimeAsync(0);
        expect(state.progress.value).toBeNull();
    });

    it('starts again with every edit', () => {
        const { state, asked, progress } = bench();
        vi.advanceTimersByTime(600);
        const former = String(asked[0]!.params['workDoneToken']);
        state.requestedEpochs.value = new Map([['s1', 5]]);
        expect(state.progress.value).toBeNull();
        vi.advanceTimersByTime(600);
        progress.progressed(former, told({ fraction: 0.5 }));
        expect(state.progress.value).toMatchObject({ surface: 's1', fraction: null, message: '' });
    });

    it('knows that people have waited for a while after 3 s, and for long after 10', () => {
        const { state } = bench();
        const lasting: (string | undefined)[] = [];
        for (const ms of [600, 2300, 200, 6800, 200]) {
            vi.advanceTimersByTime(ms);
            lasting.push(state.progress.value?.lasting);
        }
        expect(lasting).toEqual(['briefly', 'briefly', 'a while', 'a while', 'long']);
        state.requestedEpochs.value = new Map([['s1', 5]]);
        vi.advanceTimersByTime(600);
        expect(state.progress.value?.lasting).toBe('briefly');
    });

    it('hears from the server that it has been at work before this page came', () => {
        const { state, asked, progress } = bench();
        vi.advanceTimersByTime(600);
        const token = String(asked[0]!.params['workDoneToken']);
        progress.progressed(token, told({ seconds: 4 }));
        expect(state.progress.value?.lasting).toBe('a while');
        progress.progressed(token, told({ seconds: 61 }));
        expect(state.progress.value?.lasting).toBe('long');
    });
});
