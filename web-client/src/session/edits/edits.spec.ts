import { describe, expect, it } from 'vitest';
import { circleOf, circleShape } from '../../scene/rake/rakeShape.ts';
import { settled } from '../../testing/fakes.ts';
import { Bench, type Call } from '../../testing/pageBench.ts';
import { datasetOf, rakeOf, suggestionOf, surfaceOf } from '../../testing/records.ts';
import { CallError } from '../../worker/workerClient.ts';
import { numberProblems } from './rakeEdits.ts';

const leased = new CallError({ kind: 'rpc', code: -32011, message: 'rake r1 is being dragged by Ann', hint: 'force' });
const lost = new CallError({ kind: 'disconnected', code: 0, message: 'gone', hint: '' });

describe('a circle', () => {
    it('is kept in the data of its surface, whichever are worked on, and left alone while these are not known', () => {
        const bench = new Bench();
        const middle = (x: number): unknown => {
            const circle = circleShape({ centre: [x, 0.5, 0.5], radius: 0.25, u: [1, 0, 0], v: [0, 1, 0] });
            bench.edits.changeRake('r1', { shape: circle });
            return circleOf(bench.state.rakeShape.value).centre[0];
        };
        bench.state.dataset.value = datasetOf({ dataset: 'other', bounds: [0, 1, 0, 1, 0, 1] });
        expect(middle(9)).toBeCloseTo(9);
        bench.state.otherDatasets.value = new Map([['flow', datasetOf({ bounds: [0, 5, 0, 5, 0, 5] })]]);
        expect(middle(9)).toBeCloseTo(4.75);
    });
});

describe('a drag on its way to the server', () => {
    it('is one edit a frame at most, the newest, with no more than four unanswered', async () => {
        const bench = new Bench();
        for (let x = 1; x <= 10; ++x) {
            bench.drag(x);
            bench.drag(x + 0.5);
            bench.edits.flush();
        }
        expect(bench.sent).toEqual([1.5, 2.5, 3.5, 4.5]);
        await bench.answer();
        bench.edits.flush();
        expect(bench.sent.at(-1)).toBe(10.5);
    });

    it('takes the lease while it lasts and ends it afterwards', () => {
        const bench = new Bench();
        bench.drag(1);
        bench.edits.flush();
        bench.drag(2, false);
        bench.edits.flush();
        expect(bench.calls.map(([method, { rake, dragging }]) => [method, rake, dragging])).toEqual([
            ['rake.set', 'r1', true],
            ['rake.set', 'r1', false],
        ]);
    });

    it('stays on the screen until its record has come, and then shows that', async () => {
        const bench = new Bench();
        bench.drag(5, false);
        bench.edits.flush();
        bench.records([rakeOf('r1'), rakeOf('r2')]);
        expect(bench.state.rakePoints.value[0]![0]).toBe(5);
        await bench.answer(2);
        expect(bench.state.rakePoints.value[0]![0]).toBe(5);
        bench.records([
            rakeOf('r1', {
                rev: 2,
                points: [
                    [4, 0, 0],
                    [0, 0, 1],
                ],
            }),
            rakeOf('r2'),
        ]);
        expect(bench.state.rakePoints.value[0]![0]).toBe(4);
    });

    it('goes back to where everyone sees it when someone else holds the rake', async () => {
        const bench = new Bench();
        bench.drag(5);
        bench.edits.flush();
        await bench.refuse(leased);
        expect(bench.state.problems.all.value.get('rake r1')).toContain('wait until it is released');
        bench.drag(6, false);
        bench.edits.flush();
        await bench.refuse(leased);
        expect(bench.state.rakePoints.value[0]![0]).toBe(0);
        expect(bench.state.editsPending.value).toBe(false);
    });

    it('is an act of its own when the one before it ended with its rake, even if that is there again', () => {
        const bench = new Bench();
        const records = [...bench.state.rakes.value.values()];
        const drag = (rake: string, x: number): void => {
            bench.edits.chooseRake(rake);
            bench.drag(x);
            bench.edits.flush();
        };
        drag('r1', 1);
        bench.records([rakeOf('r2')]);
        drag('r2', 2);
        bench.held = false;
        bench.records(records);
        drag('r2', 3);
        drag('r2', 4);
        const named = bench.calls.map(([, { gesture }]) => gesture);
        expect(named.map((each) => named.indexOf(each))).toEqual([0, 1, 2, 2]);
    });

    it('keeps its last edit when another rake is chosen and edited in the same frame', () => {
        const bench = new Bench();
        bench.drag(5, false);
        bench.edits.chooseRake('r2');
        bench.drag(7, false);
        bench.edits.flush();
        expect(bench.calls.map(([, { rake }]) => rake)).toEqual(['r1', 'r2']);
        expect(bench.sent).toEqual([5, 7]);
    });
});

describe('edits of a rake', () => {
    it('say the whole of it, each on top of the last', () => {
        const bench = new Bench();
        bench.records([rakeOf('r1', { colour: '#aaaaaa' }), rakeOf('r2')]);
        bench.edits.changeRake('r1', { colour: '#123456' });
        bench.edits.changeRake('r1', { seeds: 20 });
        bench.edits.changeRake('r1', { name: 'Low' });
        bench.edits.flush();
        const [[, params]] = bench.calls as [Call];
        expect(params).toMatchObject({ rake: 'r1', kind: 'line', seeds: 20, name: 'Low', colour: '#123456' });
    });

    it('leave the colour as it is where they are not about it', () => {
        const bench = new Bench();
        bench.records([rakeOf('r1'), rakeOf('r2', { colour: '#aaaaaa' })]);
        bench.edits.changeRake('r2', { seeds: 20 });
        bench.edits.flush();
        expect(bench.calls[0]![1]).not.toHaveProperty('colour');
    });
});

describe('what is chosen', () => {
    it('is a rake with one of its surfaces, or a surface with its rake', () => {
        const { state, edits } = new Bench();
        edits.chooseRake('r2');
        expect([state.activeRake.value, state.activeSurface.value]).toEqual(['r2', 's2']);
        state.activeSurface.value = 's1';
        expect(state.activeRake.value).toBe('r1');
        expect(edits.intent.value).toMatchObject({ kind: 'stream', length: 4 });
    });

    it('is another rake when it is deleted, and none when all are', () => {
        const bench = new Bench();
        bench.records([rakeOf('r2')], [surfaceOf('s2', { rake: 'r2' })]);
        expect(bench.state.activeRake.value).toBe('r2');
        bench.records([rakeOf('r2')], []);
        expect([bench.state.activeRake.value, bench.state.activeSurface.value]).toEqual(['r2', null]);
        expect(bench.edits.intent.value).toBeNull();
        bench.records([], []);
        expect(bench.state.activeRake.value).toBeNull();
        expect(bench.state.rakePoints.value).toEqual([]);
    });
});

describe('an edit of a surface', () => {
    it('is what the controls show again after undo and redo, and what the next edit goes on from', async () => {
        const bench = new Bench();
        const before = bench.state.surfaces.value;
        bench.edits.changeSurface({ separation: 0.5 });
        bench.edits.flush();
        await bench.answer(2, { surface: 's1', epoch: 2 });
        const after = [...before.values()].map((each) => (each.surface === 's1' ? { ...each, separation: 0.5, rev: 2 } : each));
        const rakes = [rakeOf('r1'), rakeOf('r2')];
        const shown = [after, [...before.values()], after].map((surfaces, turn) => {
            bench.records(
                rakes,
                surfaces.map((each) => ({ ...each, rev: 2 + turn })),
            );
            return bench.edits.intent.value?.separation;
        });
        expect(shown).toEqual([0.5, 0.2, 0.5]);
        bench.edits.changeSurface({ length: 3 });
        bench.edits.flush();
        expect(bench.calls.at(-1)![1]).toMatchObject({ to: 3, separation: 0.5 });
    });
});

describe('what is said of an edit', () => {
    it('is nothing where it ended with the connection, which says so itself', async () => {
        const bench = new Bench();
        bench.edits.changeRake('r1', { seeds: 20 });
        bench.edits.changeSurface({ length: 5 });
        bench.edits.flush();
        await bench.refuse(lost);
        await bench.refuse(lost);
        expect(bench.state.editsPending.value).toBe(false);
        expect(bench.told).toEqual([]);
    });

    it('goes with its rake and surface, and nothing is said of them afterwards', async () => {
        const bench = new Bench();
        for (const seeds of [20, 21]) {
            bench.edits.changeRake('r1', { seeds });
            bench.edits.changeSurface({ length: seeds });
            bench.edits.flush();
        }
        await bench.refuse(leased);
        await bench.refuse(leased);
        expect(bench.told).toEqual(['rake r1', 'surface s1']);
        bench.records([rakeOf('r2')], [surfaceOf('s2', { rake: 'r2' })]);
        expect(bench.told).toEqual([]);
        await bench.refuse(leased);
        await bench.refuse(leased);
        expect(bench.told).toEqual([]);
    });
});

describe('that a rake cannot have a number', () => {
    function refused(): Bench {
        const bench = new Bench();
        for (const about of Object.values(numberProblems)) bench.state.problems.say(about, 'it ends there');
        return bench;
    }

    it('is solved by a change of the same, wherever that is made', () => {
        const bench = refused();
        bench.drag(1);
        expect(bench.told).toEqual([numberProblems.seeds]);
        bench.edits.changeRake('r1', { seeds: 20 });
        expect(bench.told).toEqual([]);
    });

    it('is of no interest once another rake is shown', () => {
        const bench = refused();
        bench.edits.chooseSurface('s1');
        expect(bench.told).toHaveLength(2);
        bench.edits.chooseRake('r2');
        expect(bench.told).toEqual([]);
    });
});

describe('an edit that waits to be sent', () => {
    it('is none any more once its rake and surface are deleted, and undo does not wait for it', async () => {
        const bench = new Bench();
        bench.edits.changeRake('r1', { seeds: 20 });
        bench.edits.flush();
        await bench.answer();
        bench.edits.changeRake('r1', { seeds: 21 });
        bench.edits.changeSurface({ length: 5 });
        expect(bench.state.editsPending.value).toBe(true);
        bench.records([rakeOf('r2')], [surfaceOf('s2', { rake: 'r2' })]);
        expect(bench.state.editsPending.value).toBe(false);
        void bench.edits.undo();
        for (let i = 0; i < 4; ++i) await settled();
        expect(bench.calls.map(([method]) => method)).toEqual(['rake.set', 'history.undo']);
    });
});

describe('undo', () => {
    const undone = { undone: [{}], undo: 0, redo: 0, skipped: [] };
    const redone = { redone: [{}], undo: 0, redo: 0, skipped: [] };

    it('that fails leaves the step to be undone', async () => {
        const bench = new Bench();
        bench.edits.changeSurface({ length: 5 });
        bench.edits.flush();
        await bench.answer(2, { surface: 's1', epoch: 2 });
        void bench.edits.undo();
        await settled();
        await bench.refuse(leased);
        const { history } = bench.edits;
        expect([history.undoable.value, history.redoable.value]).toEqual([1, 0]);
        void bench.edits.undo();
        await settled();
        await bench.answer(0, undone);
        expect([history.undoable.value, history.redoable.value]).toEqual([0, 1]);
    });

    it('comes after what was done before it, also where that is not answered yet', async () => {
        const bench = new Bench();
        for (const length of [5, 6, 7, 8, 9]) {
            bench.edits.changeSurface({ length });
            bench.edits.flush();
        }
        void bench.edits.undo();
        await settled();
        // Four are unanswered, and the newest waits for one of them.
        for (let answers = 0; answers < 5; ++answers) {
            expect(bench.calls.map(([method]) => method)).not.toContain('history.undo');
            await bench.answer(2, { surface: 's1', epoch: 2 });
            bench.edits.flush();
        }
        for (let i = 0; i < 4; ++i) await settled();
        expect(bench.calls.map(([method]) => method)).toEqual([...Array<string>(5).fill('surface.set'), 'history.undo']);
    });

    it('has nothing left once it is cleared', async () => {
        const bench = new Bench();
        bench.edits.changeRake('r1', { seeds: 20 });
        bench.edits.flush();
        await bench.answer();
        bench.edits.history.clear();
        await bench.edits.undo();
        expect(bench.calls.map(([method]) => method)).toEqual(['rake.set']);
        expect(bench.edits.history.undoable.value).toBe(0);
    });

    it('says of a new rake whether it was made, which it is without a surface, too', async () => {
        const bench = new Bench();
        bench.state.dataset.value = datasetOf();
        bench.state.suggestion.value = { dataset: 'flow', ...suggestionOf() };
        const refused = bench.edits.actions.newRake();
        await bench.refuse(new Error('no more rakes'));
        expect(await refused).toBe(false);
        const bare = bench.edits.actions.newRake();
        await bench.answer(1, { rake: 'r3' });
        await bench.refuse(new Error('no more surfaces'));
        expect(await bare).toBe(true);
    });

    it('takes back a drag, a slider, or a button that makes two records, with one call each', async () => {
        const bench = new Bench();
        bench.state.dataset.value = datasetOf();
        bench.state.suggestion.value = { dataset: 'flow', ...suggestionOf() };
        for (const x of [1, 2, 3]) {
            bench.drag(x, x < 3);
            bench.edits.flush();
            await bench.answer(x + 1);
        }
        for (const length of [5, 6, 7]) {
            bench.edits.changeSurface({ length });
            bench.edits.flush();
            await bench.answer(2, { surface: 's1', epoch: 2 });
        }
        void bench.edits.actions.newRake();
        await bench.answer(1, { rake: 'r3' });
        await bench.answer(1, { surface: 's3', epoch: 1 });
        const { history } = bench.edits;
        expect(history.undoable.value).toBe(3);
        const named = bench.calls.map(([, { gesture }]) => gesture);
        expect(named.map((each) => named.indexOf(each))).toEqual([0, 0, 0, 3, 3, 3, 6, 6]);
        bench.calls = [];
        for (let left = 2; left >= 0; --left) {
            void bench.edits.undo();
            await settled();
            await bench.answer(0, undone);
            expect([history.undoable.value, history.redoable.value]).toEqual([left, 3 - left]);
        }
        await bench.edits.undo();
        expect(history.words.value).toBe('Nothing left to undo.');
        void bench.edits.redo();
        await settled();
        await bench.answer(0, redone);
        expect(bench.calls.map(([method]) => method)).toEqual([...Array<string>(3).fill('history.undo'), 'history.redo']);
        expect([history.undoable.value, history.redoable.value]).toEqual([1, 2]);
    });

    it('amid a slide takes back what came of it until then; the rest is a step by itself', async () => {
        const bench = new Bench();
        const slide = async (length: number): Promise<void> => {
            bench.edits.changeSurface({ length });
            bench.edits.flush();
            await bench.answer(2, { surface: 's1', epoch: 2 });
        };
        bench.edits.gestures.press();
        await slide(5);
        void bench.edits.undo();
        await settled();
        await bench.answer(0, undone);
        const { history } = bench.edits;
        expect([history.undoable.value, history.redoable.value]).toEqual([0, 1]);
        await slide(6);
        await slide(7);
        expect([history.undoable.value, history.redoable.value]).toEqual([1, 0]);
    });

    it('knows when the server has forgotten what was counted', async () => {
        const bench = new Bench();
        for (const seeds of [20, 21]) {
            bench.edits.changeRake('r1', { seeds });
            bench.edits.flush();
            await bench.answer();
        }
        void bench.edits.undo();
        await settled();
        await bench.answer(0, { ...undone, undone: null });
        expect(bench.edits.history.undoable.value).toBe(0);
        expect(bench.edits.history.words.value).toBe('Nothing left to undo.');
    });

    it('says whose rake was not taken back and why', async () => {
        const bench = new Bench();
        bench.records([rakeOf('r1', { name: 'Low' }), rakeOf('r2')]);
        bench.edits.changeRake('r1', { seeds: 20 });
        bench.edits.flush();
        await bench.answer();
        void bench.edits.undo();
        await settled();
        await bench.answer(0, {
            undone: null,
            skipped: [{ type: 'rake', id: 'r1', why: 'rake r1 has been changed by someone else since' }],
        });
        expect(bench.edits.history.words.value).toBe('Not undone: Low has been changed by someone else since.');
        expect(bench.edits.history.redoable.value).toBe(0);
    });

    it('has nothing to redo after a new edit', async () => {
        const bench = new Bench();
        for (const seeds of [20, 21]) {
            bench.edits.changeRake('r1', { seeds });
            bench.edits.flush();
            await bench.answer();
            if (seeds === 20) {
                void bench.edits.undo();
                await settled();
                await bench.answer(0, undone);
                expect(bench.edits.history.redoable.value).toBe(1);
            }
        }
        expect(bench.edits.history.redoable.value).toBe(0);
    });
});
