// What a link or a bookmark remembers of a page, which is how one person looks at the session: the view as a whole, what of the session is
// shown and which rakes may be moved, and the planes that cut the picture open. Read from strangers and from older versions, so that
// anything may be missing or wrong in it; that is left out.
import { type BodyLook, decodeBody, encodeBody } from './bodyLook.ts';
import { isVec3, type Vec3 } from '../protocol/messages.ts';
import { decodeLook, encodeLook, type SurfaceLook } from './surfaceLook.ts';

export interface PageView {
    camera?: { position: Vec3; target: Vec3; orthographic: boolean };
    /** The surface that the panel acts on. */
    surface?: string;
    /** By surface, what differs from the usual look. */
    looks?: Record<string, Partial<SurfaceLook>>;
    clip?: ClipPlanes;
    /** What differs from the usual look of the body. */
    body?: Partial<BodyLook>;
    /** By surface, what the painter has revealed, as the scene encodes it. */
    masks?: Record<string, string>;
    /** What is hidden or locked, as encodeVisibility makes it; not there: nothing. */
    shown?: object;
}

const maxLooks = 100;
const maskText = /^[\w-]{1,800}$/;

export function readPageView(value: unknown): PageView {
    const view: PageView = {};
    if (typeof value !== 'object' || value === null) return view;
    const { camera, surface, looks, clip, body, bodyTexture, masks, shown } = value as Record<string, unknown>;
    const pose = camera as Record<string, unknown> | null | undefined;
    const [position, target] = [pose?.['position'], pose?.['target']];
    if (isVec3(position) && isVec3(target) && String(position) !== String(target)) {
        view.camera = { position, target, orthographic: pose?.['orthographic'] === true };
    }
    if (typeof surface === 'string') view.surface = surface;
    if (typeof looks === 'object' && looks !== null) {
        const known = Object.entries(looks).slice(0, maxLooks);
        view.looks = Object.fromEntries(known.map(([id, look]) => [id, encodeLook(decodeLook(look))]));
    }
    if (typeof masks === 'object' && masks !== null) {
        const isText = (each: [string, unknown]): each is [string, string] =>
            typeof each[1] === 'string' && maskText.test(each[1]);
        view.masks = Object.fromEntries(Object.entries(masks).filter(isText).slice(0, maxLooks));
    }
    if (clip !== undefined) view.clip = decodeClip(clip);
    // Links of old have the texture by itself.
    if (body !== undefined || bodyTexture === true) view.body = encodeBody(decodeBody(body ?? { texture: true }));
    const encoded = encodeVisibility(decodeVisibility(shown));
    if (encoded !== undefined) view.shown = encoded;
    return view;
}

/** Returns the view of the same surfaces under other names; what is of one that is not among them is left
 *  out. */
export function renamedView(
    { surface, looks, masks, shown, ...rest }: PageView,
    names: ReadonlyMap<string, string>,
    rakes: ReadonlyMap<string, string>,
): PageView {
    const renamed = <Value>(each: Record<string, Value>): Record<string, Value> =>
        Object.fromEntries(
            Object.entries(each).flatMap(([id, value]) => {
                const now = names.get(id);
                return now === undefined ? [] : [[now, value]];
            }),
        );
    const now = names.get(surface ?? '');
    const stillShown = encodeVisibility(renamedVisibility(decodeVisibility(shown), rakes, names));
    return {
        ...rest,
        ...(now === undefined ? {} : { surface: now }),
        ...(looks === undefined ? {} : { looks: renamed(looks) }),
        ...(masks === undefined ? {} : { masks: renamed(masks) }),
        ...(stillShown === undefined ? {} : { shown: stillShown }),
    };
}

export interface Visibility {
    hiddenRakes: ReadonlySet<string>;
    /** Hidden surfaces of rakes that are shown. */
    hiddenSurfaces: ReadonlySet<string>;
    /** Only the chosen rake is shown, with its surfaces. */
    alone: boolean;
    /** Rakes that this page does not move. */
    lockedRakes: ReadonlySet<string>;
}

const none: ReadonlySet<string> = new Set();
export const allShown: Visibility = { hiddenRakes: none, hiddenSurfaces: none, alone: false, lockedRakes: none };

const maxIds = 200;

export function showsRake({ hiddenRakes, alone }: Visibility, rake: string, chosen: string | null): boolean {
    return alone && chosen !== null ? rake === chosen : !hiddenRakes.has(rake);
}

export function showsSurface(
    visibility: Visibility,
    surface: { surface: string; rake?: string },
    chosen: string | null,
): boolean {
    return (
        (surface.rake === undefined || showsRake(visibility, surface.rake, chosen)) &&
        !visibility.hiddenSurfaces.has(surface.surface)
    );
}

/** The set with the id where it was not, and without it where it was. */
export function toggled(ids: ReadonlySet<string>, id: string): ReadonlySet<string> {
    const changed = new Set(ids);
    if (!changed.delete(id)) changed.add(id);
    return changed;
}

/** Returns the visibility of the same records under other names; those that are not among them are left
 *  out. */
export function renamedVisibility(
    { hiddenRakes, hiddenSurfaces, alone, lockedRakes }: Visibility,
    rakes: ReadonlyMap<string, string>,
    surfaces: ReadonlyMap<string, string>,
): Visibility {
    const renamed = (ids: ReadonlySet<string>, names: ReadonlyMap<string, string>): Set<string> =>
        new Set([...ids].flatMap((id) => names.get(id) ?? []));
    return {
        hiddenRakes: renamed(hiddenRakes, rakes),
        hiddenSurfaces: renamed(hiddenSurfaces, surfaces),
        alone,
        lockedRakes: renamed(lockedRakes, rakes),
    };
}

/** For JSON; undefined where everything is shown and free. */
export function encodeVisibility({ hiddenRakes, hiddenSurfaces, alone, lockedRakes }: Visibility): object | undefined {
    const lists = { rakes: hiddenRakes, surfaces: hiddenSurfaces, locked: lockedRakes };
    const nonEmpty = Object.entries(lists).filter(([, ids]) => ids.size > 0);
    if (nonEmpty.length === 0 && !alone) return undefined;
    return {
        ...Object.fromEntries(nonEmpty.map(([name, ids]) => [name, [...ids].slice(0, maxIds)])),
        ...(alone ? { alone } : {}),
    };
}

/** Never throws. */
export function decodeVisibility(value: unknown): Visibility {
    if (typeof value !== 'object' || value === null) return allShown;
    const { rakes, surfaces, alone, locked } = value as Record<string, unknown>;
    const ids = (list: unknown): Set<string> =>
        new Set(Array.isArray(list) ? list.slice(0, maxIds).filter((id): id is string => typeof id === 'string') : []);
    return { hiddenRakes: ids(rakes), hiddenSurfaces: ids(surfaces), alone: alone === true, lockedRakes: ids(locked) };
}

export interface ClipPlane {
    on: boolean;
    /** Where it crosses its axis, 0 .. 1 of the domain. */
    at: number;
    /** Places the plane: what lies beyond it is cut away; flipped, what lies before it. */
    flipped: boolean;
}

/** Across x, y and z. */
export interface ClipPlanes {
    planes: readonly [ClipPlane, ClipPlane, ClipPlane];
    body: boolean;
}

const usualPlane: ClipPlane = { on: false, at: 0.5, flipped: false };
export const noClip: ClipPlanes = { planes: [usualPlane, usualPlane, usualPlane], body: false };

/** Never throws. */
export function decodeClip(value: unknown): ClipPlanes {
    if (typeof value !== 'object' || value === null) return noClip;
    const { planes, body } = value as Record<string, unknown>;
    const given: unknown[] = Array.isArray(planes) ? planes : [];
    const [x, y, z] = [0, 1, 2].map((axis) => planeOf(given[axis]));
    return { planes: [x!, y!, z!], body: body === true };
}

function planeOf(value: unknown): ClipPlane {
    if (typeof value !== 'object' || value === null) return usualPlane;
    const { on, at, flipped } = value as Record<string, unknown>;
    const place = typeof at === 'number' && at >= 0 && at <= 1 ? at : usualPlane.at;
    return { on: on === true, at: place, flipped: flipped === true };
}

/** Returns planes as (nx, ny, nz, w): cut away is where n . point > w. Planes that are off cut nothing. */
export function planeNumbers({ planes }: ClipPlanes, bounds: readonly number[]): [number, number, number, number][] {
    return planes.map(({ on, at, flipped }, axis) => {
        const [low, high] = [bounds[2 * axis] ?? 0, bounds[2 * axis + 1] ?? 0];
        const numbers: [number, number, number, number] = [0, 0, 0, 1];
        if (!on) return numbers;
        numbers[axis] = flipped ? -1 : 1;
        numbers[3] = (flipped ? -1 : 1) * (low + at * (high - low));
        return numbers;
    });
}
