import { signal } from '@preact/signals-core';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { SurfaceRecord, SurfaceStats } from '../../protocol/messages.ts';
import { AppState, type DisplayedSurface, type Stage, type SurfaceStatus } from '../../state/appState.ts';
import { answering } from '../../testing/fakes.ts';
import { datasetOf, displayedOf, sampleStatistics, surfaceOf } from '../../testing/records.ts';
import { intentOf } from '../edits/surfaceIntent.ts';
import { faster, progressWords, type ReportedProgress, SurfaceOutcomes, SurfaceProgress, untilHere } from './surfaceProgress.ts';

interface Asked {
    method: string;
    params: Record<string, unknown>;
}

function progressOf(change: Partial<ReportedProgress>): ReportedProgress {
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
        progress.progressed('someone else’s', progressOf({ fraction: 0.9 }));
        const news = progressOf({ fraction: 0.25, message: 'refining', time: 3, quads: 1200, remaining: 8 });
        progress.progressed(String(asked[0]!.params['workDoneToken']), news);
        const { seconds: _seconds, ...status } = news;
        expect(state.progress.value).toEqual({ surface: 's1', ...status, lasting: 'briefly' });
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
        progress.progressed(former, progressOf({ fraction: 0.5 }));
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
        progress.progressed(token, progressOf({ seconds: 4 }));
        expect(state.progress.value?.lasting).toBe('a while');
        progress.progressed(token, progressOf({ seconds: 61 }));
        expect(state.progress.value?.lasting).toBe('long');
    });
});

const view = { units: { value: { length: 'm', time: 's', speed: '' } } } as unknown as Parameters<typeof progressWords>[2];
const status: SurfaceStatus = {
    ...{ surface: 's', fraction: 0.427, message: '', lasting: 'a while' },
    ...{ time: 8.2, quads: 12_345, remaining: 8.4 },
};

function longPassBench(change: Parameters<typeof surfaceOf>[1] = {}) {
    const record = surfaceOf('s', { kind: 'streak', from: 0, to: 19.2, separation: 0.1, ...change });
    const state = new AppState();
    state.dataset.value = datasetOf({ times: [0, 9.6, 19.2] });
    state.surfaces.value = new Map([['s', record]]);
    return { state, intent: intentOf(record) };
}

describe('progressWords', () => {
    it('tells the simulation time, the quads and the seconds left', () => {
        const { state } = longPassBench();
        expect(progressWords(status, state, view)).toBe('t = 8.2 of 19.2 s, 12\u202f345 quads, about 8 s left');
    });

    it('tells the part where a surface is not moved in time, and nothing that is not known', () => {
        const { state } = longPassBench({ kind: 'stream' });
        expect(progressWords({ ...status, time: null, remaining: null }, state, view)).toBe('42 %, 12\u202f345 quads');
        const unknown = { ...status, fraction: null, time: null, quads: null, remaining: 200 };
        expect(progressWords(unknown, state, view)).toBe('about 3 min left');
    });
});

describe('what one can have instead', () => {
    it('is Fast first, and half as many lines where it is fast already', () => {
        const { intent } = longPassBench({ accuracy: 'balanced' });
        expect(faster(intent, view)).toEqual([
            { change: { accuracy: 'fast' }, words: 'Fast accuracy' },
            { change: { separation: 0.2 }, words: 'Separation 0.2 m' },
        ]);
        expect(faster({ ...intent, accuracy: 'fast' }, view).map(({ change }) => change)).toEqual([{ separation: 0.2 }]);
    });

    it('ends where the work has come to, whichever way time runs, and never later', () => {
        const { intent } = longPassBench();
        const reached = { ...status, time: 8.123_456 };
        expect(untilHere(intent, reached, view)).toMatchObject({ words: 'Until t = 8.12 s' });
        expect(untilHere(intent, reached, view)!.change.length).toBeCloseTo(8.12);
        const backward = longPassBench({ from: 19.2, to: 0, direction: 'backward' }).intent;
        const there = untilHere(backward, { ...status, time: 11.075 }, view)!;
        expect(there.change.length).toBeCloseTo(8.12);
        expect(there.words).toBe('Until t = 11.08 s');
    });

    it('is no end where there is none: nothing reached, all of it, or no time to speak of', () => {
        const { intent } = longPassBench();
        for (const time of [null, 0, 19.2]) expect(untilHere(intent, { ...status, time }, view)).toBeNull();
    });
});

describe('the outcome of a surface', () => {
    function displayed(stateSum: number, phase: DisplayedSurface['phase'] = 'final'): ReadonlyMap<string, DisplayedSurface> {
        return new Map([['s1', displayedOf('s1', { stateSum, phase })]]);
    }

    function bench() {
        const asked: string[] = [];
        let answer: SurfaceStats | Error = sampleStatistics({ stateSum: 7, coarsened: true });
        const state = {
            displayed: signal(displayed(7, 'coarse')),
            outcomes: signal<ReadonlyMap<string, SurfaceStats>>(new Map()),
            stage: signal<Stage>('running'),
            surfaces: signal<ReadonlyMap<string, SurfaceRecord>>(new Map([['s1', {} as SurfaceRecord]])),
        };
        const worker = {
            call: (method: string) => {
                asked.push(method);
                return answer instanceof Error ? Promise.reject(answer) : Promise.resolve(answer);
            },
        } as unknown as ConstructorParameters<typeof SurfaceOutcomes>[0]['worker'];
        const outcomes = new SurfaceOutcomes({ state, worker });
        return { state, asked, outcomes, answers: (next: SurfaceStats | Error) => (answer = next) };
    }

    it('is asked for once where a page shows what was finished before it came', async () => {
        const { state, asked } = bench();
        expect(asked).toEqual([]);
        state.displayed.value = displayed(7);
        await Promise.resolve();
        state.displayed.value = displayed(7);
        expect(asked).toEqual(['surface.stats']);
        expect(state.outcomes.value.get('s1')?.coarsened).toBe(true);
    });

    it('is not asked for where the server has told it', () => {
        const { state, asked, outcomes } = bench();
        outcomes.done(sampleStatistics({ stateSum: 9 }));
        state.displayed.value = displayed(9);
        expect(asked).toEqual([]);
    });

    it('goes with the surface, and does not come back with a late answer', async () => {
        const { state, outcomes } = bench();
        state.displayed.value = displayed(7);
        await Promise.resolve();
        expect([...state.outcomes.value.keys()]).toEqual(['s1']);
        state.surfaces.value = new Map();
        expect(state.outcomes.value.size).toBe(0);
        outcomes.done(sampleStatistics({ stateSum: 9 }));
        expect(state.outcomes.value.size).toBe(0);
    });

    it('is asked for again after a failure', async () => {
        const { state, asked, answers } = bench();
        answers(new Error('the connection was lost'));
        state.displayed.value = displayed(7);
        await new Promise((done) => setTimeout(done));
        state.displayed.value = displayed(7);
        expect(asked).toEqual(['surface.stats', 'surface.stats']);
    });
});
