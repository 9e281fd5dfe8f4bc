// The server of this page over HTTP, with the login that lets the page in.
import { isObject } from '../protocol/jsonRpc.ts';
import { faultOf } from './httpFault.ts';
import { KeptLogins, type KeptLogin } from './keptLogins.ts';

export class OwnServer {
    /** Address, with a slash at the end. */
    readonly base: string;
    private readonly kept: KeptLogins;
    private current: KeptLogin | null;

    /** @param session that is to be shown, if it is known */
    constructor(base: string, session: string | null = null) {
        this.base = base;
        this.kept = new KeptLogins(base);
        this.current = this.kept.recall(session);
    }

    get login(): string | null {
        return this.current?.login ?? null;
    }

    /** The page has logged in. */
    took(login: KeptLogin): void {
        this.current = login;
        this.kept.keep(login);
    }

    /** Another window has logged in while this one is not let in. */
    onOther(session: () => string | null, act: (login: string) => void): void {
        this.kept.onChange(() => {
            const other = this.kept.shared(session());
            if (other !== null && other.login !== this.login) act(other.login);
        });
    }

    /** A login is not good any more: the next that may be, or null. */
    ended(login: string, session: string | null): string | null {
        this.kept.drop(login);
        this.current = this.kept.shared(session);
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
        this.kept.drop(login);
        this.current = null;
        const answer: unknown = await reply.json().catch(() => null);
        return isObject(answer) && answer['durable'] === false ? notKept : '';
    }
}

const notKept =
    'The server could not write that down: after a restart of it, someone who has copied this login could use it. ' +
    'Whoever runs the server sees why in its log.';

/** A request that shows a login. */
export function signed(login: string | null, init: RequestInit = {}): RequestInit {
    if (login === null) return init;
    return { ...init, headers: { ...(init.headers as Record<string, string> | undefined), Authorization: `Bearer ${login}` } };
}
