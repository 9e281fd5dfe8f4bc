import { describe, expect, it } from 'vitest';
import type { ClockRecord, SurfaceKind } from '../../protocol/messages.ts';
import { Bench } from '../../testing/pageBench.ts';
import { datasetOf, suggestionOf, surfaceOf } from '../../testing/records.ts';
import { chooseKind } from './kindChoice.ts';
import { Playback } from './playback.ts';

const times = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10];

/** @param clock of the session; null: never set */
function bench(surface: Parameters<typeof surfaceOf>[1], clock: number | null, steady = false) {
    const made = new Bench();
    const { state, edits } = made;
    state.dataset.value = datasetOf({ times: steady ? [0] : times, steady });
    state.stage.value = 'running';
    state.suggestion.value = { dataset: 'flow', ...suggestionOf() };
    state.clock.value = { rev: 1, time: clock, playing: false, speed: 1, loop: false, from: null, to: null } as ClockRecord;
    made.records([...state.rakes.value.values()], [surfaceOf('s1', { rake: 'r1', ...surface })]);
    const set: (number | null)[] = [];
    const control = {
        set: (time: number | null) => {
            set.push(time);
            state.clock.value = { ...state.clock.value!, time };
        },
        play: () => Promise.resolve(),
        pause: () => Promise.resolve(),
    };
    const playback = new Playback({ state, edits, clock: control });
    return {
        ...made,
        set,
        playback,
        edits,
        choose: (kind: SurfaceKind) => chooseKind({ state, edits, clock: control, playback }, kind),
    };
}

const stream = (from: number) => ({ kind: 'stream' as const, from, to: from + 4, separation: 0.1 });

describe('another kind of surface', () => {
    it('is shown at the time of the picture, with the times before it', () => {
        for (const kind of ['path', 'streak', 'time'] as const) {
            for (const from of [10, 7]) {
                const made = bench(stream(from), null);
                made.choose(kind);
                expect(made.playback.time.value).toBe(from);
                expect(made.edits.remark.value).toBeNull();
                const { length } = made.edits.intent.value!;
                expect(made.edits.intent.value).toMatchObject({ kind, from: from - length });
                expect(length).toBe(kind === 'time' ? 2 : 4);
            }
        }
    });

    it('says so where nothing is there yet at that time', () => {
        const made = bench(stream(0), null);
        made.choose('streak');
        expect(made.edits.intent.value).toMatchObject({ kind: 'streak', from: 0, length: 4 });
        expect(made.edits.remark.value).toBe('Shown at 4 now, no longer at 0: this kind has nothing to show then.');
    });

    it('takes the clock with it where that stands elsewhere', () => {
        const made = bench(stream(7), 2);
        made.choose('streak');
        expect(made.set).toEqual([7]);
        expect(made.playback.time.value).toBe(7);
    });

    it('keeps the times of a surface that moves, but for a patch that would be gone', () => {
        const made = bench({ kind: 'streak', from: 6, to: 10, separation: 0.05 }, null);
        made.choose('path');
        expect(made.edits.intent.value).toMatchObject({ kind: 'path', from: 6, length: 4 });
        made.choose('time');
        expect(made.edits.intent.value).toMatchObject({ kind: 'time', from: 8, length: 2 });
        expect(made.playback.time.value).toBe(10);
        const chosen = bench({ kind: 'streak', from: 2, to: 9, separation: 0.3 }, 5);
        chosen.choose('time');
        expect(chosen.edits.intent.value).toMatchObject({ kind: 'time', from: 2, length: 7, separation: 0.3 });
        expect(chosen.playback.time.value).toBe(5);
    });

    it('is frozen at the time of the picture', () => {
        const made = bench({ kind: 'streak', from: 6, to: 10, separation: 0.05 }, 8);
        made.choose('stream');
        expect(made.edits.intent.value).toMatchObject({ kind: 'stream', from: 8, length: 4, separation: 0.1 });
        expect(made.edits.remark.value).toBeNull();
        const between = bench({ kind: 'streak', from: 6, to: 10, separation: 0.05 }, 8.4);
        between.choose('stream');
        expect(between.edits.intent.value?.from).toBe(8);
        expect(between.edits.remark.value).toContain('Shown at 8 now');
    });

    it('has the separation of its kind, unless the user has chosen one', () => {
        const made = bench({ ...stream(10), separation: 0.25 }, null);
        made.choose('streak');
        expect(made.edits.intent.value?.separation).toBe(0.25);
        const usual = bench(stream(10), null);
        usual.choose('streak');
        expect(usual.edits.intent.value?.separation).toBe(0.05);
    });

    it('of steady flow stays as long as it is', () => {
        const made = bench({ kind: 'stream', from: 0, to: 4, separation: 0.1 }, null, true);
        made.choose('streak');
        expect(made.edits.intent.value).toMatchObject({ kind: 'streak', from: 0, length: 4 });
        expect(made.edits.remark.value).toBeNull();
    });

    it('waits for nothing where the server has suggested nothing', () => {
        const made = bench(stream(10), null);
        made.state.suggestion.value = null;
        made.choose('path');
        expect(made.edits.intent.value).toMatchObject({ kind: 'path', from: 6, length: 4 });
    });
});
