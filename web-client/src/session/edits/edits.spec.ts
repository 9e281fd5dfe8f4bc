import { describe, expect, it } from 'vitest';
import { settled } from '../../connection/fakeClock.ts';
import type { RakeRecord, SurfaceRecord, Vec3 } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { LatencyLog } from '../../state/latency.ts';
import { CallError } from '../../worker/workerClient.ts';
import { Edits, type EditsOptions } from './edits.ts';

type Call = [method: string, params: Record<string, unknown>];

const leased = new CallError({ kind: 'rpc', code: -32011, message: 'rake r1 is being dragged by Ann', hint: 'force' });

function rakeOf(rake: string, rest: Partial<RakeRecord> = {}): RakeRecord {
    const points: Vec3[] = [[0, 0, 0], [0, 0, 1]];
    return { rake, rev: 1, kind: 'line', points, seeds: 8, name: rake, clipped: false, dragging: false, ...rest };
}

function surfaceOf(surface: string, rake: string): SurfaceRecord {
    const asked = { direction: 'forward', separation: 0.2, accuracy: 'balanced', fields: [] as string[] } as const;
    return { surface, rake, rev: 1, epoch: 1, kind: 'stream', dataset: 'd', from: 0, to: 4, ...asked } as SurfaceRecord & object as SurfaceRecord;
}

/** A page whose server answers when the test lets it. */
class Bench {
    state = new AppState();
    calls: Call[] = [];
    waiting: { resolve: (result: unknown) => void; reject: (error: Error) => void }[] = [];
    held = false;
    edits: Edits;

    constructor() {
        const worker = {
            call: (...call: Call) => {
                this.calls.push(call);
                return new Promise((resolve, reject) => this.waiting.push({ resolve, reject }));
            },
        };
        const options = { state: this.state, worker, latency: new LatencyLog(), requestFrame: () => undefined };
        this.edits = new Edits({ ...options, dragging: () => this.held } as unknown as EditsOptions);
        this.state.capabilities.value = ['lease'];
        this.records([rakeOf('r1'), rakeOf('r2')], [surfaceOf('s1', 'r1'), surfaceOf('s2', 'r2')]);
    }

    records(rakes: RakeRecord[], surfaces = [...this.state.surfaces.value.values()]): void {
        this.state.rakes.value = new Map(rakes.map((each) => [each.rake, each]));
        this.state.surfaces.value = new Map(surfaces.map((each) => [each.surface, each]));
        this.edits.recordsChanged();
    }

    drag(x: number, dragging = true): void {
        this.held = dragging;
        const shape = { kind: 'line', points: [[x, 0, 0], [0, 0, 1]] as Vec3[] } as const;
        this.edits.moveRake({ shape, dragging, movedAt: 1000 + x });
    }

    async answer(rev = 2, rest: object = {}): Promise<void> {
        this.waiting.shift()?.resolve({ rake: 'r1', rev, clipped: false, points: [], surfaces: [], skipped: [], ...rest });
        for (let i = 0; i < 6; ++i) await settled();
    }

    async refuse(error: Error): Promise<void> {
        this.waiting.shift()?.reject(error);
        for (let i = 0; i < 6; ++i) await settled();
    }

    get sent(): unknown[] {
        return this.calls.map(([, params]) => (params['points'] as Vec3[] | undefined)?.[0]?.[0] ?? params);
    }
}

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
        bench.records([rakeOf('r1', { rev: 2, points: [[4, 0, 0], [0, 0, 1]] }), rakeOf('r2')]);
        expect(bench.state.rakePoints.value[0]![0]).toBe(4);
    });

    it('goes back to where everybody sees it when somebody else holds the rake', async () => {
        const bench = new Bench();
        bench.drag(5);
        bench.edits.flush();
        await bench.refuse(leased);
        expect(bench.state.problems.all.value.get('rake r1')).toContain('wait until it is let go');
        bench.drag(6, false);
        bench.edits.flush();
        await bench.refuse(leased);
        expect(bench.state.rakePoints.value[0]![0]).toBe(0);
        expect(bench.state.editsPending.value).toBe(false);
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
        bench.records([rakeOf('r2')], [surfaceOf('s2', 'r2')]);
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
        const after = [...before.values()].map((each) => (each.surface === 's1' ? { ...each, separation: 0.5 } : each));
        const rakes = [rakeOf('r1'), rakeOf('r2')];
        const shown = [after, [...before.values()], after].map((surfaces) => {
            bench.records(rakes, surfaces);
            return bench.edits.intent.value?.separation;
        });
        expect(shown).toEqual([0.5, 0.2, 0.5]);
        bench.edits.changeSurface({ length: 3 });
        bench.edits.flush();
        expect(bench.calls.at(-1)![1]).toMatchObject({ to: 3, separation: 0.5 });
    });
});

describe('undo', () => {
    const undone = { undo: 0, redo: 0, skipped: [] };

    it('of several calls that fails on the way leaves the rest to undo, and the first part to redo', async () => {
        const bench = new Bench();
        for (const length of [5, 6, 7]) {
            bench.edits.changeSurface({ length });
            bench.edits.flush();
            await bench.answer(2, { surface: 's1', epoch: 2 });
        }
        bench.calls = [];
        const failing = bench.edits.undo();
        await settled();
        await bench.answer(0, undone);
        await bench.refuse(leased);
        await failing;
        const { history } = bench.edits;
        expect([history.undoable.value, history.redoable.value]).toEqual([1, 1]);
        void bench.edits.undo();
        for (let i = 0; i < 3; ++i) await bench.answer(0, undone);
        void bench.edits.redo();
        await settled();
        expect(bench.calls.map(([method]) => method)).toEqual([
            ...Array<string>(4).fill('history.undo'),
            'history.redo',
        ]);
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

    it('takes back a drag with one call, and several edits of one slider with as many as they were', async () => {
        const bench = new Bench();
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
        expect(bench.edits.history.undoable.value).toBe(2);
        bench.calls = [];
        void bench.edits.undo();
        for (let i = 0; i < 4; ++i) await bench.answer(0, undone);
        expect(bench.calls.map(([method]) => method)).toEqual(['history.undo', 'history.undo', 'history.undo']);
        void bench.edits.undo();
        await settled();
        await bench.answer(0, undone);
        expect(bench.calls).toHaveLength(4);
        expect([bench.edits.history.undoable.value, bench.edits.history.redoable.value]).toEqual([0, 2]);
        void bench.edits.redo();
        await settled();
        await bench.answer(0, undone);
        expect(bench.calls.at(-1)![0]).toBe('history.redo');
    });

    it('says whose rake was not taken back and why', async () => {
        const bench = new Bench();
        bench.records([rakeOf('r1', { name: 'Low' }), rakeOf('r2')]);
        bench.edits.changeRake('r1', { seeds: 20 });
        bench.edits.flush();
        await bench.answer();
        void bench.edits.undo();
        await settled();
        await bench.answer(0, { skipped: [{ type: 'rake', id: 'r1', why: 'rake r1 has been changed by somebody else since' }] });
        expect(bench.edits.history.words.value).toBe('Not taken back: Low has been changed by somebody else since.');
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
