import { describe, expect, it } from 'vitest';
import type { StepHeld } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { answering } from '../../testing/fakes.ts';
import { datasetOf } from '../../testing/records.ts';
import { markWords, residentWords, stepMarks, StepsHeld } from './cachedSteps.ts';

function bench(held: StepHeld[]) {
    const state = new AppState();
    state.dataset.value = datasetOf({ dataset: 'd', times: [0, 1, 2] });
    const steps = held.map(([resident]) => (resident > 0 ? 'resident' : 'cold'));
    const worker = answering(() => ({ dataset: 'd', steps, held, bytesPerStep: 100, bytes: 0, budget: 1 }));
    return { state, held: new StepsHeld(state, worker) };
}

describe('what is held of the time-steps', () => {
    it('is the answer, changed by what is told afterwards', async () => {
        const { state, held } = bench([
            [100, 0],
            [0, 0],
            [0, 0],
        ]);
        held.patched('d', [[2, 100, 0]]); // older than the answer
        await held.load('d');
        expect(state.heldSteps.value).toEqual({
            steps: [
                [100, 0],
                [0, 0],
                [0, 0],
            ],
            whole: 100,
        });
        held.patched('another', [[0, 0, 0]]);
        held.patched('d', [
            [1, 2, 30],
            [4, 100, 0],
        ]);
        expect(state.heldSteps.value.steps).toEqual([
            [100, 0],
            [2, 30],
            [0, 0],
            [0, 0],
            [100, 0],
        ]);
    });
});

const mebi = 2 ** 20;
const whole = 64 * mebi;
const [there, coming, cold]: StepHeld[] = [
    [whole, 0],
    [0, whole],
    [0, 0],
];
const held = (...steps: StepHeld[]) => ({ steps, whole });

describe('marks of time-steps', () => {
    it('are one each, or a run a mark that says the least of them', () => {
        const steps = [there!, there!, coming!, cold!, there!];
        const states = ['resident', 'resident', 'loading', 'cold', 'resident'];
        expect(stepMarks(held(...steps), 10).map(({ state }) => state)).toEqual(states);
        expect(stepMarks(held(...steps), 3)).toEqual([
            { first: 0, last: 1, state: 'resident', resident: 1, loading: 0 },
            { first: 2, last: 3, state: 'loading', resident: 0, loading: 0.5 },
            { first: 4, last: 4, state: 'resident', resident: 1, loading: 0 },
        ]);
        for (const count of [1, 7, 239, 240, 241, 5000]) {
            const many = Array.from({ length: count }, (_, i) => steps[Math.floor(i / 50) % 5]!);
            const drawn = stepMarks(held(...many), 240);
            expect(drawn.length).toBeLessThanOrEqual(240);
            expect(drawn.reduce((sum, { first, last }) => sum + last - first + 1, 0)).toBe(count);
            for (const { first, last, state } of drawn) {
                if (state === 'resident') expect(many.slice(first, last + 1).every((each) => each === there)).toBe(true);
            }
        }
        const none = { first: 0, last: 4999, state: 'cold', resident: 0, loading: 0 };
        expect(stepMarks(held(...Array<StepHeld>(5000).fill(cold!)), 240)).toEqual([none]);
    });

    it('have the part in memory and the part that is coming, and of a run the mean', () => {
        const steps: StepHeld[] = [[mebi, 0], [3 * mebi, 16 * mebi], there!, [32 * mebi, 0]];
        expect(stepMarks(held(...steps), 4).map(({ resident, loading }) => [resident, loading])).toEqual([
            [1 / 64, 0],
            [3 / 64, 1 / 4],
            [1, 0],
            [1 / 2, 0],
        ]);
        const [run] = stepMarks(held(...steps), 2);
        expect(run).toEqual({ first: 0, last: 3, state: 'resident', resident: 25 / 64, loading: 1 / 16 });
    });
});

describe('what is in memory', () => {
    it('is counted in words', () => {
        expect(residentWords(held(there!, cold!, coming!))).toBe('1 of 3 time-steps in memory, 1 loading');
        expect(residentWords(held(cold!))).toBe('0 of 1 time-step in memory');
    });

    it('is measured where it is a part of the time-steps', () => {
        const words = '2 of 3 time-steps in memory in part, 3.5 MiB of 192 MiB, 1 loading';
        expect(residentWords(held([3 * mebi, mebi], [mebi / 2, 0], cold!))).toBe(words);
        const large = {
            steps: Array<StepHeld>(20)
                .fill([0, 0])
                .with(3, [2 * mebi, 0]),
            whole,
        };
        expect(residentWords(large)).toBe('1 of 20 time-steps in memory in part, 2 MiB of 1.25 GiB');
    });

    it('is measured for each mark', () => {
        const [mark] = stepMarks(held([3 * mebi, mebi]), 10);
        expect(markWords(mark!, whole)).toBe('3 MiB of 64 MiB in memory, 1 MiB loading');
        expect(markWords({ ...mark!, last: 1, loading: 0 }, whole)).toBe('6 MiB of 128 MiB in memory');
    });
});
