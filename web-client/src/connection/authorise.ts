// Exchanges the token for a cookie, and opens the WebSocket with it. A browser hides why a WebSocket
// failed, so an ordinary request first finds out whether the server is there and lets us in.
import { subprotocol } from '../protocol/version.ts';
import { faultOf } from './httpFault.ts';
import { HopelessError, type OpenSocket } from './liveSocket.ts';

const requestTimeoutMs = 8000;

/** Error: HopelessError when the server refuses the token or asks for one we do not have. */
export async function authorise(baseUrl: string, token: string | null): Promise<void> {
    const response = await request(baseUrl, token);
    if (response.ok) return;
    if (response.status === 401) throw new HopelessError(token === null ? missingToken : wrongToken);
    // The token was not even looked at: it is the address that the server does not go by.
    if (response.status === 403) throw new HopelessError(wrongAddress((await faultOf(response)).message));
    throw await faultOf(response);
}

const missingToken =
    'This page needs the access token: open the whole link that wakesurf printed when it started, or that you were given, ' +
    'including the part after token=. If your link worked before, it has expired or its session was deleted.';
const wrongToken =
    'The server does not accept the access token of this link: open the link that wakesurf printed when it was last started. ' +
    'If someone gave you the link, it has expired or its session was deleted: ask for another.';
const wrongAddress = (why: string): string =>
    `The server does not accept this page’s address, ${location.origin}; this has nothing to do with the token. It says: ${why}.`;

async function request(baseUrl: string, token: string | null): Promise<Response> {
    const signal = AbortSignal.timeout(requestTimeoutMs);
    try {
        if (token === null) return await fetch(new URL('openrpc.json', baseUrl), { signal });
        return await fetch(new URL('api/v1/login', baseUrl), {
            method: 'POST',
            headers: { 'Content-Type': 'application/json' },
            // The cookie is for this path alone: behind a proxy, other programs have others.
            body: JSON.stringify({ token, path: new URL(baseUrl).pathname }),
            signal,
        });
    } catch {
        throw new Error('The server cannot be reached.');
    }
}

export function openWebSocket(baseUrl: string): Promise<OpenSocket> {
    const url = new URL('ws', baseUrl);
    url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
    const socket = new WebSocket(url, subprotocol);
    socket.binaryType = 'arraybuffer';
    return new Promise((resolve, reject) => {
        const timer = setTimeout(() => socket.close(), requestTimeoutMs);
        socket.onopen = () => {
            clearTimeout(timer);
            socket.onopen = null;
            resolve(socket as OpenSocket);
        };
        socket.onclose = () => {
            clearTimeout(timer);
            reject(new Error('The server refused the connection.'));
        };
    });
}
