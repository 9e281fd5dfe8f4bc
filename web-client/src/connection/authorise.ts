// Exchanges the token for a login, and opens the WebSocket with it. A browser hides why a WebSocket
// failed, so an ordinary request first finds out whether the server is there and lets us in.
import { isObject } from '../protocol/jsonRpc.ts';
import { subprotocol } from '../protocol/messages.ts';
import { faultOf, type StoredLogin } from './ownServer.ts';
import { HopelessError, type OpenSocket } from './liveSocket.ts';

const requestTimeoutMs = 8000;

export interface Credentials {
    /** The token of the server, or of a link. */
    token: string | null;
    /** The login that this browser has; one of the token's is extended by a week. */
    login: string | null;
}

/** The login that was shown is not good, and no token was. */
export class EndedLogin extends HopelessError {}

/** Null: the server lets every user in. Error: HopelessError when it refuses what we have, or asks for what
 *  we do not have. */
export async function authorise(baseUrl: string, shown: Credentials): Promise<StoredLogin | null> {
    const response = await request(baseUrl, shown);
    if (response.status === 401 && shown.token === null && shown.login !== null) throw new EndedLogin(endedLogin);
    if (response.status === 401) throw new HopelessError(shown.token === null ? missingToken() : wrongToken);
    // The token was not even looked at: it is the address that the server does not go by.
    if (response.status === 403) throw new HopelessError(wrongAddress((await faultOf(response)).message));
    if (!response.ok) throw await faultOf(response);
    return nothing(shown) ? null : readLogin(await response.json().catch(() => null));
}

function nothing({ token, login }: Credentials): boolean {
    return token === null && login === null;
}

function readLogin(answer: unknown): StoredLogin {
    const { login, session = null } = isObject(answer) ? answer : {};
    if (typeof login !== 'string' || (session !== null && typeof session !== 'string')) {
        throw new Error('The server answered the login in a way that this page does not understand.');
    }
    return { login, session };
}

const howToEnter =
    'Open the whole link that wakesurf printed when it was last started, or that you were given, including the part after token=. ' +
    'Or paste it here: whatever address is in it, its token is used at the address of this page.';
const missingToken = (): string =>
    `This page needs the access token: this browser is not logged in at ${location.origin}. A login is for one address, port included, ` +
    `so through a tunnel with another port it is needed again. ${howToEnter}`;
const endedLogin =
    'This page needs the access token again: this browser’s login has ended. The server was started with a new token, or without the ' +
    'folder that it keeps sessions in; or the login was not used for a week; or it came by a link that has expired or was revoked, or ' +
    `whose session was deleted. ${howToEnter}`;
const wrongToken =
    'The server does not accept the access token of this link: it was started with another one since. Open the link that wakesurf printed ' +
    'when it was last started, or paste it here. If someone gave you the link, it has expired or its session was deleted: ask for another.';
const wrongAddress = (why: string): string =>
    `The server does not accept this page’s address, ${location.origin}; this has nothing to do with the token. It says: ${why}.`;

async function request(baseUrl: string, shown: Credentials): Promise<Response> {
    const signal = AbortSignal.timeout(requestTimeoutMs);
    try {
        if (nothing(shown)) return await fetch(new URL('openrpc.json', baseUrl), { signal });
        const said = Object.entries(shown).filter(([, value]) => value !== null);
        return await fetch(new URL('api/v1/login', baseUrl), {
            method: 'POST',
            headers: { 'Content-Type': 'application/json' },
            body: JSON.stringify(Object.fromEntries(said)),
            signal,
        });
    } catch {
        throw new Error('The server cannot be reached.');
    }
}

/** A page can give a WebSocket no header: a subprotocol shows the login. */
export function openWebSocket(baseUrl: string, login: string | null): Promise<OpenSocket> {
    const url = new URL('ws', baseUrl);
    url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
    const socket = new WebSocket(url, login === null ? subprotocol : [subprotocol, `wakesurf.login.${login}`]);
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
