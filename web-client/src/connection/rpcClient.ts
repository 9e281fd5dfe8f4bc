// Calls over one socket: numbers requests, matches replies, and takes no answer that is not what its method
// answers. Knows the envelope, not the socket.
import { encodeNotification, encodeRequest, type Incoming, RpcError } from '../protocol/jsonRpc.ts';
import { type MethodName, type ParamsOf, resultCheck, type ResultOf, UnreadableAnswer } from '../protocol/messages.ts';

/** The call went unanswered because the connection is down; it may or may not have been carried out. */
export class DisconnectedError extends Error {
    constructor() {
        super('The server cannot be reached at the moment.');
        this.name = 'DisconnectedError';
    }
}

interface Pending {
    resolve: (result: unknown) => void;
    reject: (error: Error) => void;
}

export class RpcClient {
    private readonly send: (text: string) => boolean;
    private readonly pending = new Map<number, Pending>();
    private nextId = 1;

    /** @param send false when there is no connection */
    constructor(send: (text: string) => boolean) {
        this.send = send;
    }

    /** @param signal cancels the call: the server answers that it is, and stops its work */
    call<M extends MethodName>(method: M, params: ParamsOf<M>, signal?: AbortSignal): Promise<ResultOf<M>> {
        const id = this.nextId++;
        return new Promise((resolve, reject) => {
            if (!this.send(encodeRequest(id, method, params))) {
                reject(new DisconnectedError());
                return;
            }
            const answered = (result: unknown): void => {
                const fault = resultCheck(method)(result);
                if (fault === null) resolve(result as ResultOf<M>);
                else reject(new UnreadableAnswer(method, fault));
            };
            this.pending.set(id, { resolve: answered, reject });
            signal?.addEventListener('abort', () => this.cancel(id));
        });
    }

    private cancel(id: number): void {
        if (this.pending.has(id)) this.send(encodeNotification('$/cancelRequest', { id }));
    }

    /** Takes a reply; one that no user waits for is ignored. */
    receive(incoming: Incoming): void {
        if (incoming.type === 'notification' || incoming.id === null) return;
        const waiting = this.pending.get(incoming.id);
        if (waiting === undefined) return;
        this.pending.delete(incoming.id);
        if (incoming.type === 'result') waiting.resolve(incoming.result);
        else waiting.reject(new RpcError(incoming.error));
    }

    /** The connection is gone: nothing pending will be answered. */
    disconnected(): void {
        const lost = [...this.pending.values()];
        this.pending.clear();
        for (const waiting of lost) waiting.reject(new DisconnectedError());
    }
}
