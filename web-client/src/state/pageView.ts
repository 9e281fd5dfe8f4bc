// Reads and writes what a link or a bookmark remembers of a page: how the session is looked at. Comes from
// strangers and from older versions, so that anything may be missing or wrong in it.
import { isVec3, type Vec3 } from '../protocol/messages.ts';
import { type ClipPlanes, decodeClip } from './clipPlanes.ts';
import { decodeLook, encodeLook, type SurfaceLook } from './surfaceLook.ts';
import { decodeVisibility, encodeVisibility, renamedVisibility } from './visibility.ts';

export interface PageView {
    camera?: { position: Vec3; target: Vec3; orthographic: boolean };
    /** The surface that the panel acts on. */
    surface?: string;
    /** By surface, what differs from the usual look. */
    looks?: Record<string, Partial<SurfaceLook>>;
    clip?: ClipPlanes;
    /** The flow along the body is shown on it. */
    bodyTexture?: true;
    /** By surface, what the painter has revealed, as the scene encodes it. */
    masks?: Record<string, string>;
    /** Holds what is hidden or locked, as visibility.ts encodes it; not there: nothing. */
    shown?: object;
}

const looksAtMost = 100;
const maskText = /^[\w-]{1,800}$/;

export function readPageView(value: unknown): PageView {
    const view: PageView = {};
    if (typeof value !== 'object' || value === null) return view;
    const { camera, surface, looks, clip, bodyTexture, masks, shown } = value as Record<string, unknown>;
    const pose = camera as Record<string, unknown> | null | undefined;
    const [position, target] = [pose?.['position'], pose?.['target']];
    if (isVec3(position) && isVec3(target) && String(position) !== String(target)) {
        view.camera = { position, target, orthographic: pose?.['orthographic'] === true };
    }
    if (typeof surface === 'string') view.surface = surface;
    if (typeof looks === 'object' && looks !== null) {
        const known = Object.entries(looks).slice(0, looksAtMost);
        view.looks = Object.fromEntries(known.map(([id, look]) => [id, encodeLook(decodeLook(look))]));
    }
    if (typeof masks === 'object' && masks !== null) {
        const isText = (each: [string, unknown]): each is [string, string] =>
            typeof each[1] === 'string' && maskText.test(each[1]);
        view.masks = Object.fromEntries(Object.entries(masks).filter(isText).slice(0, looksAtMost));
    }
    if (clip !== undefined) view.clip = decodeClip(clip);
    if (bodyTexture === true) view.bodyTexture = true;
    const kept = encodeVisibility(decodeVisibility(shown));
    if (kept !== undefined) view.shown = kept;
    return view;
}

/** Returns the view of the same surfaces under other names; what is of one that is not among them is left
 *  out. */
export function renamedView(
    { surface, looks, masks, shown, ...kept }: PageView,
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
        ...kept,
        ...(now === undefined ? {} : { surface: now }),
        ...(looks === undefined ? {} : { looks: renamed(looks) }),
        ...(masks === undefined ? {} : { masks: renamed(masks) }),
        ...(stillShown === undefined ? {} : { shown: stillShown }),
    };
}
