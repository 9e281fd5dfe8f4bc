// The state of a page as a part of its address: view and records, as JSON in base64url. A link opens the same
// view of the same session, and, where the server has forgotten the session, the same rakes and surfaces in a
// new one.
import { surfaceDefaults } from '../../protocol/generated/surface.ts';
import { isRakeRecord, isSurfaceRecord, type RakeRecord, type SurfaceRecord } from '../../protocol/messages.ts';
import { type PageView, readPageView } from '../../state/pageView.ts';

export interface LinkState {
    view: PageView;
    rakes: RakeRecord[];
    surfaces: SurfaceRecord[];
}

/** Longer addresses are cut by mail programs and chats; the records are left out then. */
const longestJson = 4500;
/** Is the number of significant digits below one; of other numbers, after the point. */
const digits = 6;

export function encodeLinkState({ view, rakes, surfaces }: LinkState): string {
    const whole = jsonOf({ v: view, r: rakes.map(keptOfRake), s: surfaces.map(keptOfSurface) });
    return base64Of(whole.length <= longestJson ? whole : jsonOf({ v: view }));
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
            .map((each) => completed(each, surfaceRest))
            .filter(isSurfaceRecord)
            .map(asToday),
    };
}

function keptOfRake({ rake, kind, points, seeds, name, colour }: RakeRecord): object {
    return { rake, kind, points, seeds, name, colour };
}

function keptOfSurface({ rev: _rev, epoch: _epoch, ...setting }: SurfaceRecord): object {
    return setting;
}

/** Holds what a link does not have: counters are the server's, and a link that was made before may lack what
 *  came since. */
const rakeRest = { name: '', colour: '#0072b2', author: '', clipped: false, dragging: false };
const surfaceRest = { ...surfaceDefaults, direction: 'forward', separation: 0 };

/** Before API level 5 `backward` went back from `from` also where `to` was later. Today it cannot be, so it
 *  means nothing else. */
function asToday(record: SurfaceRecord): SurfaceRecord {
    const { from, to, direction, releaseUntil } = record;
    if (direction !== 'backward' || !(to > from)) return record;
    const turned = { ...record, to: 2 * from - to };
    return releaseUntil !== undefined && releaseUntil > from ? { ...turned, releaseUntil: 2 * from - releaseUntil } : turned;
}

function completed(record: unknown, rest: object): unknown {
    return typeof record === 'object' && record !== null ? { ...rest, ...record, rev: 0, epoch: 0 } : null;
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
