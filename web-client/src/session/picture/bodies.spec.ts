import { afterEach, expect, it, vi } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { settled } from '../../testing/fakes.ts';
import { datasetOf } from '../../testing/records.ts';
import { lateMs } from '../base/lateWaits.ts';
import { Bodies } from './bodies.ts';

afterEach(() => {
    vi.useRealTimers();
});

it('a body that could not be had leaves a newer request for it alone', async () => {
    const asked: { resolve: (mesh: null) => void; reject: (error: Error) => void }[] = [];
    const worker = { obstacle: () => new Promise<null>((resolve, reject) => asked.push({ resolve, reject })) };
    const bodies = new Bodies(new AppState(), worker);
    bodies.of(datasetOf(), false).catch(() => undefined);
    const newer = bodies.of(datasetOf(), true);
    asked[0]!.reject(new Error('gone'));
    await settled();
    expect(bodies.of(datasetOf(), true)).toBe(newer);
    expect(asked).toHaveLength(2);
});

it('words over the picture say that a body is late, and it can be asked for again', async () => {
    vi.useFakeTimers();
    const answers: ((mesh: null) => void)[] = [];
    const state = new AppState();
    const bodies = new Bodies(state, { obstacle: () => new Promise((resolve) => answers.push(resolve)) });
    const body = bodies.of(datasetOf(), false);
    await vi.advanceTimersByTimeAsync(lateMs);
    const [[about, words]] = [...state.notices.all.value] as [[string, string]];
    expect(words).toBe('The server has not sent the body for more than 10 s.');
    state.notices.remedyOf(about)!.act();
    await vi.advanceTimersByTimeAsync(0);
    expect([answers.length, state.notices.all.value.size]).toEqual([2, 0]);
    expect(bodies.of(datasetOf(), false)).toBe(body);
    answers[1]!(null);
    expect(await body).toBeNull();
});
