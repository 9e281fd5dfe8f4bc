// The page's end of the worker: calls as promises, events as callbacks.
import { errorWords, type MethodName, type ParamsOf, type ResultOf } from '../protocol/messages.ts';
import type {
    CallFailure,
    FromWorker,
    GeometryArrays,
    LatticeMessage,
    MessageOf,
    ToWorker,
} from './workerMessages.ts';

/** A call that the server refused or that no connection carried. */
export class CallError extends Error {
    readonly failure: CallFailure;

    constructor(failure: CallFailure) {
        super(errorWords(failure));
        this.name = 'CallError';
        this.failure = failure;
    }
}

export type WorkerEvent = Exclude<MessageOf<FromWorker>, { type: 'reply' } | { type: 'failure' }>;

interface Pending {
    resolve: (result: unknown) => void;
    reject: (error: Error) => void;
}

export class WorkerClient {
    private readonly worker: Worker;
    private readonly pending = new Map<number, Pending>();
    private nextId = 1;

    constructor(onEvent: (event: WorkerEvent) => void) {
        this.worker = new Worker(new URL('./sessionWorker.ts', import.meta.url), {
            type: 'module',
            name: 'wakesurf session',
        });
        this.worker.onmessage = ({ data }: { data: MessageOf<FromWorker> }) => {
            if (data.type === 'reply') this.settle(data.id)?.resolve(data.result);
            else if (data.type === 'failure') {
                this.settle(data.id)?.reject(new CallError(data.failure));
            } else onEvent(data);
        };
    }

    start(baseUrl: string, token: string | null): void {
        this.post({ type: 'start', baseUrl, token });
    }

    retryNow(): void {
        this.post({ type: 'retryNow' });
    }

    call<M extends MethodName>(method: M, params: ParamsOf<M>): Promise<ResultOf<M>> {
        return this.ask<ResultOf<M>>((id) => ({ type: 'call', id, method, params }));
    }

    obstacle(dataset: string, lattice: LatticeMessage): Promise<GeometryArrays | null> {
        return this.ask((id) => ({ type: 'obstacle', id, dataset, lattice }));
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
