import { afterEach, describe, expect, it, vi } from 'vitest';
import { FakeClock } from '../testing/fakes.ts';
import { HangPauses, Watchdog, WorkerClient } from './workerClient.ts';

class Bench {
    clock = new FakeClock();
    answers = true;
    slow = false;
    asked = 0;
    hangs = 0;
    watchdog = new Watchdog({
        clock: this.clock,
        ask: () => {
            ++this.asked;
            if (this.answers) this.watchdog.heard();
        },
        isSlow: () => this.slow,
        onHang: () => ++this.hangs,
    });
}

describe('Watchdog', () => {
    it('is content with a worker that answers', async () => {
        const bench = new Bench();
        bench.watchdog.heard();
        await bench.clock.pass(60_000);
        expect(bench.hangs).toBe(0);
        expect(bench.asked).toBe(60);
    });

    it('reports a worker that has not answered for two seconds, once', async () => {
        const bench = new Bench();
        bench.watchdog.heard();
        await bench.clock.pass(5000);
        bench.answers = false;
        await bench.clock.pass(2999);
        expect(bench.hangs).toBe(0);
        await bench.clock.pass(1);
        expect(bench.hangs).toBe(1);
        await bench.clock.pass(60_000);
        expect(bench.hangs).toBe(1);
    });

    it('gives it ten seconds on a page that is short of processor time', async () => {
        const bench = new Bench();
        bench.watchdog.heard();
        await bench.clock.pass(5000);
        [bench.answers, bench.slow] = [false, true];
        await bench.clock.pass(10_000);
        expect(bench.hangs).toBe(0);
        await bench.clock.pass(2000);
        expect(bench.hangs).toBe(1);
    });

    it('takes anything that is heard for an answer', async () => {
        const bench = new Bench();
        bench.answers = false;
        bench.watchdog.heard();
        for (let i = 0; i < 40; ++i) {
            await bench.clock.pass(1500);
            bench.watchdog.heard();
        }
        expect(bench.hangs).toBe(0);
    });

    it('waits for the first sign of life', async () => {
        const bench = new Bench();
        bench.answers = false;
        await bench.clock.pass(60_000);
        expect(bench.asked).toBe(0);
    });
});

describe('a page of which the worker hangs again and again', () => {
    it('waits longer each time, ten seconds at most, and as at first after a minute of peace', async () => {
        const clock = new FakeClock();
        const pauses = new HangPauses(clock);
        const waited: number[] = [];
        for (let i = 0; i < 6; ++i) {
            waited.push(pauses.next());
            await clock.pass(20_000);
        }
        expect(waited).toEqual([...waited].sort((a, b) => a - b));
        expect(waited[1]).toBe(2 * waited[0]!);
        expect(waited.at(-1)).toBe(10_000);
        await clock.pass(60_000);
        expect(pauses.next()).toBe(waited[0]);
    });
});

class FakeWorker {
    static last: FakeWorker;
    onmessage: (message: { data: unknown }) => void = () => undefined;
    posted: unknown[] = [];

    constructor() {
        FakeWorker.last = this;
    }

    postMessage(message: unknown): void {
        this.posted.push(message);
    }

    terminate(): void {}
}

describe('WorkerClient', () => {
    afterEach(() => vi.unstubAllGlobals());

    it('connects before the page is there, which hears of what has happened, and of the connection only how it is', () => {
        vi.stubGlobal('Worker', FakeWorker);
        const logins: unknown[] = [];
        const client = new WorkerClient('http://localhost/', { token: 'secret', login: null }, (login) => logins.push(login));
        const worker = FakeWorker.last;
        expect(worker.posted).toEqual([{ type: 'start', baseUrl: 'http://localhost/', token: 'secret', login: null }]);
        worker.onmessage({ data: { type: 'loggedIn', login: 'a.b', session: null } });
        expect(logins).toEqual([{ login: 'a.b', session: null }]);
        const [connecting, open, waiting] = ['connecting', 'open', 'waiting'].map((state) => ({ type: 'connection', state }));
        const notification = { type: 'notification', notification: { method: 'server.notice' } };
        for (const data of [connecting, notification, open]) worker.onmessage({ data });
        const heard: unknown[] = [];
        client.listen(
            () => false,
            (event) => heard.push(event),
        );
        worker.onmessage({ data: waiting });
        expect(heard).toEqual([notification, open, waiting]);
        client.stop();
    });
});
