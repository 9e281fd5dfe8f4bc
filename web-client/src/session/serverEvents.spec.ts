import { describe, expect, it } from 'vitest';
import type { DatasetEntry } from '../protocol/messages.ts';
import { AppState } from '../state/appState.ts';
import { sampleStatistics } from '../testing/records.ts';
import type { WorkerEvent } from '../worker/workerClient.ts';
import { dispatchWorkerEvent, type Receivers, ServerEvents } from './serverEvents.ts';

function bench() {
    const state = new AppState();
    let deleted = 0;
    const done: unknown[] = [];
    const progressed: unknown[] = [];
    const datasets: unknown[] = [];
    const unheard = (): void => undefined;
    const events = new ServerEvents({
        state,
        outcomes: { done: unheard },
        feed: { done: (_surface, _epoch, error) => void done.push(error), progressed: unheard, ranged: unheard },
        people: { patched: unheard },
        progress: { progressed: (...what) => void progressed.push(what) },
        longCalls: [{ progressed: unheard }],
        dataset: { patched: (entry) => void datasets.push(entry), stepsPatched: unheard },
        controller: { patched: unheard, deleted: async () => void ++deleted },
    });
    const hear = (kind: string, text?: string, surface?: string): void =>
        events.dispatch({ method: 'server.notice', kind, text, surface });
    const said = () => [...state.notices.all.value];
    return { state, hear, said, deleted: () => deleted, events, done, progressed, datasets };
}

describe('a notice of the server', () => {
    it('is shown whatever its kind, beside those about other things', () => {
        const { hear, said } = bench();
        hear('recordsKeptAside', 'two rakes could not be used: ask who runs the server');
        hear('carefulStart', 'the server died 3 times in a row.');
        expect(said()).toEqual([
            ['recordsKeptAside', 'Two rakes could not be used: ask who runs the server.'],
            ['carefulStart', 'The server died 3 times in a row.'],
        ]);
    });

    it('takes the place of the one that it answers', () => {
        const { hear, said } = bench();
        hear('notDurable', 'edits are not saved');
        hear('durableAgain', 'edits are saved again');
        expect(said()).toEqual([['durability', 'Edits are saved again.']]);
    });

    it('that was sent away does not come back because the session is joined again, but with another turn', () => {
        const { state, hear, said } = bench();
        hear('notDurable', 'edits are not saved');
        state.notices.solved('durability');
        hear('notDurable', 'edits are not saved');
        expect(said()).toEqual([]);
        hear('durableAgain', 'edits are saved again');
        hear('notDurable', 'edits are not saved');
        expect(said()).toEqual([['durability', 'Edits are not saved.']]);
    });

    it('that data were replaced comes back whenever that happens again', () => {
        const { state, hear, said } = bench();
        hear('dataReplaced', 'the data of flow have been replaced');
        state.notices.solved('dataReplaced');
        hear('dataReplaced', 'the data of flow have been replaced');
        expect(said()).toEqual([['dataReplaced', 'The data of flow have been replaced.']]);
    });

    it('for programs only, or before the connection is closed, is not shown', () => {
        const { state, hear, said, deleted } = bench();
        hear('catchingUp', undefined, 's1');
        expect([...state.catchingUp.value]).toEqual(['s1']);
        hear('caughtUp', undefined, 's1');
        expect(state.catchingUp.value.size).toBe(0);
        hear('linkEnded', 'the share link has expired');
        hear('sessionDeleted', 'the session was deleted');
        expect([said(), deleted()]).toEqual([[], 1]);
    });
});

describe('what the page cannot read', () => {
    it('is reported, once for the same reason', () => {
        const { state, events, said } = bench();
        const faults = ['rake r1.seeds is not a whole number', 'rake r2.name is not a text'];
        events.unreadable(faults);
        expect(said()).toEqual([
            [
                'unreadable',
                'This page cannot read what the server sent: rake r1.seeds is not a whole number and 1 more. Reload the page.',
            ],
        ]);
        state.notices.solved('unreadable');
        events.unreadable(faults);
        expect(said()).toEqual([]);
    });
});

describe('what the server tells', () => {
    it('of a surface is that it is whole, why there is none, or why it ends early', () => {
        const { events, done } = bench();
        const about = { method: 'surface.done', surface: 's1', epoch: 2 } as const;
        const error = { code: -32012, message: 'the rake is outside', kind: 'outsideDomain', hint: 'move it' };
        events.dispatch({ ...about, error });
        events.dispatch({ ...about, stats: sampleStatistics() });
        events.dispatch({ ...about, stats: sampleStatistics({ stopped: 'time-step 4 is damaged' }) });
        expect(done).toEqual([error, null, { message: 'The surface ends early: time-step 4 is damaged' }]);
    });

    it('of a call is how far it is, as a fraction where the server knows it', () => {
        const { events, progressed } = bench();
        events.dispatch({ method: '$/progress', token: 'a', value: { kind: 'report', message: 'refining', percentage: 25 } });
        events.dispatch({ method: '$/progress', token: 'a', value: { kind: 'begin' } });
        const far = { time: 3, quadsSoFar: 1200, remaining: 8.5, seconds: 4 };
        events.dispatch({ method: '$/progress', token: 'a', value: { kind: 'report', percentage: 50, ...far } });
        const unknown = { time: null, quads: null, remaining: null, seconds: null };
        expect(progressed).toEqual([
            ['a', { ...unknown, fraction: 0.25, message: 'refining' }],
            ['a', { ...unknown, fraction: null, message: '' }],
            ['a', { fraction: 0.5, message: '', time: 3, quads: 1200, remaining: 8.5, seconds: 4 }],
        ]);
    });

    it('of a dataset is its entry in the list', () => {
        const { events, datasets } = bench();
        const entry: DatasetEntry = {
            dataset: 'd',
            name: 'D',
            state: 'importing',
            steps: { ready: 3, total: 16 },
            progress: 0.2,
        };
        events.dispatch({ method: 'dataset.patched', ...entry });
        expect(datasets).toEqual([entry]);
    });
});

describe('what the worker sends', () => {
    function bench() {
        const state = new AppState();
        const heard: [who: string, what: unknown][] = [];
        const to = (who: string) => (what: unknown) => void heard.push([who, what]);
        const receivers: Receivers = {
            state,
            feed: { receive: to('feed'), troubled: async (...what) => void heard.push(['feed', what]) },
            events: { dispatch: to('news'), unreadable: to('unreadable') },
            controller: { connectionChanged: to('controller') },
            loginEnded: to('ended'),
        };
        return { state, heard, hear: (event: WorkerEvent) => dispatchWorkerEvent(event, receivers) };
    }

    const frame: WorkerEvent = {
        ...{
            type: 'surface',
            surface: 's1',
            epoch: 3,
            phase: 'final',
            time: 0,
            stateSum: 1,
            cells: 1,
            meshVertices: 4,
            keys: 1,
            deltas: 0,
            withheld: [],
            curved: false,
        },
        ...{ decodeMs: 1, vertices: 0, triangles: 0, fromVertex: 0, fromNormal: 0, fromSeed: 0, tFrom: 0, fromIndex: 0 },
        ...{ positions: new Float32Array(), normals: new Float32Array(), seeds: new Float32Array() },
        ...{ indices: new Uint32Array(), scalars: [], parts: null, cut: null, units: null, unresolved: null },
    };

    it('goes straight to the feed where it is a surface, or says that one does not fit together', () => {
        const { heard, hear } = bench();
        hear(frame);
        hear({ type: 'frameTrouble', surface: 's1', subscription: 7, reason: 'bad frame' });
        expect(heard).toEqual([
            ['feed', frame],
            ['feed', ['s1', 7, 'bad frame']],
        ]);
    });

    it('is news of the server, the state of the connection or how far away the server is', () => {
        const { state, heard, hear } = bench();
        const notification = { method: 'server.notice', kind: 'carefulStart', text: 'hello' } as const;
        hear({ type: 'notification', notification });
        hear({ type: 'unreadable', faults: ['rake r1.seeds is not a whole number'] });
        hear({ type: 'connection', state: 'open' });
        hear({ type: 'roundTrip', ms: 12 });
        expect(heard).toEqual([
            ['news', notification],
            ['unreadable', ['rake r1.seeds is not a whole number']],
            ['controller', { state: 'open' }],
        ]);
        expect(state.roundTripMs.value).toBe(12);
    });

    it('goes to who keeps logins where one has ended', () => {
        const { heard, hear } = bench();
        hear({ type: 'loginEnded', login: 'a' });
        expect(heard).toEqual([['ended', 'a']]);
    });
});
