import { describe, expect, it } from 'vitest';
import { answering, settled } from '../../testing/fakes.ts';
import { AppState } from '../../state/appState.ts';
import { CallError } from '../../worker/workerClient.ts';
import { ClockControl } from './clockControl.ts';

function bench(refusal: Error | null = null) {
    const state = new AppState();
    state.clock.value = { time: null, playing: false, speed: 1, loop: false, from: null, to: null };
    const calls: unknown[] = [];
    const worker = answering((method, params) => {
        calls.push([method, params]);
        if (refusal !== null) throw refusal;
        return {};
    });
    return { state, calls, clock: new ClockControl({ state, worker, requestFrame: () => undefined }) };
}

describe('ClockControl', () => {
    it('sends the newest time of a frame, and shows each at once', () => {
        const { state, calls, clock } = bench();
        clock.set(1);
        clock.set(2);
        expect(state.clock.value?.time).toBe(2);
        clock.flush();
        clock.flush();
        expect(calls).toEqual([['time.set', { time: 2 }]]);
    });

    it('plays and pauses', async () => {
        const { calls, clock } = bench();
        await clock.play({ speed: 0.5, loop: true });
        await clock.pause();
        expect(calls).toEqual([
            ['time.play', { speed: 0.5, loop: true }],
            ['time.pause', {}],
        ]);
    });

    it('goes back to what everyone sees when it is refused, unless that has moved on', async () => {
        const { state, clock } = bench(new Error('your role may not do this'));
        for (const time of [1, 2]) {
            clock.set(time);
            clock.flush();
        }
        await settled();
        expect(state.clock.value?.time).toBeNull();
        clock.set(3);
        clock.flush();
        state.clock.value = { ...state.clock.value!, time: 5 };
        await settled();
        expect(state.clock.value.time).toBe(5);
    });

    it('says why it was refused', async () => {
        const { state, clock } = bench(new Error('your role may not do this'));
        clock.set(1);
        clock.flush();
        await settled();
        expect([...state.problems.all.value.values()]).toEqual(['your role may not do this']);
    });

    it('leaves it to the connection to say that it is lost', async () => {
        const { state, clock } = bench(new CallError({ kind: 'disconnected', code: 0, message: 'gone', hint: '' }));
        clock.set(1);
        clock.flush();
        await clock.play({ speed: 1 });
        expect(state.problems.all.value.size).toBe(0);
    });
});
