import { signal } from '@preact/signals-core';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { answering, emptyStorage, settled } from '../testing/fakes.ts';
import { apiLevel, type DatasetEntry, type Patch, type SessionSnapshot } from '../protocol/messages.ts';
import { datasetOf, emptySnapshot, rakeOf, suggestionOf, surfaceOf } from '../testing/records.ts';
import { plainBody } from '../state/bodyLook.ts';
import { AppState } from '../state/appState.ts';
import { CallError } from '../worker/workerClient.ts';
import { Suggestions } from './sessions/defaultScene.ts';
import { OpenDataset } from './openDataset.ts';
import { SessionController } from './sessionController.ts';

const notFound = new CallError({ kind: 'rpc', code: -32004, message: 'there is none', hint: '' });
const refused = new CallError({ kind: 'rpc', code: -32602, message: 'not the first', hint: '' });
const disconnected = new CallError({ kind: 'disconnected', code: 0, message: 'gone', hint: '' });

/** A page and a server that keeps one session at a time; the test says what each call does. */
class Bench {
    state = new AppState();
    calls: string[] = [];
    /** The sessions that were asked for, null where the server was to choose. */
    joined: (string | null)[] = [];
    people = ['p1'];
    subscribed: string[] = [];
    /** Imports that the page has begun to wait for, and whether its user has stopped that. */
    begun: string[] = [];
    described: string[] = [];
    left = signal(false);
    entry: Partial<DatasetEntry> = { state: 'ready' };
    records: SessionSnapshot = emptySnapshot('session-1');
    edited = true;
    created = 'then';
    trash: string[] = [];
    /** Thrown by the next call of a method. */
    refusals = new Map<string, CallError>();
    beforeSubscribed: (surface: string) => void = () => undefined;
    controller: SessionController;
    token = 't';
    /** The number of calls that had been made when the undo history was cleared. */
    clearedAfter = 0;
    private made = 1;

    constructor(session: string | null = 'session-1', linked: string | null = null) {
        const { state } = this;
        const worker = {
            ...answering((method, params) => this.answer(method, params)),
            obstacle: () => Promise.resolve(null),
        };
        const feed = {
            reset: () => undefined,
            requested: () => undefined,
            removed: () => undefined,
            subscribe: async (surface: string) => {
                await Promise.resolve();
                this.beforeSubscribed(surface);
                if (!this.records.surfaces.some((record) => record.surface === surface)) throw notFound;
                this.subscribed.push(surface);
            },
        };
        const history = { clear: () => (this.clearedAfter = this.calls.length) };
        const edits = { reconnected: () => undefined, recordsChanged: () => undefined, history };
        const people = { joined: () => undefined };
        const scene = { setDomain: () => undefined, body: { set: () => undefined, remove: () => undefined } };
        const bodies = { of: async () => null };
        const url = { token: null, session, dataset: linked, state: null };
        const imports = { left: this.left, begin: async (dataset: string) => void this.begun.push(dataset) };
        const views = { restore: () => undefined, recovered: () => undefined };
        const thumbnails = { patched: () => undefined };
        const dataset = new OpenDataset({ state, view: { body: signal(plainBody) }, scene, worker, bodies, imports });
        const suggestions = new Suggestions(state, worker);
        const filled = () => undefined;
        const rest = { dataset, suggestions, feed, edits, people, views, thumbnails, url, filled };
        this.controller = new SessionController({ state, worker, ...rest });
    }

    async connect(): Promise<void> {
        this.controller.connectionChanged({ state: 'open' });
        for (let i = 0; i < 20; ++i) await settled();
    }

    /** Another user makes or deletes a surface. */
    patch(op: 'put' | 'delete', id: string): void {
        const surfaces = this.records.surfaces.filter((record) => record.surface !== id);
        this.records.surfaces = op === 'put' ? [...surfaces, surfaceOf(id)] : surfaces;
        const patch: Patch = op === 'put' ? { op, type: 'surface', id, record: surfaceOf(id) } : { op, type: 'surface', id };
        this.controller.patched(this.records.session, [patch]);
    }

    private async answer(method: string, params: Record<string, unknown>): Promise<unknown> {
        this.calls.push(method);
        await Promise.resolve();
        const refusal = this.refusals.get(method);
        this.refusals.delete(method);
        if (refusal !== undefined) throw refusal;
        if (method === 'server.info') return { apiLevel, capabilities: [] };
        if (method === 'dataset.list') return { datasets: [{ dataset: 'flow', name: 'flow', ...this.entry }] };
        if (method === 'dataset.describe') {
            this.described.push(String(params['dataset']));
            return datasetOf({ dataset: String(params['dataset']) });
        }
        if (method === 'dataset.suggest') return suggestionOf();
        if (method === 'session.create') {
            this.records = emptySnapshot(`session-${++this.made}`, String(params['name']));
            this.edited = false;
            return { session: this.records.session };
        }
        if (method === 'session.list') {
            const of = (session: string): object => ({ session, name: `${session}'s name`, edited: this.edited });
            const trashed = this.trash.map((session) => ({ ...of(session), deletedUntil: '2026-12-22T12:00:00Z' }));
            return { sessions: params['trash'] === true ? trashed : [of(this.records.session)] };
        }
        if (method === 'session.restore') {
            this.records = { ...this.records, session: String(params['session']) };
            this.trash = [];
            return {};
        }
        if (method === 'session.join') {
            this.joined.push((params['session'] as string | undefined) ?? null);
            const session = params['session'] ?? this.records.session;
            if (session !== this.records.session || this.trash.includes(String(session))) throw notFound;
            const people = { participants: this.people.map((participant) => ({ participant })), you: 'p1' };
            return { snapshot: structuredClone(this.records), resumeToken: this.token, created: this.created, ...people };
        }
        if (method === 'rake.set') {
            if (params['default'] === true && this.edited) throw refused;
            this.edited ||= params['default'] !== true;
            const rake = `r${this.records.rakes.length + 1}`;
            this.records.rakes.push(rakeOf(rake, params));
            return { rake, rev: 1, surfaces: [] };
        }
        if (method === 'surface.set') {
            const surface = `s${this.records.surfaces.length + 1}`;
            this.records.surfaces.push({ ...surfaceOf(surface), ...params, surface });
            return { surface, rev: 1, epoch: 1 };
        }
        throw new Error(`unexpected ${method}`);
    }
}

describe('the session on a page', () => {
    beforeEach(() => {
        vi.stubGlobal('history', { replaceState: () => undefined });
        vi.stubGlobal('location', { pathname: '/', search: '', href: 'http://localhost/' });
    });

    afterEach(() => vi.unstubAllGlobals());

    it('shows a surface that someone makes while it subscribes to the others', async () => {
        const bench = new Bench();
        bench.records.surfaces = [surfaceOf('s1'), surfaceOf('s2')];
        bench.beforeSubscribed = (surface) => {
            if (surface === 's2') bench.patch('put', 's3');
        };
        await bench.connect();
        expect(bench.state.stage.value).toBe('running');
        expect(bench.subscribed).toEqual(['s1', 's2', 's3']);
    });

    it('goes on when a surface is deleted while it subscribes', async () => {
        const bench = new Bench();
        bench.records.surfaces = [surfaceOf('s1'), surfaceOf('s2')];
        bench.beforeSubscribed = (surface) => {
            if (surface === 's1') bench.patch('delete', 's1');
        };
        await bench.connect();
        expect(bench.state.stage.value).toBe('running');
        expect(bench.subscribed).toEqual(['s2']);
    });

    it('puts back what a server has lost, also when the connection is lost in the middle of it', async () => {
        const bench = new Bench(null);
        bench.records.rakes = [rakeOf('r1'), rakeOf('r2')];
        bench.records.surfaces = [surfaceOf('s1')];
        await bench.connect();
        expect(bench.state.rakes.value.size).toBe(2);

        bench.records = emptySnapshot('session-1');
        [bench.edited, bench.token] = [false, 'of another life'];
        bench.refusals.set('surface.set', disconnected);
        await bench.connect();
        expect(bench.state.rakes.value.size).toBe(2);

        await bench.connect();
        expect(bench.state.stage.value).toBe('running');
        expect(bench.records.rakes.map(({ name }) => name)).toEqual(['r1', 'r2']);
        expect(bench.records.surfaces).toHaveLength(1);
        expect(bench.calls).not.toContain('session.create');
        // The records that were made anew are no user's to undo.
        expect(bench.clearedAfter).toBeGreaterThan(bench.calls.lastIndexOf('surface.set'));
    });

    it('leaves empty what someone has emptied while the page was away', async () => {
        const bench = new Bench(null);
        bench.records.rakes = [rakeOf('r1')];
        await bench.connect();
        bench.records.rakes = [];
        bench.token = 'of another life';
        await bench.connect();
        expect(bench.state.rakes.value.size).toBe(0);
        expect(bench.calls).not.toContain('rake.set');
    });

    it('lets another page that lost the same put it back first', async () => {
        const bench = new Bench(null);
        bench.records.rakes = [rakeOf('r1')];
        await bench.connect();
        bench.records = { ...bench.records, rakes: [], surfaces: [] };
        [bench.edited, bench.token, bench.people] = [false, 'of another life', ['p0', 'p1']];
        vi.useFakeTimers();
        bench.controller.connectionChanged({ state: 'open' });
        await vi.advanceTimersByTimeAsync(100);
        bench.records.rakes = [rakeOf('theirs')];
        await vi.advanceTimersByTimeAsync(5000);
        vi.useRealTimers();
        expect([...bench.state.rakes.value.keys()]).toEqual(['theirs']);
        expect(bench.calls).not.toContain('rake.set');
    });

    it('forgets what could be undone when the server has begun another life, and not when only the line broke', async () => {
        const bench = new Bench();
        bench.records.surfaces = [surfaceOf('s1')];
        await bench.connect();
        bench.clearedAfter = 0;
        await bench.connect();
        expect(bench.clearedAfter).toBe(0);
        bench.token = 'renewed';
        await bench.connect();
        expect(bench.clearedAfter).toBeGreaterThan(0);
    });
});

describe('a visit', () => {
    beforeEach(() => {
        vi.stubGlobal('location', { pathname: '/', search: '', href: 'http://localhost/' });
        emptyStorage('localStorage');
    });

    afterEach(() => {
        vi.useRealTimers();
        vi.unstubAllGlobals();
    });

    it('makes no session: the server says where a newcomer goes', async () => {
        const bench = new Bench(null);
        await bench.connect();
        expect(bench.joined[0]).toBeNull();
        expect(bench.calls).not.toContain('session.create');
        expect(bench.state.session.value).toBe('session-1');
    });

    it('leads back to the session of the last one', async () => {
        await new Bench(null).connect();
        const again = new Bench(null);
        await again.connect();
        expect(again.joined).toEqual(['session-1']);
    });

    it.each([
        ['was deleted', (bench: Bench) => (bench.records.session = 'main')],
        ['is another one of the same name', (bench: Bench) => (bench.created = 'later')],
    ])('leads to where newcomers go when that session %s', async (_, changed) => {
        await new Bench(null).connect();
        const again = new Bench(null);
        changed(again);
        await again.connect();
        expect(again.joined).toEqual(['session-1', null]);
        expect(again.state.stage.value).toBe('running');
    });

    it('leads to the session in which the dataset of its address was seen last', async () => {
        const other = new Bench('session-9');
        other.records.session = 'session-9';
        await other.connect();
        const seen = new Bench(null, 'flow');
        seen.records.session = 'session-9';
        await seen.connect();
        expect(seen.joined).toEqual(['session-9']);
        const asked = new Bench(null, 'another flow');
        asked.records.surfaces = [surfaceOf('s1')];
        await asked.connect();
        expect(asked.joined).toEqual([null]);
        expect(asked.state.notices.all.value.get('dataset')).toMatch(/does not have the dataset of this link/);
    });

    it('shows the dataset of its address where the session has several', async () => {
        const bench = new Bench(null, 'flow');
        bench.records.surfaces = [surfaceOf('s1', { dataset: 'another flow' }), surfaceOf('s2')];
        await bench.connect();
        expect(bench.state.dataset.value?.dataset).toBe('flow');
        expect(bench.state.notices.all.value.get('dataset')).toBeUndefined();
    });

    it('goes on with the dataset that was worked on when the connection is there again', async () => {
        const bench = new Bench();
        bench.records.surfaces = [surfaceOf('s2')];
        await bench.connect();
        bench.records.surfaces = [surfaceOf('s1', { dataset: 'another flow' }), surfaceOf('s2')];
        await bench.connect();
        expect([bench.state.stage.value, bench.described]).toEqual(['running', ['flow', 'flow']]);
    });

    it('puts a first rake and surface into a session that no one has edited, and only there', async () => {
        const fresh = new Bench(null);
        fresh.edited = false;
        await fresh.connect();
        expect(fresh.records).toMatchObject({ rakes: [{ name: 'Rake 1', default: true }], surfaces: [{ default: true }] });
        expect(fresh.edited).toBe(false);
        const emptied = new Bench(null);
        await emptied.connect();
        expect(emptied.state.stage.value).toBe('running');
        expect(emptied.records.rakes).toEqual([]);
    });

    it('goes on with the first rake where a page was closed before it had made a surface', async () => {
        const bench = new Bench(null);
        bench.edited = false;
        bench.records.rakes = [rakeOf('r1', { name: 'Rake 1' })];
        await bench.connect();
        expect(bench.calls).not.toContain('rake.set');
        expect(bench.records.surfaces).toMatchObject([{ rake: 'r1' }]);
    });

    it('of a session that is not there says so, and makes one only when asked to', async () => {
        const bench = new Bench('session-7');
        await bench.connect();
        expect(bench.state.stage.value).toBe('gone');
        expect(bench.state.gone.value).toEqual({ session: 'session-7', name: '', restorableUntil: null, remembered: false });
        expect(bench.calls).not.toContain('session.create');
        expect(bench.state.locked.value).toBe(true);
    });
});

describe('a session that is deleted while the page is in it', () => {
    beforeEach(() => {
        vi.stubGlobal('location', { pathname: '/', search: '', href: 'http://localhost/' });
        vi.useFakeTimers();
    });

    afterEach(() => {
        vi.useRealTimers();
        vi.unstubAllGlobals();
    });

    async function bereft(): Promise<Bench> {
        const bench = new Bench();
        bench.records.surfaces = [surfaceOf('s1')];
        bench.controller.connectionChanged({ state: 'open' });
        await vi.advanceTimersByTimeAsync(10);
        bench.trash = ['session-1'];
        void bench.controller.deleted();
        await vi.advanceTimersByTimeAsync(10);
        return bench;
    }

    it('is said to be in the trash, with what was on the screen, until someone restores it', async () => {
        const bench = await bereft();
        expect(bench.state.stage.value).toBe('gone');
        expect(bench.state.gone.value).toMatchObject({ name: "session-1's name", restorableUntil: '2026-12-22T12:00:00Z' });
        expect(bench.state.surfaces.value.size).toBe(1);
        expect([...bench.state.notices.all.value]).toEqual([]);
        bench.trash = [];
        await vi.advanceTimersByTimeAsync(6000);
        expect(bench.state.stage.value).toBe('running');
        expect(bench.state.gone.value).toBeNull();
    });

    it('comes back by the button', async () => {
        const bench = await bereft();
        await bench.controller.restore();
        expect(bench.calls).toContain('session.restore');
        expect(bench.state.stage.value).toBe('running');
    });

    it('is made again from what is on the screen where it is gone for good', async () => {
        const bench = new Bench();
        bench.records.rakes = [rakeOf('r1', { name: 'mine' })];
        bench.controller.connectionChanged({ state: 'open' });
        await vi.advanceTimersByTimeAsync(10);
        bench.records.session = 'main';
        void bench.controller.deleted();
        await vi.advanceTimersByTimeAsync(10);
        expect(bench.state.gone.value).toMatchObject({ restorableUntil: null, remembered: true });
        await bench.controller.recover();
        expect(bench.state.stage.value).toBe('running');
        expect(bench.state.session.value).toBe('session-2');
        expect(bench.records.rakes.map(({ name }) => name)).toEqual(['mine']);
    });
});

describe('a dataset that is imported first', () => {
    beforeEach(() => {
        vi.stubGlobal('history', { replaceState: () => undefined });
        vi.stubGlobal('location', { pathname: '/', search: '', hash: '' });
        vi.useFakeTimers();
    });
    afterEach(() => {
        vi.useRealTimers();
        vi.unstubAllGlobals();
    });

    const steps = (ready: number) => ({ ready, total: 9 });

    async function connected(entry: Partial<DatasetEntry>, left = false): Promise<Bench> {
        const bench = new Bench();
        bench.entry = entry;
        bench.left.value = left;
        bench.controller.connectionChanged({ state: 'open' });
        await vi.advanceTimersByTimeAsync(10);
        return bench;
    }

    it('is waited for, and shown from its first time-step on', async () => {
        const bench = await connected({ state: 'importing', steps: steps(0) });
        expect([bench.state.stage.value, bench.begun]).toEqual(['importing', ['flow']]);
        bench.entry = { state: 'importing', steps: steps(1) };
        await vi.advanceTimersByTimeAsync(1100);
        expect(bench.state.stage.value).toBe('running');
    });

    it('goes on where someone has stopped it before there was anything to see, and stays stopped after', async () => {
        expect((await connected({ state: 'stopped', steps: steps(0) })).begun).toEqual(['flow']);
        const shown = await connected({ state: 'stopped', steps: steps(4) });
        expect([shown.state.stage.value, shown.begun]).toEqual(['running', []]);
    });

    it('is not waited for by who has stopped waiting, until asked to again', async () => {
        const bench = await connected({ state: 'importing', steps: steps(0) });
        bench.left.value = true;
        bench.entry = { state: 'importing', steps: steps(3) };
        await vi.advanceTimersByTimeAsync(5000);
        expect(bench.state.stage.value).toBe('importing');
        expect(bench.state.datasetEntry.value?.steps?.ready).toBe(3);
        bench.left.value = false;
        await vi.advanceTimersByTimeAsync(1100);
        expect(bench.state.stage.value).toBe('running');
    });
});

describe('a server that refuses a page while it begins', () => {
    const busy = new CallError({ kind: 'rpc', code: -32014, message: 'there is not enough memory', hint: '' });

    beforeEach(() => {
        vi.useFakeTimers();
        vi.stubGlobal('history', { replaceState: () => undefined });
        vi.stubGlobal('location', new URL('http://server.example/'));
    });

    afterEach(() => {
        vi.useRealTimers();
        vi.unstubAllGlobals();
    });

    it.each(['session.join', 'dataset.list', 'dataset.describe'])('is asked again, without a reload: %s', async (method) => {
        const bench = new Bench();
        bench.patch('put', 's1');
        bench.refusals.set(method, busy);
        bench.controller.connectionChanged({ state: 'open' });
        await vi.advanceTimersByTimeAsync(10);
        expect(bench.state.stage.value).toBe('failed');
        expect(bench.state.notices.all.value.get('start')).toContain('not enough memory');
        await vi.advanceTimersByTimeAsync(6000);
        expect(bench.state.stage.value).toBe('running');
        expect(bench.state.notices.all.value.has('start')).toBe(false);
    });

    it('is asked again at once by who does not want to wait, and then no more', async () => {
        const bench = new Bench();
        bench.patch('put', 's1');
        bench.refusals.set('dataset.describe', busy);
        bench.controller.connectionChanged({ state: 'open' });
        await vi.advanceTimersByTimeAsync(10);
        bench.state.notices.remedyOf('start')!.act();
        await vi.advanceTimersByTimeAsync(10);
        expect(bench.state.stage.value).toBe('running');
        const calls = bench.calls.length;
        await vi.advanceTimersByTimeAsync(60_000);
        expect(bench.calls.length).toBe(calls);
    });

    it('of one surface leaves the others, and says which and why', async () => {
        const bench = new Bench();
        bench.patch('put', 's1');
        bench.patch('put', 's2');
        bench.beforeSubscribed = (surface) => {
            if (surface === 's1') throw busy;
        };
        bench.controller.connectionChanged({ state: 'open' });
        await vi.advanceTimersByTimeAsync(10);
        expect(bench.state.stage.value).toBe('running');
        expect(bench.subscribed).toEqual(['s2']);
        expect(bench.state.notices.all.value.get('surface s1')).toContain('not enough memory');
    });
});
