// A socket that stays: it connects, notices silence, and connects again by itself until stopped.
// A network that drops packets closes nothing (docs/measurements.md, Broken networks), so only a heartbeat
// can tell: a ping every 4 s must keep messages coming, and 10 s without any message count as down.
import type { Clock, Timer } from './clock.ts';

const pingEveryMs = 4000;
const downAfterMs = 10_000;

const linkEnded = 4003;
/**
 * Closings after which coming back by oneself is of no use (protocol/api/README.md). Two pages that displace
 * each other would do so for ever.
 */
const endings: ReadonlyMap<number, string> = new Map([
    [4001, 'This session was opened in a newer window, so this window was disconnected.'],
    [4002, 'A host removed you from this session.'],
    [linkEnded, 'The link that opened this page has expired or was revoked.'],
    [4004, 'This browser is logged out of the server.'],
]);

/** The part of WebSocket used here, already open. */
export interface OpenSocket {
    send(data: string): void;
    close(): void;
    onmessage: ((event: { data: unknown }) => void) | null;
    onclose: ((event: { code: number; reason?: string }) => void) | null;
}

/** Thrown by a connector when trying again cannot help, for example without a valid token. */
export class HopelessError extends Error {}

export type ConnectionState =
    | { state: 'connecting'; attempt: number }
    | { state: 'open' }
    | { state: 'waiting'; attempt: number; retryInMs: number; reason: string }
    | { state: 'ended'; reason: string }
    | { state: 'refused'; reason: string }
    /** This page cannot work, whatever the server says. */
    | { state: 'broken'; reason: string };

export interface LiveSocketOptions {
    /** Resolves with an open socket; a HopelessError ends all attempts. */
    connect: () => Promise<OpenSocket>;
    clock: Clock;
    onState: (state: ConnectionState) => void;
    onMessage: (data: unknown) => void;
    /** Sends anything that the server answers. */
    ping: () => void;
}

export class LiveSocket {
    private readonly options: LiveSocketOptions;
    private readonly backOff: BackOff;
    private socket: OpenSocket | null = null;
    private timer: Timer | null = null;
    private attempt = 0;
    private heardAt = 0;
    private pingedAt = 0;
    private stopped = false;

    constructor(options: LiveSocketOptions) {
        this.options = options;
        this.backOff = new BackOff(() => options.clock.random());
    }

    /** Also once more, after connecting was refused. */
    start(): void {
        if (this.socket === null && this.timer === null) void this.connect();
    }

    /** Ends a wait for the next attempt early, for example when the browser is online again. */
    retryNow(): void {
        if (this.stopped || this.socket !== null || this.timer === null) return;
        this.clearTimer();
        void this.connect();
    }

    /** False when there is no connection; the message is then dropped. */
    send(text: string): boolean {
        if (this.socket === null) return false;
        this.socket.send(text);
        return true;
    }

    stop(): void {
        this.stopped = true;
        this.clearTimer();
        this.dropSocket();
    }

    private async connect(): Promise<void> {
        ++this.attempt;
        this.options.onState({ state: 'connecting', attempt: this.attempt });
        try {
            this.adopt(await this.options.connect());
        } catch (error) {
            const reason = error instanceof Error ? error.message : String(error);
            if (error instanceof HopelessError) this.options.onState({ state: 'refused', reason });
            else this.waitAndRetry(reason);
        }
    }

    private adopt(socket: OpenSocket): void {
        if (this.stopped) {
            socket.close();
            return;
        }
        this.socket = socket;
        this.attempt = 0;
        this.backOff.reset();
        this.heardAt = this.pingedAt = this.options.clock.now();
        socket.onmessage = (event) => {
            this.heardAt = this.options.clock.now();
            this.options.onMessage(event.data);
        };
        socket.onclose = ({ code, reason = '' }) => this.closed(code, reason);
        this.watch();
        this.options.onState({ state: 'open' });
    }

    private watch(): void {
        this.timer = this.options.clock.after(1000, () => {
            const now = this.options.clock.now();
            if (now - this.heardAt >= downAfterMs) {
                this.lose('No response from the server for 10 seconds.');
                return;
            }
            if (now - this.pingedAt >= pingEveryMs) {
                this.pingedAt = now;
                this.options.ping();
            }
            this.watch();
        });
    }

    private closed(code: number, why: string): void {
        const ending = endings.get(code);
        if (ending === undefined) {
            this.lose('The server closed the connection.');
            return;
        }
        this.stop();
        // A link ends for several reasons, and the server says which.
        const reason = code === linkEnded && why !== '' ? `${why.charAt(0).toUpperCase()}${why.slice(1)}.` : ending;
        this.options.onState({ state: 'ended', reason });
    }

    private lose(reason: string): void {
        this.dropSocket();
        this.waitAndRetry(reason);
    }

    private dropSocket(): void {
        if (this.socket === null) return;
        this.socket.onmessage = null;
        this.socket.onclose = null;
        this.socket.close();
        this.socket = null;
    }

    private waitAndRetry(reason: string): void {
        if (this.stopped) return;
        this.clearTimer();
        const retryInMs = this.backOff.nextWaitMs();
        this.options.onState({ state: 'waiting', attempt: this.attempt, retryInMs, reason });
        this.timer = this.options.clock.after(retryInMs, () => {
            this.timer = null;
            void this.connect();
        });
    }

    private clearTimer(): void {
        if (this.timer !== null) this.options.clock.cancel(this.timer);
        this.timer = null;
    }
}

const firstWaitMs = 250;
const longestWaitMs = 5000;

/**
 * Waits before the next attempt to connect: doubling from 250 ms to 5 s, each drawn from its upper half so that many clients of
 * one restarted server do not return in step.
 */
export class BackOff {
    private failures = 0;
    private readonly random: () => number;

    constructor(random: () => number) {
        this.random = random;
    }

    nextWaitMs(): number {
        const ceiling = Math.min(longestWaitMs, firstWaitMs * 2 ** this.failures);
        ++this.failures;
        return ceiling * (0.5 + 0.5 * this.random());
    }

    reset(): void {
        this.failures = 0;
    }
}
