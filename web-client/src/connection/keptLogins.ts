// The logins that this browser has at this address. Storage belongs to one origin, port included, so no other
// program can read them, as it could a cookie; pages below other paths of the same origin can.

export interface KeptLogin {
    /** Holds what the server takes for a while in place of the token. */
    login: string;
    /** The only session it is good for; null: every one. */
    session: string | null;
}

const mostKept = 16;

/** One list for each server, as several may be below paths of one origin. */
export class KeptLogins {
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
    recall(session: string | null): KeptLogin | null {
        const own = this.read(() => sessionStorage);
        const fits = (each: KeptLogin): boolean => session === null || each.session === null || each.session === session;
        return own.find(fits) ?? this.shared(session) ?? own[0] ?? null;
    }

    /** The one that lets in most: a link that a user has others open takes nothing from who has more. */
    shared(session: string | null): KeptLogin | null {
        const all = this.read(() => localStorage);
        return (
            all.find((each) => each.session === null) ??
            all.find((each) => each.session === session) ??
            (session === null ? all[0] : undefined) ??
            null
        );
    }

    /** One takes the place of those for the same session. */
    keep(made: KeptLogin): void {
        for (const place of [() => localStorage, () => sessionStorage]) {
            const others = this.read(place).filter(({ session }) => session !== made.session);
            this.write(place, [made, ...others].slice(0, mostKept));
        }
    }

    /** It has ended. */
    drop(login: string): void {
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
    private read(place: () => Storage): KeptLogin[] {
        try {
            const kept: unknown = JSON.parse(place().getItem(this.name) ?? '[]');
            return Array.isArray(kept) ? kept.filter(isKeptLogin) : [];
        } catch {
            return [];
        }
    }

    private write(place: () => Storage, logins: readonly KeptLogin[]): void {
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

function isKeptLogin(value: unknown): value is KeptLogin {
    if (typeof value !== 'object' || value === null) return false;
    const { login, session } = value as Partial<Record<keyof KeptLogin, unknown>>;
    return typeof login === 'string' && (session === null || typeof session === 'string');
}
