import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { answering } from '../../testing/answering.ts';
import { SurfaceProgress } from './surfaceProgress.ts';

interface Asked {
    method: string;
    params: Record<string, unknown>;
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
        progress.progressed('someone else’s', 0.9, '');
        progress.progressed(String(asked[0]!.params['workDoneToken']), 0.25, 'refining');
        expect(state.progress.value).toEqual({ surface: 's1', fraction: 0.25, message: 'refining' });
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
        progress.progressed(former, 0.5, '');
        expect(state.progress.value).toEqual({ surface: 's1', fraction: null, message: '' });
    });
});
