import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { FakeClock } from '../../testing/fakes.ts';
import type { ClockRecord, SurfaceRecord } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { datasetOf, displayedOf, surfaceOf } from '../../testing/records.ts';
import { Playback } from './playback.ts';
import { Gestures } from '../edits/gestures.ts';
import { intentOf, type SurfaceIntent } from '../edits/surfaceIntent.ts';

const times = [0, 1, 2, 3, 4, 5];

function bench(kind: 'stream' | 'streak' | 'level', rest: Partial<SurfaceRecord> = {}) {
    const state = new AppState();
    const calls: unknown[] = [];
    const record = surfaceOf('s', { kind, from: 1, to: 5, separation: 1, ...rest });
    const intent = signal<SurfaceIntent | null>(intentOf(record));
    const turns = signal(0);
    const gestures = new Gestures();
    const named: (string | undefined)[] = [];
    const edits = {
        intent,
        gestures,
        history: { turns },
        changeSurface: (change: Partial<SurfaceIntent>, gesture?: string) => {
            named.push(gesture);
            calls.push(change);
            intent.value = { ...intent.value!, ...change };
        },
    };
    const told = (change: Partial<ClockRecord>): void => {
        state.clock.value = { ...state.clock.value!, ...change };
    };
    const clock = {
        set: (time: number) => told({ time }),
        play: (how: Partial<ClockRecord>) => {
            calls.push(how);
            told({ ...how, playing: true });
            return Promise.resolve();
        },
        pause: () => {
            told({ playing: false });
            return Promise.resolve();
        },
    };
    state.clock.value = { time: null, playing: false, speed: 1, loop: false, from: null, to: null };
    state.dataset.value = datasetOf({ times });
    state.surfaces.value = new Map([['s', record]]);
    state.activeSurface.value = 's';
    state.stage.value = 'running';
    state.displayed.value = new Map([['s', displayedOf('s')]]);
    const time = new FakeClock();
    return { state, calls, time, intent, turns, gestures, named, playback: new Playback({ state, edits, clock, time }) };
}

describe('Playback of a surface that moves', () => {
    it('shows the end until someone sets the clock, and stays within the surface', () => {
        const { playback, state } = bench('streak');
        expect(playback.time.value).toBe(5);
        playback.goTo(9);
        expect(state.clock.value?.time).toBe(5);
        playback.goTo(0);
        expect(playback.time.value).toBe(1);
    });

    it('plays its whole time in ten seconds, until another speed is chosen or told', async () => {
        const { playback, calls, state } = bench('streak');
        await playback.play();
        expect(calls).toEqual([{ speed: 0.4, loop: true, from: 1, to: 5 }]);
        await playback.setSpeed(2);
        await playback.setLoop(false);
        expect(calls.slice(1)).toEqual([
            { speed: 0.8, loop: true, from: 1, to: 5 },
            { speed: 0.8, loop: false, from: 1, to: 5 },
        ]);
        state.clock.value = { ...state.clock.value!, speed: 3, loop: true };
        expect([playback.speed.value, playback.loop.value]).toEqual([3, true]);
    });

    it('does not forget a speed that is chosen before the clock has started', async () => {
        const { playback, calls } = bench('streak');
        const starting = playback.play();
        await playback.setSpeed(2);
        await starting;
        expect(calls).toEqual([
            { speed: 0.4, loop: true, from: 1, to: 5 },
            { speed: 0.8, loop: true, from: 1, to: 5 },
        ]);
    });

    it('ends with the data also while an edit is on its way', () => {
        const { playback, intent } = bench('streak');
        intent.value = { ...intent.value!, from: 2, length: 40 };
        expect(playback.span.value).toEqual([2, 5]);
    });

    it('plays a backward one from its earlier end, and shows where it ends until someone sets the clock', async () => {
        const { playback, calls, state, intent } = bench('streak', { from: 5, to: 1, direction: 'backward' });
        expect([playback.span.value, playback.time.value]).toEqual([[1, 5], 1]);
        playback.goTo(2.3);
        await playback.step(1);
        expect(state.clock.value?.time).toBe(3);
        await playback.play();
        expect(calls).toEqual([{ speed: 0.4, loop: true, from: 1, to: 5 }]);
        intent.value = { ...intent.value!, from: 3, length: 40 };
        expect(playback.span.value).toEqual([0, 3]);
    });

    it('has what was stopped computed again before it plays', async () => {
        const { playback, calls, state } = bench('streak');
        state.surfaceErrors.value = new Map([['s', { epoch: 1, text: 'stopped by Ann', stopped: true }]]);
        expect(state.phase.value).toBe('stopped');
        await playback.play();
        expect(calls).toEqual([{}, { speed: 0.4, loop: true, from: 1, to: 5 }]);
        state.surfaceErrors.value = new Map();
        await playback.play();
        expect(calls.length, 'what is whole is not').toBe(3);
    });

    it('stops to step by a stored time-step', async () => {
        const { playback, state } = bench('streak');
        playback.goTo(2.3);
        await playback.step(1);
        expect(state.clock.value).toMatchObject({ time: 3, playing: false });
        await playback.step(-1);
        expect(playback.time.value).toBe(2);
    });
});

describe('Playback where other data move as well', () => {
    function several(kind: 'stream' | 'streak' | 'level' = 'streak') {
        const page = bench(kind);
        const other = surfaceOf('o', { dataset: 'other', kind: 'streak', from: 3, to: 9 });
        page.state.surfaces.value = new Map([...page.state.surfaces.value, ['o', other]]);
        page.state.otherDatasets.value = new Map([['other', datasetOf({ dataset: 'other', times: [3, 6, 9] })]]);
        return page;
    }

    it('is of all their times, and steps through those of each', async () => {
        const { playback, state, calls } = several();
        expect([playback.own.value, playback.span.value]).toEqual([
            [1, 5],
            [1, 9],
        ]);
        playback.goTo(5);
        await playback.step(1);
        expect([state.clock.value?.time, playback.time.value]).toEqual([6, 6]);
        await playback.play();
        expect(calls).toEqual([{ speed: 0.8, loop: true, from: 1, to: 9 }]);
    });

    it('goes on with them where the chosen surface has come to its end', async () => {
        const { playback, state } = several();
        const at = (s: number, o: number): void => {
            const other = displayedOf('o', { time: o });
            state.displayed.value = new Map([
                ['s', displayedOf('s', { time: s })],
                ['o', other],
            ]);
        };
        await playback.play();
        at(4, 4);
        expect(playback.time.value).toBe(4);
        at(5, 7);
        expect(playback.time.value).toBe(7);
    });

    it('moves the chosen surface through its own data, whichever are worked on', async () => {
        const { playback, state, intent } = several('stream');
        state.otherDatasets.value = new Map([['flow', state.dataset.value!]]);
        state.dataset.value = datasetOf({ dataset: 'other', times: [3.2, 6.2, 9.2] });
        await playback.step(1);
        expect([playback.own.value, intent.value?.from]).toEqual([[0, 5], 2]);
        playback.release(9.2);
        expect(intent.value?.from).toBe(5);
        state.otherDatasets.value = new Map();
        playback.release(3.2);
        expect(intent.value?.from, 'while its data are not known').toBe(5);
    });

    it('leaves them at the time of the clock where the chosen surface freezes its own field', () => {
        const { playback, state } = several('stream');
        const shown = (): number[] => ['flow', 'other'].map((each) => playback.timeOf(each));
        expect([playback.mode.value, shown()]).toEqual(['frozen', [1, 9]]);
        state.clock.value = { ...state.clock.value!, time: 4 };
        expect(shown()).toEqual([1, 4]);
        state.surfaces.value = new Map([...state.surfaces.value].filter(([id]) => id === 's'));
        expect(shown(), 'nothing goes with the clock').toEqual([1, 1]);
    });

    it.each(['stream', 'level'] as const)('plays them where the chosen %s surface has one time', async (kind) => {
        const { playback, state, calls } = several(kind);
        state.dataset.value = datasetOf({ times: [1] });
        expect([playback.mode.value, playback.span.value, playback.time.value]).toEqual(['clock', [3, 9], 9]);
        await playback.play();
        expect(calls).toEqual([{ speed: 0.6, loop: true, from: 3, to: 9 }]);
        const at = displayedOf('o', { time: 5 });
        state.displayed.value = new Map([...state.displayed.value, ['o', at]]);
        expect(playback.time.value).toBe(5);
    });

    it('is of its own times alone while the others are hidden', () => {
        const { playback, state } = several();
        state.hiddenSurfaces.value = new Set(['o']);
        expect(playback.span.value).toEqual([1, 5]);
    });
});

describe('Playback of a stream surface', () => {
    it('freezes the field at one time-step after the other, as fast as asked', async () => {
        const { playback, intent, time } = bench('stream');
        await playback.setSpeed(4); // 2 a second
        await playback.play();
        await time.pass(400);
        expect(intent.value?.from).toBe(1);
        await time.pass(200);
        expect(intent.value?.from).toBe(2);
        await time.pass(4 * 560);
        expect(intent.value?.from).toBe(0); // began again
        await playback.pause();
        await time.pass(5000);
        expect(intent.value?.from).toBe(0);
    });

    it('is one act, with what its user does meanwhile, and stops when that is undone', async () => {
        const { playback, time, named, gestures, turns, intent } = bench('stream');
        const before = gestures.slid('length', 0);
        await playback.setSpeed(4);
        await playback.play();
        await time.pass(1600);
        expect(named.length).toBeGreaterThan(1);
        expect(new Set(named).size).toBe(1);
        expect(named[0]).not.toBe(before);
        const slid = gestures.slid('separation', 0);
        await time.pass(600);
        expect(named.at(-1)).toBe(slid);
        ++turns.value;
        const at = intent.value?.from;
        await time.pass(5000);
        expect([intent.value?.from, playback.playing.value]).toEqual([at, false]);
    });

    it('waits for the picture, and stops at the end without loop', async () => {
        const { playback, intent, time, state } = bench('stream');
        await playback.setLoop(false);
        await playback.setSpeed(4);
        await playback.play();
        state.editsPending.value = true;
        await time.pass(5000);
        expect(intent.value?.from).toBe(1);
        state.editsPending.value = false;
        await time.pass(5000);
        expect(intent.value?.from).toBe(5);
        expect(playback.playing.value).toBe(false);
    });
});
