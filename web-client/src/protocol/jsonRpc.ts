// The JSON-RPC 2.0 envelope on text frames: requests and notifications out, replies and
// notifications in. The shapes of parameters and results are in messages.ts.

export interface RpcErrorObject {
    code: number;
    message: string;
    data?: unknown;
}

/** An error reply of the server. `kind` and `hint` come from `error.data` (protocol/api/README.md). */
export class RpcError extends Error {
    readonly code: number;
    readonly kind: string;
    readonly hint: string;

    constructor(object: RpcErrorObject) {
        super(object.message);
        this.name = 'RpcError';
        this.code = object.code;
        const data = isObject(object.data) ? object.data : {};
        this.kind = typeof data['kind'] === 'string' ? data['kind'] : '';
        this.hint = typeof data['hint'] === 'string' ? data['hint'] : '';
    }
}

export type Incoming =
    | { type: 'result'; id: number; result: unknown }
    | { type: 'error'; id: number | null; error: RpcErrorObject }
    | { type: 'notification'; method: string; params: Record<string, unknown> };

export function isObject(value: unknown): value is Record<string, unknown> {
    return typeof value === 'object' && value !== null && !Array.isArray(value);
}

export function encodeRequest(id: number, method: string, params: object): string {
    return JSON.stringify({ jsonrpc: '2.0', id, method, params });
}

export function encodeNotification(method: string, params: object): string {
    return JSON.stringify({ jsonrpc: '2.0', method, params });
}

/** Takes one text frame apart. Returns null for anything that is not JSON-RPC 2.0. */
export function parseIncoming(text: string): Incoming | null {
    let value: unknown;
    try {
        value = JSON.parse(text);
    } catch {
        return null;
    }
    if (!isObject(value) || value['jsonrpc'] !== '2.0') return null;
    const { id, method } = value;
    if (typeof method === 'string') {
        const params = isObject(value['params']) ? value['params'] : {};
        return id === undefined ? { type: 'notification', method, params } : null;
    }
    if (isErrorObject(value['error'])) {
        return { type: 'error', id: typeof id === 'number' ? id : null, error: value['error'] };
    }
    if (typeof id === 'number' && 'result' in value) {
        return { type: 'result', id, result: value['result'] };
    }
    return null;
}

function isErrorObject(value: unknown): value is RpcErrorObject & Record<string, unknown> {
    return isObject(value) && typeof value['code'] === 'number' && typeof value['message'] === 'string';
}
