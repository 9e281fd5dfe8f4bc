import { signal } from '@preact/signals-core';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { settled } from '../connection/fakeClock.ts';
import type { DatasetEntry, RakeRecord, SurfaceRecord } from '../protocol/messages.ts';
import { AppState } from '../state/appState.ts';
import { CallError } from '../worker/workerClient.ts';
import { SessionController, type SessionControllerOptions } from './sessionController.ts';

const notFound = new CallError({ kind: 'rpc', code: -32004, message: 'there is none', hint: '' });
const disconnected = new CallError({ kind: 'disconnected', code: 0, message: 'gone', hint: '' });

function surfaceOf(id: string): SurfaceRecord {
    return { surface: id, rev: 1, epoch: 1, rake: 'r1', dataset: 'flow' } as SurfaceRecord;
}

/** A page and a server that keeps one session at a time; the test says what each call does. */
class Bench {
    state = new AppState();
    calls: string[] = [];
    subscribed: string[] = [];
    /** Imports that the page has begun to wait for, and whether its user has stopped that. */
    begun: string[] = [];
    left = signal(false);
    entry: Partial<DatasetEntry> = { state: 'ready' };
    records = { session: 'session-1', name: '', rakes: [] as RakeRecord[], surfaces: [] as SurfaceRecord[] };
    /** Thrown by the next call of a method. */
    refusals = new Map<string, CallError>();
    beforeSubscribed: (surface: string) => void = () => undefined;
    controller: SessionController;
    token = 't';
    /** So many calls had been made when the undo history was cleared. */
    clearedAfter = 0;
    private created = 1;

    constructor(session: string | null = 'session-1') {
        const worker = {
            call: (method: string, params: Record<string, unknown>) => this.answer(method, params),
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
        const people = { joined: () => undefined, patched: () => undefined };
        const scene = { setDomain: () => undefined };
        const url = { token: null, session, dataset: null, state: null };
        const progress = { progressed: () => undefined };
        const imports = { left: this.left, begin: async (dataset: string) => void this.begun.push(dataset) };
        const views = { restore: () => undefined, madeAnew: () => undefined };
        const parts = { state: this.state, worker, feed, edits, people, progress, imports, scene, url, views };
        this.controller = new SessionController(parts as unknown as SessionControllerOptions);
    }

    async connect(): Promise<void> {
        this.controller.handle({ type: 'connection', state: 'open' });
        for (let i = 0; i < 20; ++i) await settled();
    }

    /** Somebody else makes or deletes a surface. */
    patch(op: 'put' | 'delete', id: string): void {
        const surfaces = this.records.surfaces.filter((record) => record.surface !== id);
        this.records.surfaces = op === 'put' ? [...surfaces, surfaceOf(id)] : surfaces;
        const patches = [{ op, type: 'surface', id, record: surfaceOf(id) }];
        const notification = { method: 'session.patched', session: this.records.session, seq: 1, patches };
        this.controller.handle({ type: 'notification', notification } as never);
    }

    private async answer(method: string, params: Record<string, unknown>): Promise<unknown> {
        this.calls.push(method);
        await Promise.resolve();
        const refusal = this.refusals.get(method);
        this.refusals.delete(method);
        if (refusal !== undefined) throw refusal;
        if (method === 'server.info') return { apiLevel: 2, capabilities: [] };
        if (method === 'dataset.list') return { datasets: [{ dataset: 'flow', name: 'flow', ...this.entry }] };
        if (method === 'dataset.describe') {
            return { dataset: 'flow', bounds: [0, 1, 0, 1, 0, 1], times: [0], fields: [], velocity: 'u' };
        }
        if (method === 'session.create') {
            this.records = { session: `session-${++this.created}`, name: '', rakes: [], surfaces: [] };
            return { session: this.records.session };
        }
        if (method === 'session.join') {
            if (params['session'] !== this.records.session) throw notFound;
            return { snapshot: structuredClone(this.records), resumeToken: this.token, you: 'p1' };
        }
        if (method === 'rake.set') {
            const rake = `r${this.records.rakes.length + 1}`;
            this.records.rakes.push({ rake, rev: 1, ...params } as unknown as RakeRecord);
            return { rake, rev: 1, surfaces: [] };
        }
        if (method === 'surface.set') {
            const surface = `s${this.records.surfaces.length + 1}`;
            this.records.surfaces.push({ ...surfaceOf(surface), ...params, surface } as SurfaceRecord);
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

    it('shows a surface that somebody makes while it subscribes to the others', async () => {
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

    it('makes a forgotten session anew, also when the connection is lost in the middle of it', async () => {
        const bench = new Bench();
        const points = [[0, 0, 0], [1, 0, 0]] as RakeRecord['points'];
        for (const rake of ['r1', 'r2']) {
            bench.records.rakes.push({ rake, rev: 1, kind: 'line', points, seeds: 8, name: rake } as RakeRecord);
        }
        bench.records.surfaces = [surfaceOf('s1')];
        await bench.connect();
        expect(bench.state.rakes.value.size).toBe(2);

        bench.records = { session: 'nobody knows', name: '', rakes: [], surfaces: [] };
        bench.refusals.set('surface.set', disconnected);
        await bench.connect();
        expect(bench.state.rakes.value.size).toBe(2);

        await bench.connect();
        expect(bench.state.stage.value).toBe('running');
        expect(bench.records.rakes.map(({ name }) => name)).toEqual(['r1', 'r2']);
        expect(bench.records.surfaces).toHaveLength(1);
        // The records that were made anew are nobody's to undo.
        expect(bench.clearedAfter).toBeGreaterThan(bench.calls.lastIndexOf('surface.set'));
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
        bench.controller.handle({ type: 'connection', state: 'open' });
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

    it('goes on where somebody has stopped it before there was anything to see, and stays stopped after', async () => {
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
