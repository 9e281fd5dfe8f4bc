import { describe, expect, it } from 'vitest';
import { AppState } from '../state/appState.ts';
import type { WorkerEvent } from '../worker/workerClient.ts';
import { handOut, type Receivers } from './workerEvents.ts';

function bench() {
    const state = new AppState();
    const heard: [who: string, what: unknown][] = [];
    const to = (who: string) => (what: unknown) => void heard.push([who, what]);
    const receivers: Receivers = {
        state,
        feed: { receive: to('feed'), troubled: async (...what) => void heard.push(['feed', what]) },
        news: { take: to('news'), unreadable: to('unreadable') },
        controller: { connectionChanged: to('controller') },
        server: { took: to('server') },
        loginEnded: to('ended'),
    };
    return { state, heard, hear: (event: WorkerEvent) => handOut(event, receivers) };
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

describe('what the worker sends', () => {
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

    it('goes to who keeps logins', () => {
        const { heard, hear } = bench();
        hear({ type: 'loggedIn', login: 'a', session: null });
        hear({ type: 'loginEnded', login: 'a' });
        expect(heard).toEqual([
            ['server', { login: 'a', session: null }],
            ['ended', 'a'],
        ]);
    });
});
