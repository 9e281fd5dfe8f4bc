import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { OwnServer } from '../../connection/ownServer.ts';
import type { SessionEntry } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { answering, emptyStorage } from '../../testing/fakes.ts';
import { CallError } from '../../worker/workerClient.ts';
import { rememberSession } from './joinSession.ts';
import { fitting, SessionList } from './sessionList.ts';

function entryOf(session: string, lastUsed = '2026-11-22T10:00:00Z'): SessionEntry {
    const counts = { participants: 0, rakes: 1, surfaces: 1, slices: 0, lines: 0, bookmarks: 0, annotations: 0 };
    return {
        session,
        name: `${session}'s name`,
        people: [],
        created: 'then',
        lastUsed,
        edited: true,
        thumbnail: false,
        ...counts,
    };
}

/** A server with sessions and a trash; the test says what it refuses. */
class Bench {
    kept = [entryOf('main', '2026-11-20T10:00:00Z'), entryOf('session-2')];
    trashed: SessionEntry[] = [];
    calls: [method: string, params: Record<string, unknown>][] = [];
    refusals = new Map<string, CallError>();
    opened: string[] = [];
    sessionList: SessionList;

    constructor() {
        const worker = answering((method, params) => {
            this.calls.push([method, params]);
            const refusal = this.refusals.get(method);
            if (refusal !== undefined) throw refusal;
            const session = String(params['session']);
            if (method === 'session.list') {
                return { sessions: params['trash'] === true ? this.trashed : this.kept, limit: 4, trashLimit: 9 };
            }
            if (method === 'session.delete') {
                this.trashed = this.kept.filter((each) => each.session === session);
                this.kept = this.kept.filter((each) => each.session !== session);
            }
            if (method === 'session.restore') [this.kept, this.trashed] = [[...this.kept, ...this.trashed], []];
            return { session: 'session-9', name: params['name'] ?? '', remaining: 1 };
        });
        this.sessionList = new SessionList({
            state: new AppState(),
            worker,
            server: new OwnServer('http://localhost/'),
            open: (to) => this.opened.push(to),
        });
    }

    get names(): (string | undefined)[] {
        return (this.sessionList.sessions.value ?? []).map(({ session }) => session);
    }
}

const full = new CallError({ kind: 'rpc', code: -32014, message: 'the server keeps at most 4 sessions', hint: 'session.delete' });

describe('the list of sessions', () => {
    it('has those used last first, and says how many more there can be', async () => {
        const { sessionList, ...bench } = new Bench();
        await sessionList.refresh();
        expect(sessionList.sessions.value!.map(({ session }) => session)).toEqual(['session-2', 'main']);
        expect([sessionList.remaining.value, sessionList.ownOnly.value]).toEqual([2, false]);
        expect(bench.opened).toEqual([]);
    });

    it('knows a share link by its having no way to main', async () => {
        const bench = new Bench();
        bench.kept = [entryOf('session-2')];
        await bench.sessionList.refresh();
        expect(bench.sessionList.ownOnly.value).toBe(true);
    });

    it('takes a deleted session back by the button that it offers', async () => {
        const bench = new Bench();
        await bench.sessionList.delete(entryOf('session-2'));
        expect([bench.names, bench.sessionList.trash.value!.length]).toEqual([['main'], 1]);
        bench.sessionList.notices.remedyOf('done')!.act();
        await vi.waitFor(() => expect(bench.names).toContain('session-2'));
        expect(bench.sessionList.notices.all.value.get('done')).toMatch(/was restored/);
    });

    it('says a limit with what can be done on the page', async () => {
        const bench = new Bench();
        bench.refusals.set('session.create', full);
        await bench.sessionList.create('Wake', null);
        const words = bench.sessionList.problems.all.value.get('action');
        expect(words).toBe(
            'The server keeps at most 4 sessions. Export the sessions that are no longer needed, and delete them.',
        );
        expect(bench.opened).toEqual([]);
        bench.refusals.clear();
        await bench.sessionList.create('Wake', 'sqcyl');
        expect(bench.sessionList.problems.all.value.size).toBe(0);
        expect(bench.opened).toEqual(['#session=session-9&dataset=sqcyl']);
    });

    it('copies under a name that the server takes, however long the first is', async () => {
        const bench = new Bench();
        await bench.sessionList.copy({ ...entryOf('main'), name: 'ü'.repeat(60) });
        const [, params] = bench.calls.find(([method]) => method === 'session.fork')!;
        expect(params).toEqual({ session: 'main', name: `${'ü'.repeat(57)} copy` });
        expect(fitting('Wake', ' copy')).toBe('Wake copy');
    });
});

describe('another dataset', () => {
    beforeEach(() => {
        vi.stubGlobal('location', { pathname: '/', href: 'http://localhost/' });
        emptyStorage('localStorage');
    });
    afterEach(() => vi.unstubAllGlobals());

    it('opens in the session where it was seen last, and in a new one where there is none', async () => {
        rememberSession({ session: 'session-2', created: 'then', dataset: 'tornado' });
        const bench = new Bench();
        await bench.sessionList.enterDataset('tornado', 'Tornado');
        bench.kept = bench.kept.filter(({ session }) => session !== 'session-2');
        await bench.sessionList.enterDataset('tornado', 'Tornado');
        expect(bench.opened).toEqual(['#session=session-2&dataset=tornado', '#session=session-9&dataset=tornado']);
        expect(bench.calls.filter(([method]) => method === 'session.create')).toEqual([['session.create', { name: 'Tornado' }]]);
    });
});

describe('a file of a session', () => {
    afterEach(() => vi.unstubAllGlobals());

    it('is made a session of, and what of it differs is said', async () => {
        const made = { session: 'session-9', name: 'Wake', remaining: 1, notes: ['The dataset tornado is not on this server.'] };
        vi.stubGlobal('fetch', async (url: URL) => Response.json({ ...made, url: url.href }));
        const { sessionList, opened } = new Bench();
        await sessionList.import(new Blob(['{}']));
        expect(sessionList.notices.all.value.get('done')).toBe('“Wake” was imported. The dataset tornado is not on this server.');
        sessionList.notices.remedyOf('done')!.act();
        expect(opened).toEqual(['#session=session-9']);
    });

    it.each([
        [
            'the server refuses it',
            () => Response.json({ error: { message: 'it is no session', data: { hint: 'export one' } } }, { status: 400 }),
            /no session: export one/,
        ],
        ['there is no connection', () => Promise.reject(new TypeError('failed')), /cannot be reached/],
    ])('is answered in words where %s', async (_, reply, words) => {
        vi.stubGlobal('fetch', async () => reply());
        const { sessionList } = new Bench();
        await sessionList.import(new Blob(['{}']));
        expect(sessionList.problems.all.value.get('action')).toMatch(words);
        expect(await sessionList.export({ session: 'main' })).toBeNull();
    });

    it('is not sent where it is larger than the server takes', async () => {
        const asked = vi.fn();
        vi.stubGlobal('fetch', asked);
        const { sessionList } = new Bench();
        await sessionList.import({ size: 30 << 20 } as Blob);
        expect(sessionList.problems.all.value.get('action')).toMatch(/30 MiB; a session file is at most 24 MiB/);
        expect(asked).not.toHaveBeenCalled();
    });
});
