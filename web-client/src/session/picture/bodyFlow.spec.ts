import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import type { DatasetDescription } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { datasetOf } from '../../testing/records.ts';
import { rested } from '../../testing/shownPanel.ts';
import { BodyFlow } from './bodyFlow.ts';

/** A server that answers when the test lets it. */
function bench(change: Partial<DatasetDescription> = {}) {
    const [state, view, time] = [new AppState(), new ViewState(), signal(1)];
    state.stage.value = 'running';
    state.dataset.value = datasetOf({ obstacle: true, times: [0, 5, 10], ...change });
    const asked: number[] = [];
    const waiting: { answer: () => void; fail: () => void }[] = [];
    const shown: (number | null)[] = [];
    const moved: (number | null)[] = [];
    const clock = signal(true);
    const bodyFlow = new BodyFlow({
        ...{ state, view, time: () => time.value, moves: () => clock.value },
        scene: {
            setBodyFlow: (flow) => void shown.push(flow?.[0] ?? null),
            setBodyTime: (by) => void moved.push(by),
        },
        worker: {
            obstacleFlow: (_dataset, _lattice, at) => {
                asked.push(at);
                return new Promise((resolve, reject) => {
                    waiting.push({ answer: () => resolve(Float32Array.of(at)), fail: () => reject(new Error('too busy')) });
                });
            },
        },
    });
    shown.length = 0;
    const answer = async (how: 'answer' | 'fail' = 'answer') => {
        waiting.shift()![how]();
        await rested();
    };
    return { state, view, time, clock, asked, shown, moved, bodyFlow, answer };
}

describe('the flow along the body', () => {
    it('is asked for only while it is wanted, and goes when it is not', async () => {
        const { view, time, asked, shown, bodyFlow, answer } = bench();
        time.value = 2;
        expect([asked, bodyFlow.status.value]).toEqual([[], 'off']);
        view.bodyTexture.value = true;
        expect([asked, bodyFlow.status.value]).toEqual([[2], 'waiting']);
        await answer();
        expect([shown, bodyFlow.status.value]).toEqual([[2], 'shown']);
        view.bodyTexture.value = false;
        expect([shown, bodyFlow.status.value]).toEqual([[2, null], 'off']);
    });

    it('is asked for once at a time, and then at the newest of the times that came meanwhile', async () => {
        const { view, time, clock, asked, shown, moved, bodyFlow, answer } = bench();
        view.bodyTexture.value = true;
        for (const at of [2, 3, 4]) time.value = at;
        expect(asked).toEqual([1]);
        await answer();
        expect([asked, shown, bodyFlow.status.value]).toEqual([[1, 4], [1], 'waiting']);
        await answer();
        expect([asked, shown, bodyFlow.status.value]).toEqual([[1, 4], [1, 4], 'shown']);
        // The texture goes on meanwhile, and stands where there is no clock.
        clock.value = false;
        expect(moved).toEqual([1, 2, 3, 4, null]);
    });

    it('is that of the time nearest to the data, and one for all times where it stands still', async () => {
        const { view, time, asked, answer } = bench();
        time.value = 12;
        view.bodyTexture.value = true;
        await answer();
        time.value = 13;
        expect(asked).toEqual([10]);
        const still = bench({ steady: true, times: [0] });
        still.time.value = 3;
        still.view.bodyTexture.value = true;
        await still.answer();
        still.time.value = 4;
        expect(still.asked).toEqual([0]);
    });

    it('is said not to come, and asked for again at another time alone', async () => {
        const { state, view, time, asked, bodyFlow, answer } = bench();
        view.bodyTexture.value = true;
        await answer('fail');
        expect([asked, bodyFlow.status.value]).toEqual([[1], 'failed']);
        expect(state.notices.all.value.get('body flow')).toBe('too busy');
        time.value = 2;
        await answer();
        expect([asked, bodyFlow.status.value]).toEqual([[1, 2], 'shown']);
        expect(state.notices.all.value.size).toBe(0);
    });

    it('waits for the connection, and for other data asks again', async () => {
        const { state, view, asked, shown, answer } = bench();
        state.stage.value = 'starting';
        view.bodyTexture.value = true;
        expect(asked).toEqual([]);
        state.stage.value = 'running';
        expect(asked).toEqual([1]);
        state.dataset.value = datasetOf({ dataset: 'other', obstacle: true, times: [0, 10] });
        await answer();
        expect([asked, shown]).toEqual([[1, 1], []]);
        await answer();
        expect(shown).toEqual([1]);
        state.dataset.value = datasetOf({ dataset: 'empty', obstacle: false });
        expect(shown).toEqual([1, null]);
    });
});
