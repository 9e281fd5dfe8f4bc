import { describe, expect, it } from 'vitest';
import { Bench } from '../../testing/pageBench.ts';
import { datasetOf, surfaceOf } from '../../testing/records.ts';
import { CallError } from '../../worker/workerClient.ts';

describe('a change of a surface that cannot be as it is', () => {
    const refusal = new CallError({ kind: 'rpc', code: -32014, message: 'there is no room', hint: '' });

    function bench(times = [0, 1, 2, 3, 4]): Bench {
        const made = new Bench();
        made.state.dataset.value = datasetOf({ times });
        return made;
    }

    /** The record as the server has it after the newest edit. */
    function taken(made: Bench, rev: number): void {
        const [, params] = made.calls.at(-1)!;
        const rest = [...made.state.surfaces.value.values()].filter(({ surface }) => surface !== 's1');
        made.records([...made.state.rakes.value.values()], [surfaceOf('s1', { rake: 'r1', ...params, rev }), ...rest]);
    }

    it('is released where the data have time for it, says so, and is what the record becomes', async () => {
        for (const [kind, direction, from, to] of [
            ['streak', 'backward', 4, 0],
            ['path', 'backward', 4, 0],
            ['path', 'both', 0, 4],
        ] as const) {
            const made = bench();
            made.edits.changeSurface({ direction });
            made.edits.changeSurface({ kind });
            made.edits.flush();
            expect(made.calls.at(-1)![1]).toMatchObject({ kind, direction, from, to });
            await made.answer(2, { surface: 's1', epoch: 2 });
            taken(made, 2);
            expect(made.edits.intent.value).toMatchObject({ kind, direction, from });
            if (direction === 'backward') expect(made.edits.remark.value).toBe('Released at 4: the data have nothing before 0.');
            else expect(made.edits.remark.value).toBeNull();
        }
    });

    it('goes one way where its kind cannot go both, and says so until the next change', async () => {
        const made = bench();
        made.edits.changeSurface({ direction: 'both' });
        made.edits.flush();
        await made.answer(2, { surface: 's1', epoch: 2 });
        taken(made, 2);
        made.edits.changeSurface({ kind: 'streak' });
        made.edits.flush();
        expect(made.calls.at(-1)![1]).toMatchObject({ kind: 'streak', direction: 'forward', from: 0, to: 4 });
        expect(made.edits.intent.value).toMatchObject({ kind: 'streak', direction: 'forward' });
        expect(made.edits.remark.value).toContain('goes one way in time');
        made.edits.changeSurface({ length: 2 });
        expect(made.edits.remark.value).toBeNull();
    });

    it('is released no later than the last time-step with data after it, however far the release is dragged', () => {
        const made = bench();
        made.edits.changeSurface({ kind: 'path' });
        made.edits.changeSurface({ from: 4 });
        made.edits.flush();
        expect(made.calls.at(-1)![1]).toMatchObject({ from: 3, to: 4 });
        expect(made.edits.intent.value?.from).toBe(3);
        expect(made.edits.remark.value).toBe('Released at 3: the data have nothing after 4.');
        made.edits.chooseRake('r2');
        expect(made.edits.remark.value).toBeNull();
    });

    it('goes by the data of the surface, whichever are worked on, and waits until these are known', () => {
        const made = bench();
        const own = made.state.dataset.value!;
        made.state.dataset.value = datasetOf({ dataset: 'other', times: [10, 20] });
        made.edits.changeSurface({ kind: 'path' });
        expect(made.edits.remark.value).toContain('are not known');
        made.state.otherDatasets.value = new Map([['flow', own]]);
        made.edits.changeSurface({ kind: 'path' });
        made.edits.flush();
        expect(made.calls.map(([, { from, to }]) => [from, to])).toEqual([[0, 4]]);
    });

    it('is not applied where the data have one time-step only: the controls stay at the record', () => {
        const made = bench([0]);
        made.edits.changeSurface({ kind: 'path' });
        made.edits.flush();
        expect(made.calls).toEqual([]);
        expect(made.edits.intent.value?.kind).toBe('stream');
        expect(made.edits.remark.value).toContain('Not applied');
    });

    it('goes back to the record when the server refuses it, with the reason beside it', async () => {
        const made = bench();
        made.edits.changeSurface({ separation: 0.5 });
        made.edits.flush();
        await made.refuse(refusal);
        expect(made.edits.intent.value?.separation).toBe(0.2);
        expect(made.edits.remark.value).toBe('Not applied: there is no room');
        expect(made.told).toEqual(['surface s1']);
    });

    it('is still said not to be applied when the surface is computed anew for another rake, until the controls change', async () => {
        const made = bench();
        made.edits.changeSurface({ separation: 0.5 });
        made.edits.flush();
        await made.refuse(refusal);
        const told = (change: object): void => {
            const rest = [...made.state.surfaces.value.values()].filter(({ surface }) => surface !== 's1');
            made.records([...made.state.rakes.value.values()], [surfaceOf('s1', { rake: 'r1', ...change }), ...rest]);
        };
        told({ rev: 2, epoch: 9 });
        expect(made.edits.remark.value).toBe('Not applied: there is no room');
        told({ rev: 3, epoch: 10, separation: 0.3 });
        expect(made.edits.intent.value?.separation).toBe(0.3);
        expect(made.edits.remark.value).toBeNull();
    });

    it('stays where a newer one is on its way, and is forgotten where that is taken', async () => {
        const made = bench();
        for (const separation of [0.5, 0.4]) {
            made.edits.changeSurface({ separation });
            made.edits.flush();
        }
        await made.refuse(refusal);
        expect(made.edits.intent.value?.separation).toBe(0.4);
        await made.answer(2, { surface: 's1', epoch: 2 });
        taken(made, 2);
        expect(made.edits.intent.value?.separation).toBe(0.4);
        expect(made.edits.remark.value).toBeNull();
    });
});

describe('a change of a surface that someone else has made', () => {
    it('is shown also where it came while an edit of this page was unanswered', async () => {
        const made = new Bench();
        made.edits.changeSurface({ separation: 0.5 });
        made.edits.flush();
        const rest = [...made.state.surfaces.value.values()].filter(({ surface }) => surface !== 's1');
        const theirs = surfaceOf('s1', { rake: 'r1', separation: 0.7, rev: 3 });
        made.records([...made.state.rakes.value.values()], [theirs, ...rest]);
        expect(made.edits.intent.value?.separation).toBe(0.5);
        await made.answer(2, { surface: 's1', epoch: 2 });
        expect(made.edits.intent.value?.separation).toBe(0.7);
    });
});
