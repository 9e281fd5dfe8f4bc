// The server of this page over HTTP: the logins that this browser has there, requests that show one, and what went wrong with a request, in
// words. Storage belongs to one origin, port included, so no other program can read the logins, as it could a cookie; pages below other
// paths of the same origin can.
import { isObject } from '../protocol/jsonRpc.ts';
import { errorWords, readError } from '../protocol/messages.ts';

export class OwnServer {
    /** Address, with a slash at the end. */
    readonly base: string;
    private readonly store: LoginStore;
    private current: StoredLogin | null;

    /** @param session that is to be shown, if it is known */
    constructor(base: string, session: string | null = null) {
        this.base = base;
        this.store = new LoginStore(base);
        this.current = this.store.recall(session);
    }

    get login(): string | null {
        return this.current?.login ?? null;
    }

    /** The page has logged in. */
    loggedIn(login: StoredLogin): void {
        this.current = login;
        this.store.add(login);
    }

    /** Another window has logged in while this one is not let in. */
    onOther(session: () => string | null, act: (login: string) => void): void {
        this.store.onChange(() => {
            const other = this.store.shared(session());
            if (other !== null && other.login !== this.login) act(other.login);
        });
    }

    /** A login is not good any more: the next that may be, or null. */
    ended(login: string, session: string | null): string | null {
        this.store.remove(login);
        this.current = this.store.shared(session);
        return this.login;
    }

    /** @param path below the server's address */
    fetch(path: string, init: RequestInit = {}): Promise<Response> {
        return fetch(new URL(path, this.base), signed(this.login, init));
    }

    /** Ends this browser's login, with all that came by it. Error: in words. @returns what is to be said of
     *  it; empty: nothing */
    async logOut(): Promise<string> {
        const { login } = this;
        if (login === null) return '';
        let reply: Response;
        try {
            reply = await this.fetch('api/v1/logout', { method: 'POST' });
        } catch {
            throw new Error('The server cannot be reached, so you are still logged in. Try again when there is a connection.');
        }
        if (!reply.ok) throw new Error(`You are still logged in. ${(await faultOf(reply)).message}`);
        this.store.remove(login);
        this.current = null;
        const answer: unknown = await reply.json().catch(() => null);
        return isObject(answer) && answer['durable'] === false ? notDurable : '';
    }
}

const notDurable =
    'The server could not write that down: after a restart of it, someone who has copied this login could use it. ' +
    'Whoever runs the server sees why in its log.';

/** A request that shows a login. */
export function signed(login: string | null, init: RequestInit = {}): RequestInit {
    if (login === null) return init;
    return { ...init, headers: { ...(init.headers as Record<string, string> | undefined), Authorization: `Bearer ${login}` } };
}

export interface StoredLogin {
    /** What the server takes for a while in place of the token. */
    login: string;
    /** The only session it is good for; null: every one. */
    session: string | null;
}

const maxLogins = 16;

/** One list for each server, as several may be below paths of one origin. */
export class LoginStore {
    private readonly name: string;

    /** @param baseUrl address of the server, with a slash at the end */
    constructor(baseUrl: string) {
        this.name = `wakesurf.logins ${new URL(baseUrl).pathname}`;
    }

    /**
     * This window's own for that session, and else one of the browser's: a window goes from a session to a
     * copy and back.
     * @param session that is to be shown, if it is known
     */
    recall(session: string | null): StoredLogin | null {
        const own = this.read(() => sessionStorage);
        const fits = (each: StoredLogin): boolean => session === null || each.session === null || each.session === session;
        return own.find(fits) ?? this.shared(session) ?? own[0] ?? null;
    }

    /** The one that lets in most: a link that a user has others open takes nothing from who has more. */
    shared(session: string | null): StoredLogin | null {
        const all = this.read(() => localStorage);
        return (
            all.find((each) => each.session === null) ??
            all.find((each) => each.session === session) ??
            (session === null ? all[0] : undefined) ??
            null
        );
    }

    /** One takes the place of those for the same session. */
    add(made: StoredLogin): void {
        for (const place of [() => localStorage, () => sessionStorage]) {
            const others = this.read(place).filter(({ session }) => session !== made.session);
            this.write(place, [made, ...others].slice(0, maxLogins));
        }
    }

    /** It has ended. */
    remove(login: string): void {
        for (const place of [() => localStorage, () => sessionStorage]) {
            const all = this.read(place);
            const left = all.filter((each) => !sameLogin(each.login, login));
            if (left.length < all.length) this.write(place, left);
        }
    }

    /** Another window has logged in, or out. */
    onChange(act: () => void): void {
        addEventListener('storage', ({ key }) => {
            if (key === this.name) act();
        });
    }

    /** Browsers may be told to keep nothing: then each page needs its link. */
    private read(place: () => Storage): StoredLogin[] {
        try {
            const stored: unknown = JSON.parse(place().getItem(this.name) ?? '[]');
            return Array.isArray(stored) ? stored.filter(isStoredLogin) : [];
        } catch {
            return [];
        }
    }

    private write(place: () => Storage, logins: readonly StoredLogin[]): void {
        try {
            place().setItem(this.name, JSON.stringify(logins));
        } catch {
            // As said above.
        }
    }
}

/** Tells texts of one login: the server makes several texts, which begin alike. */
function sameLogin(a: string, b: string): boolean {
    return a.split('.')[0] === b.split('.')[0];
}

function isStoredLogin(value: unknown): value is StoredLogin {
    if (typeof value !== 'object' || value === null) return false;
    const { login, session } = value as Partial<Record<keyof StoredLogin, unknown>>;
    return typeof login === 'string' && (session === null || typeof session === 'string');
}

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
