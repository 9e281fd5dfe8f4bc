// Planes across the axes that cut the picture open: plain values, for this page, links and bookmarks.

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
