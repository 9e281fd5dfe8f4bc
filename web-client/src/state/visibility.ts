// Holds what of the session this page shows, and which rakes it lets be moved: each person's own, as the
// camera is. Links and saved views have it too; what comes back from those may be of strangers, and what is
// wrong in it is left out.

export interface Visibility {
    hiddenRakes: ReadonlySet<string>;
    /** Holds hidden surfaces of rakes that are shown. */
    hiddenSurfaces: ReadonlySet<string>;
    /** Only the chosen rake is shown, with its surfaces. */
    alone: boolean;
    /** Rakes that this page does not move. */
    lockedRakes: ReadonlySet<string>;
}

const none: ReadonlySet<string> = new Set();
export const allShown: Visibility = { hiddenRakes: none, hiddenSurfaces: none, alone: false, lockedRakes: none };

const idsAtMost = 200;

export function showsRake({ hiddenRakes, alone }: Visibility, rake: string, chosen: string | null): boolean {
    return alone && chosen !== null ? rake === chosen : !hiddenRakes.has(rake);
}

export function showsSurface(visibility: Visibility, surface: { surface: string; rake: string }, chosen: string | null): boolean {
    return showsRake(visibility, surface.rake, chosen) && !visibility.hiddenSurfaces.has(surface.surface);
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
    const kept = Object.entries(lists).filter(([, ids]) => ids.size > 0);
    if (kept.length === 0 && !alone) return undefined;
    return {
        ...Object.fromEntries(kept.map(([name, ids]) => [name, [...ids].slice(0, idsAtMost)])),
        ...(alone ? { alone } : {}),
    };
}

/** Never throws. */
export function decodeVisibility(value: unknown): Visibility {
    if (typeof value !== 'object' || value === null) return allShown;
    const { rakes, surfaces, alone, locked } = value as Record<string, unknown>;
    const ids = (list: unknown): Set<string> =>
        new Set(Array.isArray(list) ? list.slice(0, idsAtMost).filter((id): id is string => typeof id === 'string') : []);
    return { hiddenRakes: ids(rakes), hiddenSurfaces: ids(surfaces), alone: alone === true, lockedRakes: ids(locked) };
}
