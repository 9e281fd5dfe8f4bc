import { describe, expect, it } from 'vitest';
import { FakeClock, settled } from '../testing/fakes.ts';
import { BackOff, type ConnectionState, HopelessError, LiveSocket, type OpenSocket } from './liveSocket.ts';

class FakeSocket implements OpenSocket {
    sent: string[] = [];
    closed = false;
    onmessage: OpenSocket['onmessage'] = null;
    onclose: OpenSocket['onclose'] = null;

    send(data: string): void {
        this.sent.push(data);
    }

    close(): void {
        this.closed = true;
    }
}

class Bench {
    clock = new FakeClock();
    sockets: FakeSocket[] = [];
    states: ConnectionState[] = [];
    messages: unknown[] = [];
    pings = 0;
    failure: Error | null = null;
    live = new LiveSocket({
        clock: this.clock,
        connect: async () => {
            if (this.failure !== null) throw this.failure;
            const socket = new FakeSocket();
            this.sockets.push(socket);
            return socket;
        },
        onState: (state) => this.states.push(state),
        onMessage: (data) => this.messages.push(data),
        ping: () => ++this.pings,
    });

    async start(): Promise<void> {
        this.live.start();
        await settled();
    }

    get newest(): FakeSocket {
        return this.sockets[this.sockets.length - 1]!;
    }

    get state(): string | undefined {
        return this.states[this.states.length - 1]?.state;
    }
}

describe('LiveSocket', () => {
    it('pings every 4 s and stays open while anything is heard', async () => {
        const bench = new Bench();
        await bench.start();
        for (let i = 0; i < 30; ++i) {
            await bench.clock.pass(2000);
            bench.newest.onmessage?.({ data: 'x' });
        }
        expect(bench.pings).toBe(15);
        expect(bench.state).toBe('open');
        expect(bench.sockets).toHaveLength(1);
        expect(bench.messages).toHaveLength(30);
    });

    it('connects once more after it was refused, when it is started again', async () => {
        const bench = new Bench();
        bench.failure = new HopelessError('no');
        await bench.start();
        await bench.clock.pass(60_000);
        expect(bench.state).toBe('refused');
        bench.failure = null;
        await bench.start();
        expect(bench.state).toBe('open');
        await bench.start();
        expect(bench.sockets).toHaveLength(1);
    });

    it('counts 10 s of silence as down, although nothing was closed', async () => {
        const bench = new Bench();
        await bench.start();
        await bench.clock.pass(9000);
        expect(bench.state).toBe('open');
        await bench.clock.pass(1000);
        expect(bench.states.at(-1)).toMatchObject({ state: 'waiting', retryInMs: 250 });
        expect(bench.newest.closed).toBe(true);
        await bench.clock.pass(250);
        expect(bench.state).toBe('open');
        expect(bench.sockets).toHaveLength(2);
    });

    it('hears nothing of a socket that it has given up', async () => {
        const bench = new Bench();
        await bench.start();
        const [first] = bench.sockets;
        await bench.clock.pass(10_000);
        expect(first?.onmessage).toBeNull();
    });

    it('connects again after a close, with growing waits while it fails', async () => {
        const bench = new Bench();
        await bench.start();
        bench.failure = new Error('The server cannot be reached.');
        bench.newest.onclose?.({ code: 1006 });
        await bench.clock.pass(250 + 500 + 1000);
        const waits = bench.states.flatMap((s) => (s.state === 'waiting' ? [s.retryInMs] : []));
        expect(waits).toEqual([250, 500, 1000, 2000]);
        bench.failure = null;
        await bench.clock.pass(2000);
        expect(bench.state).toBe('open');
    });

    it('tries at once when told to', async () => {
        const bench = new Bench();
        bench.failure = new Error('down');
        await bench.start();
        bench.failure = null;
        bench.live.retryNow();
        await settled();
        expect(bench.state).toBe('open');
        await bench.clock.pass(1000);
        expect(bench.sockets).toHaveLength(1);
    });

    it('gives up when the server refuses it', async () => {
        const bench = new Bench();
        bench.failure = new HopelessError('wrong token');
        await bench.start();
        await bench.clock.pass(60_000);
        expect(bench.states).toEqual([
            { state: 'connecting', attempt: 1 },
            { state: 'refused', reason: 'wrong token' },
        ]);
    });

    it('does not send without a connection', async () => {
        const bench = new Bench();
        expect(bench.live.send('x')).toBe(false);
        await bench.start();
        expect(bench.live.send('y')).toBe(true);
        expect(bench.newest.sent).toEqual(['y']);
        bench.live.stop();
        await bench.clock.pass(60_000);
        expect(bench.sockets).toHaveLength(1);
    });

    it.each([
        [4001, /newer window/],
        [4002, /host removed you/],
        [4003, /expired or was revoked/],
        [4004, /logged out/],
    ])('does not come back by itself after code %i, and says why', async (code, why) => {
        const bench = new Bench();
        await bench.start();
        bench.newest.onclose?.({ code });
        bench.live.retryNow();
        await bench.clock.pass(600_000);
        expect(bench.sockets).toHaveLength(1);
        expect(bench.states.at(-1)).toEqual({ state: 'ended', reason: expect.stringMatching(why) as string });
    });

    it('says why a link has ended where the server does', async () => {
        const bench = new Bench();
        await bench.start();
        bench.newest.onclose?.({ code: 4003, reason: 'the session was deleted' });
        expect(bench.states.at(-1)).toEqual({ state: 'ended', reason: 'The session was deleted.' });
    });
});

describe('BackOff', () => {
    it('doubles from 250 ms up to 5 s', () => {
        const backOff = new BackOff(() => 1);
        const waits = Array.from({ length: 7 }, () => backOff.nextWaitMs());
        expect(waits).toEqual([250, 500, 1000, 2000, 4000, 5000, 5000]);
    });

    it('never waits less than half of that', () => {
        const backOff = new BackOff(() => 0);
        expect([backOff.nextWaitMs(), backOff.nextWaitMs()]).toEqual([125, 250]);
    });

    it('starts again after a success', () => {
        const backOff = new BackOff(() => 1);
        backOff.nextWaitMs();
        backOff.nextWaitMs();
        backOff.reset();
        expect(backOff.nextWaitMs()).toBe(250);
    });
});
