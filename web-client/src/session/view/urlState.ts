// Reads and writes what the link carries in its fragment, which browsers never send: the access token,
// removed at once; the session and the state of the page, kept so that the same link opens the same picture.
import { decodeLinkState, type LinkState } from './linkState.ts';

export interface UrlState {
    token: string | null;
    session: string | null;
    dataset: string | null;
    state: LinkState | null;
}

export function readFragment(fragment: string): UrlState {
    const values = new URLSearchParams(fragment.replace(/^#/, ''));
    const nonEmpty = (name: string): string | null => values.get(name) || null;
    const state = nonEmpty('state');
    return {
        token: nonEmpty('token'),
        session: nonEmpty('session'),
        dataset: nonEmpty('dataset'),
        state: state === null ? null : decodeLinkState(state),
    };
}

/** The fragment of a link to a session; never with a token. `state`: as encodeLinkState makes it. */
export function writeFragment(session: string | null, dataset: string | null, state: string | null = null): string {
    const values = new URLSearchParams();
    if (session !== null) values.set('session', session);
    if (dataset !== null) values.set('dataset', dataset);
    if (state !== null) values.set('state', state);
    const text = values.toString();
    return text === '' ? '' : `#${text}`;
}

let leaving = false;

/** Replaces the fragment in the address bar without a new entry in the history. */
export function showFragment(fragment: string): void {
    // The address is that of the page which comes next.
    if (!leaving) history.replaceState(null, '', location.pathname + location.search + fragment);
}

/** Starts again at another fragment; the browser's Back leads here again. */
export function openFragment(fragment: string): void {
    leaving = true;
    history.pushState(null, '', location.pathname + location.search + fragment);
    location.reload();
}

/** Back and forward between sessions: of the same page, the browser changes nothing but the address. */
export function followHistory(session: () => string | null): void {
    addEventListener('popstate', () => {
        if (readFragment(location.hash).session === session()) return;
        leaving = true;
        location.reload();
    });
}

/** Address of the page without its last part: everything else is found relative to it. */
export function baseUrl(): string {
    return new URL('.', location.href).href;
}
