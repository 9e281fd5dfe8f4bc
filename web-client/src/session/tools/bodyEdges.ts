// Which triangles of a body meet at which edge. An edge goes by a corner of a triangle that has it, and leads from there to the next corner.
// Triangles that meet have corners at the same places, not always the same ones, and may be turned either way. What has no area is not there.
import { placesOf } from '../../mesh/places.ts';
import type { Vec3 } from '../../protocol/messages.ts';
import { cross, minus, unit } from '../../scene/rake/rakeShape.ts';

export interface Triangles {
    positions: ArrayLike<number>;
    indices: ArrayLike<number>;
}

/** No other triangle has the edge. */
export const alone = -1;
/** More than one other has it. */
export const several = -2;

export class BodyEdges {
    private readonly body: Triangles;
    private readonly places: Uint32Array;
    /** The corners at a place, in `corners`: those of the next place begin where they end. */
    private readonly starts: Uint32Array;
    private readonly corners: Uint32Array;
    /** By triangle, whether it has an area. */
    private readonly wide: Uint8Array;

    constructor(body: Triangles) {
        this.body = body;
        const { positions, indices } = body;
        const byVertex = placesOf(positions);
        this.wide = new Uint8Array(Math.floor(indices.length / 3));
        this.places = new Uint32Array(3 * this.wide.length);
        this.starts = new Uint32Array(byVertex.length + 1);
        const { wide, places, starts } = this;
        for (let i = 0; i < places.length; ++i) places[i] = byVertex[indices[i]!]!;
        for (let t = 0; t < wide.length; ++t) {
            if (!hasArea(positions, indices, 3 * t)) continue;
            wide[t] = 1;
            for (let i = 3 * t; i < 3 * t + 3; ++i) ++starts[places[i]! + 1]!;
        }
        for (let i = 1; i < starts.length; ++i) starts[i]! += starts[i - 1]!;
        this.corners = new Uint32Array(starts.at(-1)!);
        const next = starts.slice();
        for (let t = 0; t < wide.length; ++t) {
            if (wide[t] === 1) for (let i = 3 * t; i < 3 * t + 3; ++i) this.corners[next[places[i]!]!++] = i;
        }
    }

    /** Its triangle has an area. */
    isThere(corner: number): boolean {
        return this.wide[Math.floor(corner / 3)] === 1;
    }

    /** The numbers of the places that it leads from and to. */
    ends(edge: number): [number, number] {
        return [this.places[edge]!, this.places[following(edge)]!];
    }

    at(place: number): Vec3 {
        return cornerOf(this.body.positions, place);
    }

    /** The same edge as one of the other triangle there; `alone`, or `several` where there is no telling which. */
    across(edge: number): number {
        const { places, starts, corners } = this;
        const [from, to] = [places[edge]!, places[following(edge)]!];
        let found = alone;
        for (let k = starts[from]!; k < starts[from + 1]!; ++k) {
            const corner = corners[k]!;
            const leads = places[following(corner)] === to ? corner : previous(corner);
            if (leads === edge || (leads !== corner && places[leads] !== to)) continue;
            if (found !== alone) return several;
            found = leads;
        }
        return found;
    }

    /** The place of the third corner of its triangle. */
    opposite(edge: number): number {
        return this.places[previous(edge)]!;
    }

    /** One for each edge that ends at a place. */
    edgesAt(place: number): number[] {
        const byOther = new Map<number, number>();
        for (let k = this.starts[place]!; k < this.starts[place + 1]!; ++k) {
            const corner = this.corners[k]!;
            byOther.set(this.places[following(corner)]!, corner);
            byOther.set(this.places[previous(corner)]!, previous(corner));
        }
        return [...byOther.values()];
    }

    /** The direction across an edge into its triangle. */
    inside(edge: number): Vec3 {
        const { positions, indices } = this.body;
        const a = cornerOf(positions, indices[edge]!);
        const along = minus(cornerOf(positions, indices[following(edge)]!), a);
        const third = minus(cornerOf(positions, indices[previous(edge)]!), a);
        return unit(cross(cross(along, third), along));
    }
}

function hasArea(p: ArrayLike<number>, indices: ArrayLike<number>, t: number): boolean {
    const [a, b, c] = [3 * indices[t]!, 3 * indices[t + 1]!, 3 * indices[t + 2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    return Math.abs(uy * vz - uz * vy) + Math.abs(uz * vx - ux * vz) + Math.abs(ux * vy - uy * vx) > 0;
}

export function cornerOf(positions: ArrayLike<number>, vertex: number): Vec3 {
    return [positions[3 * vertex]!, positions[3 * vertex + 1]!, positions[3 * vertex + 2]!];
}

function following(corner: number): number {
    return corner % 3 === 2 ? corner - 2 : corner + 1;
}

function previous(corner: number): number {
    return corner % 3 === 0 ? corner + 2 : corner - 1;
}
