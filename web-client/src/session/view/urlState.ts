// The link of a page. Its fragment, which browsers never send, carries the access token, removed at once, the session, and the state of the
// page: view and records, as JSON in base64url. A link opens the same view of the same session, and, where the server has forgotten the
// session, the same content in a new one. Of a link that a user pastes into a page that was not let in, the address is not
// followed: through a tunnel, or a proxy, the page is at another one than the server has printed.
import { surfaceDefaults } from '../../protocol/generated/surface.ts';
import {
    isLinesRecord,
    isRakeRecord,
    isSliceRecord,
    isSurfaceRecord,
    type LinesRecord,
    type RakeRecord,
    type SliceRecord,
    type SurfaceRecord,
} from '../../protocol/messages.ts';
import { type PageView, readPageView } from '../../state/pageView.ts';

export interface UrlState {
    token: string | null;
    session: string | null;
    dataset: string | null;
    state: LinkState | null;
    /** Of the right half of a comparison: the address bar, and what this browser remembers, are the left one's. */
    beside?: true;
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

export interface LinkState {
    view: PageView;
    rakes: RakeRecord[];
    surfaces: SurfaceRecord[];
    slices: SliceRecord[];
    lines: LinesRecord[];
}

/** Longer addresses are cut by mail programs and chats; slices and streamlines are left out then, or all records. */
const longestJson = 4500;
/** The number of significant digits below one; of other numbers, after the point. */
const digits = 6;

/** Records that are left out: there are none. */
export function encodeLinkState({ view, rakes = [], surfaces = [], slices = [], lines = [] }: Partial<LinkState>): string {
    const beside = { ...(slices.length > 0 && { p: slices.map(saved) }), ...(lines.length > 0 && { l: lines.map(saved) }) };
    const fewer = { v: view, r: rakes.map(savedRake), s: surfaces.map(saved) };
    const fits = [{ ...fewer, ...beside }, fewer].map(jsonOf).find((each) => each.length <= longestJson);
    return base64Of(fits ?? jsonOf({ v: view }));
}

/** Returns what can be read of it; never throws. */
export function decodeLinkState(text: string): LinkState {
    const value = valueOf(text);
    const list = (name: string): unknown[] => (Array.isArray(value[name]) ? value[name] : []);
    return {
        view: readPageView(value['v']),
        rakes: list('r')
            .map((each) => completed(each, rakeRest))
            .filter(isRakeRecord),
        surfaces: list('s')
            .map((each) => completed(each, surfaceRest, { rev: 0, epoch: 0 }))
            .filter(isSurfaceRecord)
            .map(asToday),
        slices: list('p')
            .map((each) => completed(each, {}))
            .filter(isSliceRecord),
        lines: list('l')
            .map((each) => completed(each, linesRest))
            .filter(isLinesRecord),
    };
}

function savedRake({ rake, kind, points, seeds, name, colour }: RakeRecord): object {
    return { rake, kind, points, seeds, name, colour };
}

/** Without what counters of the server say. */
function saved({ rev: _rev, epoch: _epoch, ...setting }: { rev: number; epoch?: number }): object {
    return setting;
}

/** What a link does not have: counters are the server's, and a link that was made before may lack what
 *  came since. */
const rakeRest = { name: '', colour: '#0072b2', author: '', clipped: false, dragging: false };
const linesRest = { patches: [] };
const surfaceRest = { ...surfaceDefaults, direction: 'forward', separation: 0 };

/** Before API level 5 `backward` went back from `from` also where `to` was later. Today it cannot be, so it
 *  means nothing else. */
function asToday(record: SurfaceRecord): SurfaceRecord {
    const { from, to, direction, releaseUntil } = record;
    if (direction !== 'backward' || !(to > from)) return record;
    const turned = { ...record, to: 2 * from - to };
    return releaseUntil !== undefined && releaseUntil > from ? { ...turned, releaseUntil: 2 * from - releaseUntil } : turned;
}

function completed(record: unknown, rest: object, counters: object = { rev: 0 }): unknown {
    return typeof record === 'object' && record !== null ? { ...rest, ...record, ...counters } : null;
}

function jsonOf(value: object): string {
    return JSON.stringify(value, (_, each: unknown) =>
        typeof each === 'number' && !Number.isInteger(each) ? Number(each.toPrecision(digitsOf(each))) : each,
    );
}

/** A place far from the origin keeps its decimals, and one near it its digits. */
function digitsOf(value: number): number {
    const whole = Math.floor(Math.log10(Math.abs(value))) + 1;
    return Math.min(15, digits + Math.max(0, whole));
}

function base64Of(json: string): string {
    let bytes = '';
    for (const byte of new TextEncoder().encode(json)) bytes += String.fromCharCode(byte);
    return btoa(bytes).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

function valueOf(text: string): Record<string, unknown> {
    try {
        const bytes = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
        const json = new TextDecoder().decode(Uint8Array.from(bytes, (each) => each.charCodeAt(0)));
        const value: unknown = JSON.parse(json);
        return typeof value === 'object' && value !== null ? (value as Record<string, unknown>) : {};
    } catch {
        return {};
    }
}

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
