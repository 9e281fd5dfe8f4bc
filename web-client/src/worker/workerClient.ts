// The page's end of the worker: calls as promises, events as callbacks. A worker that hangs is replaced: it is asked every second and has
// two to answer, so that bytes that make a decoder run for ever cost one worker, not the page. On a page that is short of processor time it
// has ten: there it is late as everything is.
import type { Credentials } from '../connection/authorise.ts';
import type { StoredLogin } from '../connection/ownServer.ts';
import { type Clock, systemClock, type Timer } from '../connection/clock.ts';
import type { BodyMesh, BodyValues } from '../mesh/meshChange.ts';
import type { Lattice } from '../protocol/lattice.ts';
import { errorWords, type MethodName, type ParamsOf, type ResultOf } from '../protocol/messages.ts';
import type { CallFailure, FromWorker, MessageOf, ShowWish, ToWorker } from './workerMessages.ts';

/** A call that the server refused, that no connection carried, or of which this page does not understand the
 *  answer. */
export class CallError extends Error {
    readonly failure: CallFailure;

    constructor(failure: CallFailure) {
        super(errorWords(failure));
        this.name = 'CallError';
        this.failure = failure;
    }
}

export type WorkerEvent = Exclude<MessageOf<FromWorker>, { type: 'reply' | 'failure' | 'here' | 'loggedIn' }>;

const firstPauseMs = 500;

interface Pending {
    resolve: (result: unknown) => void;
    reject: (error: Error) => void;
}

export class WorkerClient {
    private readonly pending = new Map<number, Pending>();
    private readonly watchdog: Watchdog;
    private worker: Worker;
    private nextId = 1;
    private readonly pauses = new HangPauses(systemClock);
    private origin: { baseUrl: string; token: string | null; login: string | null } | null;
    private isSlow = (): boolean => true;
    private early: WorkerEvent[] = [];
    private onEvent = (event: WorkerEvent): void => this.keep(event);

    private readonly onLogin: (login: StoredLogin) => void;

    /** Connects, and stays connected. @param onLogin told at once, so that a page which is reloaded before it has begun is let in again */
    constructor(baseUrl: string, shown: Credentials, onLogin: (login: StoredLogin) => void) {
        this.onLogin = onLogin;
        this.origin = { baseUrl, ...shown };
        this.worker = this.makeWorker();
        this.connect();
        this.watchdog = new Watchdog({
            clock: systemClock,
            isSlow: () => this.isSlow(),
            ask: () => this.post({ type: 'areYouThere' }),
            onHang: () => this.replaceWorker(),
        });
    }

    /**
     * Hears of everything that is no answer to a call: at once of what came before.
     * @param isSlow of a page that draws less than it should, for want of processor time. Until it is known, the page is
     * being parsed, and everything is late.
     */
    listen(isSlow: () => boolean, onEvent: (event: WorkerEvent) => void): void {
        this.isSlow = isSlow;
        this.onEvent = onEvent;
        for (const event of this.early.splice(0)) onEvent(event);
    }

    /** Of the states of the connection the newest: an older one would be acted on as if it came now. */
    private keep(event: WorkerEvent): void {
        if (event.type === 'connection') this.early = this.early.filter(({ type }) => type !== 'connection');
        this.early.push(event);
    }

    private connect(): void {
        if (this.origin !== null) this.post({ type: 'start', ...this.origin });
    }

    private makeWorker(): Worker {
        const worker = new Worker(new URL('./sessionWorker.ts', import.meta.url), {
            type: 'module',
            name: 'wakesurf session',
        });
        worker.onmessage = ({ data }: { data: MessageOf<FromWorker> }) => {
            this.watchdog.heard();
            if (data.type === 'reply') this.settle(data.id)?.resolve(data.result);
            else if (data.type === 'failure') {
                this.settle(data.id)?.reject(new CallError(data.failure));
            } else if (data.type !== 'here') this.heard(data);
        };
        return worker;
    }

    private heard(event: Exclude<MessageOf<FromWorker>, { type: 'reply' | 'failure' | 'here' }>): void {
        if (event.type !== 'loggedIn') {
            this.onEvent(event);
            return;
        }
        if (this.origin !== null) this.origin.login = event.login;
        this.onLogin({ login: event.login, session: event.session });
    }

    /** For good: nothing is heard any more, and nothing connects again. */
    stop(): void {
        this.watchdog.stop();
        this.origin = null;
        this.worker.onmessage = null;
        this.worker.terminate();
    }

    /** It connects and joins again. */
    private replaceWorker(): void {
        this.worker.terminate();
        const retryInMs = this.pauses.next();
        const reason = 'The page was busy with one surface for too long.';
        this.onEvent({ type: 'connection', state: 'waiting', attempt: 1, retryInMs, reason });
        const lost = [...this.pending.values()];
        this.pending.clear();
        const failure = { kind: 'disconnected', code: 0, message: reason, hint: '' } as const;
        for (const waiting of lost) waiting.reject(new CallError(failure));
        setTimeout(() => {
            this.worker = this.makeWorker();
            this.connect();
        }, retryInMs);
    }

    /** A state of the surface is on the screen, or will never be. */
    taken(surface: string): void {
        this.post({ type: 'taken', surface });
    }

    /** What of a surface is drawn; until told, the speed. */
    show(surface: string, wish: ShowWish): void {
        this.post({ type: 'show', surface, ...wish });
    }

    forget(surface: string): void {
        this.post({ type: 'forget', surface });
    }

    /** Another token, after the first was refused. */
    logIn(token: string): void {
        if (this.origin !== null) this.origin = { ...this.origin, token };
        this.post({ type: 'logIn', token });
    }

    /** Takes what another window got, where this one is not let in. */
    takeLogin(login: string): void {
        this.post({ type: 'logIn', login });
    }

    retryNow(): void {
        this.post({ type: 'retryNow' });
    }

    notify<M extends 'presence.update'>(method: M, params: ParamsOf<M>): void {
        this.post({ type: 'notify', method, params });
    }

    /** @param signal cancels the call, which fails then with -32800 */
    call<M extends MethodName>(method: M, params: ParamsOf<M>, signal?: AbortSignal): Promise<ResultOf<M>> {
        return this.ask<ResultOf<M>>((id) => {
            signal?.addEventListener('abort', () => this.pending.has(id) && this.post({ type: 'cancel', id }));
            return { type: 'call', id, method, params };
        });
    }

    /** @param allPatches also those that are no part of the body */
    obstacle(dataset: string, lattice: Lattice, allPatches: boolean): Promise<BodyMesh | null> {
        return this.ask((id) => ({ type: 'obstacle', id, dataset, lattice, allPatches }));
    }

    /** Null where there is no obstacle. @param field empty: the velocity alone */
    bodyValues(dataset: string, lattice: Lattice, time: number, field: string, allPatches: boolean): Promise<BodyValues | null> {
        return this.ask((id) => ({ type: 'bodyValues', id, dataset, lattice, allPatches, time, field }));
    }

    private ask<Result>(message: (id: number) => MessageOf<ToWorker>): Promise<Result> {
        const id = this.nextId++;
        return new Promise((resolve, reject) => {
            this.pending.set(id, { resolve: (result) => resolve(result as Result), reject });
            this.post(message(id));
        });
    }

    private settle(id: number): Pending | undefined {
        const waiting = this.pending.get(id);
        this.pending.delete(id);
        return waiting;
    }

    private post(message: MessageOf<ToWorker>): void {
        this.worker.postMessage(message);
    }
}

const longestPauseMs = 10_000;
/** After that, what made it hang is over. */
const peaceMs = 60_000;

/** How long a page waits before it connects again: each time twice as long as before, until nothing has hung for a minute. */
export class HangPauses {
    private readonly clock: Pick<Clock, 'now'>;
    private last = Number.NEGATIVE_INFINITY;
    private pauseMs = firstPauseMs;

    constructor(clock: Pick<Clock, 'now'>) {
        this.clock = clock;
    }

    next(): number {
        const now = this.clock.now();
        this.pauseMs = now - this.last > peaceMs ? firstPauseMs : Math.min(2 * this.pauseMs, longestPauseMs);
        this.last = now;
        return this.pauseMs;
    }
}

const pingEveryMs = 1000;
const answerWithinMs = 2000;
const slowAnswerWithinMs = 10_000;

export interface WatchdogOptions {
    clock: Clock;
    /** Everything takes longer. */
    isSlow: () => boolean;
    ask: () => void;
    onHang: () => void;
}

export class Watchdog {
    private readonly options: WatchdogOptions;
    private timer: Timer | null = null;
    private pingedAt: number | null = null;

    constructor(options: WatchdogOptions) {
        this.options = options;
    }

    /** From the first sign of life on: loading may take its time. */
    heard(): void {
        this.pingedAt = null;
        if (this.timer === null) this.wait();
    }

    /** The worker is replaced; the new one is heard first. */
    stop(): void {
        if (this.timer !== null) this.options.clock.cancel(this.timer);
        this.timer = null;
        this.pingedAt = null;
    }

    private wait(): void {
        const { clock } = this.options;
        const due = clock.now() + pingEveryMs;
        this.timer = clock.after(pingEveryMs, () => this.check(clock.now() - due));
    }

    private check(lateMs: number): void {
        const { clock, ask, isSlow, onHang } = this.options;
        const now = clock.now();
        // This page itself stood still, as when the computer slept: an answer may be waiting to be heard.
        if (this.pingedAt !== null && lateMs > pingEveryMs) this.pingedAt = now;
        if (this.pingedAt !== null && now - this.pingedAt >= (isSlow() ? slowAnswerWithinMs : answerWithinMs)) {
            this.stop();
            onHang();
            return;
        }
        if (this.pingedAt === null) {
            this.pingedAt = now;
            ask();
        }
        this.wait();
    }
}
