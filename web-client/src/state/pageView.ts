// What a link or a bookmark remembers of a page, which is how one person looks at the session: the view as a whole, what of the session is
// shown and which rakes may be moved, and the planes that cut the picture open. Read from strangers and from older versions, so that
// anything may be missing or wrong in it; that is left out.
import { type BodyLook, decodeBody, encodeBody } from './bodyLook.ts';
import { isVec3, type Vec3 } from '../protocol/messages.ts';
import { decodeLines, encodeLines, type LineLook } from './lineLook.ts';
import { decodeSlices, encodeSlices, type SliceLook } from './sliceLook.ts';
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
    /** What differs from the usual look of slices. */
    slices?: Partial<SliceLook>;
    /** What differs from the usual look of streamlines. */
    lines?: Partial<LineLook>;
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
    const { camera, surface, looks, clip, body, bodyTexture, slices, lines, masks, shown } = value as Record<string, unknown>;
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
    if (slices !== undefined) view.slices = encodeSlices(decodeSlices(slices));
    if (lines !== undefined) view.lines = encodeLines(decodeLines(lines));
    const encoded = encodeVisibility(decodeVisibility(shown));
    if (encoded !== undefined) view.shown = encoded;
    return view;
}

/** Returns the view of the same surfaces under other names; what is of one that is not among them is left
 *  out. */
export function renamedView(
    { surface, looks, clip, masks, shown, ...rest }: PageView,
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
        ...(clip === undefined ? {} : { clip: renamedClip(clip, names) }),
        ...(masks === undefined ? {} : { masks: renamed(masks) }),
        ...(stillShown === undefined ? {} : { shown: stillShown }),
    };
}

/** What of the picture is seen. Ids are those of records, and bodyId. */
export interface Visibility {
    /** A rake that is hidden hides its surfaces. */
    hidden: ReadonlySet<string>;
    /** Nothing else is shown: an id, or chosenRake; null: everything that is not hidden. */
    only: string | null;
    /** How opaque slices and the body are, 0 .. 1; those that are not in it hide what is behind them. */
    opacities: ReadonlyMap<string, number>;
    /** Rakes that this page does not move. */
    lockedRakes: ReadonlySet<string>;
}

export const bodyId = 'body';
/** In the place of an id in links of old: whichever rake is chosen. */
export const chosenRake = 'rake';

const none: ReadonlySet<string> = new Set();
export const allShown: Visibility = { hidden: none, only: null, opacities: new Map(), lockedRakes: none };

const maxIds = 200;

/** @param rake that is chosen */
export function shows({ hidden, only }: Visibility, id: string, rake: string | null = null): boolean {
    const alone = only === chosenRake ? rake : only;
    return alone === null ? !hidden.has(id) : id === alone;
}

export function showsSurface(
    visibility: Visibility,
    { surface, rake }: { surface: string; rake?: string },
    chosen: string | null,
): boolean {
    if (rake === undefined) return shows(visibility, surface, chosen);
    return shows(visibility, rake, chosen) && !visibility.hidden.has(surface);
}

export function opacityOf({ opacities }: Visibility, id: string): number {
    return opacities.get(id) ?? 1;
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
    { hidden, only, opacities, lockedRakes }: Visibility,
    rakes: ReadonlyMap<string, string>,
    surfaces: ReadonlyMap<string, string>,
): Visibility {
    const names = new Map([...rakes, ...surfaces, [bodyId, bodyId], [chosenRake, chosenRake]]);
    const renamed = (ids: ReadonlySet<string>): Set<string> => new Set([...ids].flatMap((id) => names.get(id) ?? []));
    return {
        hidden: renamed(hidden),
        only: names.get(only ?? '') ?? null,
        opacities: new Map([...opacities].flatMap(([id, part]) => (names.has(id) ? [[names.get(id)!, part] as const] : []))),
        lockedRakes: renamed(lockedRakes),
    };
}

/** For JSON; undefined where everything is shown and free. */
export function encodeVisibility({ hidden, only, opacities, lockedRakes }: Visibility): object | undefined {
    const lists = Object.entries({ hidden, locked: lockedRakes }).filter(([, ids]) => ids.size > 0);
    if (lists.length === 0 && only === null && opacities.size === 0) return undefined;
    return {
        ...Object.fromEntries(lists.map(([name, ids]) => [name, [...ids].slice(0, maxIds)])),
        ...(only === null ? {} : { only }),
        ...(opacities.size === 0 ? {} : { opacities: Object.fromEntries([...opacities].slice(0, maxIds)) }),
    };
}

/** Never throws. Links of old name rakes and surfaces apart. */
export function decodeVisibility(value: unknown): Visibility {
    if (typeof value !== 'object' || value === null) return allShown;
    const { hidden, rakes, surfaces, only, alone, opacities, locked } = value as Record<string, unknown>;
    const ids = (list: unknown): string[] =>
        Array.isArray(list) ? list.slice(0, maxIds).filter((id): id is string => typeof id === 'string') : [];
    const isPart = (entry: [string, unknown]): entry is [string, number] =>
        typeof entry[1] === 'number' && entry[1] >= 0 && entry[1] < 1;
    const parts = typeof opacities === 'object' && opacities !== null ? Object.entries(opacities).slice(0, maxIds) : [];
    return {
        hidden: new Set([...ids(hidden), ...ids(rakes), ...ids(surfaces)]),
        only: typeof only === 'string' ? only : alone === true ? chosenRake : null,
        opacities: new Map(parts.filter(isPart)),
        lockedRakes: new Set(ids(locked)),
    };
}

export interface ClipPlane {
    on: boolean;
    /** Where it crosses its axis, as a part of the domain: 0 .. 1, beyond that where other data reach further. */
    at: number;
    /** Places the plane: what lies beyond it is cut away; flipped, what lies before it. */
    flipped: boolean;
}

export interface ClipPlanes {
    /** Across x, y and z. */
    planes: readonly [ClipPlane, ClipPlane, ClipPlane];
    /** What lies on the normal's side of this slice is cut away; flipped, on the other; null: no slice cuts. */
    slice: { id: string; flipped: boolean } | null;
    body: boolean;
}

/** Where a slice lies. */
export type SlicePlane = Readonly<{ origin: Vec3; normal: Vec3 }>;

const usualPlane: ClipPlane = { on: false, at: 0.5, flipped: false };
export const noClip: ClipPlanes = { planes: [usualPlane, usualPlane, usualPlane], slice: null, body: false };

/** Never throws. */
export function decodeClip(value: unknown): ClipPlanes {
    if (typeof value !== 'object' || value === null) return noClip;
    const { planes, slice, body } = value as Record<string, unknown>;
    const given: unknown[] = Array.isArray(planes) ? planes : [];
    const [x, y, z] = [0, 1, 2].map((axis) => planeOf(given[axis]));
    return { planes: [x!, y!, z!], slice: cuttingSlice(slice), body: body === true };
}

function cuttingSlice(value: unknown): ClipPlanes['slice'] {
    if (typeof value !== 'object' || value === null) return null;
    const { id, flipped } = value as Record<string, unknown>;
    return typeof id === 'string' ? { id, flipped: flipped === true } : null;
}

/** Returns the planes with the slice under another name; none cuts where it has none. */
export function renamedClip(clip: ClipPlanes, names: ReadonlyMap<string, string>): ClipPlanes {
    const id = names.get(clip.slice?.id ?? '');
    return clip.slice === null ? clip : { ...clip, slice: id === undefined ? null : { ...clip.slice, id } };
}

function planeOf(value: unknown): ClipPlane {
    if (typeof value !== 'object' || value === null) return usualPlane;
    const { on, at, flipped } = value as Record<string, unknown>;
    const place = typeof at === 'number' && Number.isFinite(at) ? at : usualPlane.at;
    return { on: on === true, at: place, flipped: flipped === true };
}

/**
 * Returns planes as (nx, ny, nz, w): cut away is where n . point > w. Planes that are off cut nothing.
 * @param cutting  where the slice that cuts lies; null: it is not there
 */
export function planeNumbers(
    { planes, slice }: ClipPlanes,
    bounds: readonly number[],
    cutting: SlicePlane | null = null,
): [number, number, number, number][] {
    const along = planes.map(({ on, at, flipped }, axis) => {
        const [low, high] = [bounds[2 * axis] ?? 0, bounds[2 * axis + 1] ?? 0];
        const numbers: [number, number, number, number] = [0, 0, 0, 1];
        if (!on) return numbers;
        numbers[axis] = flipped ? -1 : 1;
        numbers[3] = (flipped ? -1 : 1) * (low + at * (high - low));
        return numbers;
    });
    if (slice === null || cutting === null) return along;
    const { origin, normal } = cutting;
    const side = (slice.flipped ? -1 : 1) / Math.hypot(...normal); // a Plane of three wants a unit
    const [x, y, z] = normal.map((each) => side * each);
    return [...along, [x!, y!, z!, x! * origin[0] + y! * origin[1] + z! * origin[2]]];
}
