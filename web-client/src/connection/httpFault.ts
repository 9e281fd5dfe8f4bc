// Says what went wrong with a request over HTTP, in words: the server's own, where it sent any.
import { isObject } from '../protocol/jsonRpc.ts';
import { errorWords, readError } from '../protocol/messages.ts';

/** Returns the fault of an answer that is no success. */
export async function faultOf(reply: Response): Promise<Error> {
    const body: unknown = await reply.json().catch(() => null);
    const fault = isObject(body) && isObject(body['error']) ? body['error'] : null;
    const data = fault !== null && isObject(fault['data']) ? fault['data'] : {};
    const read = readError({ message: fault?.['message'], hint: data['hint'] });
    return new Error(read === null ? `The server answered with status ${reply.status}.` : errorWords(read));
}

/** Says in words what fetch() has thrown, or faultOf has returned. */
export function requestWords(error: unknown): string {
    if (error instanceof TypeError) return 'The server cannot be reached.';
    return error instanceof Error ? error.message : String(error);
}
