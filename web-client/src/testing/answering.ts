// A server for unit tests: a function answers what the page asks its worker.
import type { MethodName, ParamsOf, ResultOf } from '../protocol/messages.ts';

export type Asked = Record<string, unknown>;

export interface Answering {
    call: <M extends MethodName>(method: M, params: ParamsOf<M>, signal?: AbortSignal) => Promise<ResultOf<M>>;
}

/** @param answer returns what the server would, or a promise of it; what it throws is the refusal */
export function answering(answer: (method: MethodName, params: Asked, signal?: AbortSignal) => unknown): Answering {
    return {
        call: async <M extends MethodName>(method: M, params: ParamsOf<M>, signal?: AbortSignal) =>
            (await answer(method, params as Asked, signal)) as ResultOf<M>,
    };
}
