// A link that a user pastes into a page that was not let in: what is to be done with it. Its address is not
// followed: through a tunnel, or a proxy, the page is at another one than the server has printed.
import { readFragment } from '../view/urlState.ts';

export type NewLink =
    /** It leads to where the page is: the token is all that is new. */
    | { to: 'here'; token: string }
    /** It is for another session of the same server. */
    | { to: 'session'; fragment: string };

/** Null: no token is in it. A token alone is good as well. @param here the session of the page */
export function readNewLink(text: string, here: string | null): NewLink | null {
    const words = text.trim();
    if (/^[\w-]{32,512}$/.test(words)) return { to: 'here', token: words };
    const address = addressOf(words);
    if (address === null) return null;
    const { token, session } = readFragment(address.hash);
    if (token === null) return null;
    return session === null || session === here ? { to: 'here', token } : { to: 'session', fragment: address.hash };
}

function addressOf(words: string): URL | null {
    // What the server prints may have been copied with the words before it.
    const found = /https?:\/\/\S+/.exec(words)?.[0];
    return found !== undefined && URL.canParse(found) ? new URL(found) : null;
}
