// What the link carries in its fragment, which browsers never send: the access token, removed at
// once, and the session, kept so that the same link opens the same session.

export interface UrlState {
    token: string | null;
    session: string | null;
    dataset: string | null;
}

export function readFragment(fragment: string): UrlState {
    const values = new URLSearchParams(fragment.replace(/^#/, ''));
    const nonEmpty = (name: string): string | null => values.get(name) || null;
    return {
        token: nonEmpty('token'),
        session: nonEmpty('session'),
        dataset: nonEmpty('dataset'),
    };
}

/** The fragment of a link to a session; never with a token. */
export function writeFragment(session: string | null, dataset: string | null): string {
    const values = new URLSearchParams();
    if (session !== null) values.set('session', session);
    if (dataset !== null) values.set('dataset', dataset);
    const text = values.toString();
    return text === '' ? '' : `#${text}`;
}

/** Replaces the fragment in the address bar without a new entry in the history. */
export function showFragment(fragment: string): void {
    history.replaceState(null, '', location.pathname + location.search + fragment);
}

/** Address of the page without its last part: everything else is found relative to it. */
export function baseUrl(): string {
    return new URL('.', location.href).href;
}
