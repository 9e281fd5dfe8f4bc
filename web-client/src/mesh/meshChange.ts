// What the worker hands to the scene of a surface and of a body: arrays for the GPU, of a surface only what is new in them. Declared here
// because neither of the two knows the other; session/ carries it from the one to the other.

/** What is new since the change before: each array from some vertex, or some index, to the last;
 *  what is before is as it was. */
export interface MeshChange {
    vertices: number;
    triangles: number;
    fromVertex: number;
    /** xyz. */
    positions: Float32Array;
    fromNormal: number;
    /** xyz, of length 1. */
    normals: Float32Array;
    /** s and t less tFrom, which do not change once a vertex is there. */
    fromSeed: number;
    seeds: Float32Array;
    /** Release times may be seconds since 1970, of which 32 bits keep minutes. Another one comes with all
     *  vertices. */
    tFrom: number;
    scalars: readonly ScalarChange[];
    fromIndex: number;
    /** Three a triangle. */
    indices: Uint32Array;
    /** Null: as before, or not asked for. */
    parts: readonly SurfacePart[] | null;
    /** Null: as before. */
    cut: Cut | null;
    /** How long units of s and of t are on the surface, of every vertex. Null: as before, or not asked
     *  for. */
    units: Float32Array | null;
    /** What a fixed grid cannot resolve, of every vertex (worker/vertexQuantities.ts). Null: as before, or
     *  not asked for. */
    unresolved: Float32Array | null;
}

/** A change that has one simulation time. */
export interface TimedMeshChange extends MeshChange {
    time: number;
}

export interface ScalarChange {
    name: string;
    fromVertex: number;
    values: Float32Array;
}

/** Name the components of the surface's normal, which curved cells are made from. */
export const normalNames = ['normal_x', 'normal_y', 'normal_z'] as const;

/** Nothing is drawn where levels, between vertices as they come, are higher. */
export const cutLevel = 63;
/** The level of what is not drawn at all. */
export const wholeCut = 255;

/** What is not drawn: hidden parts, and what is trimmed at torn borders. */
export interface Cut {
    /** Has a level for each vertex; empty: nothing is cut. */
    levels: Uint8Array;
    /** Cells that are trimmed, most of them in part. */
    trimmedCells: number;
}

/** A connected part of a surface, in the order of their first vertices. */
export interface SurfacePart {
    cells: number;
    /** s and t of its first vertex, which names the part. */
    seed: readonly [number, number];
    hidden: boolean;
}

export interface BodyMesh {
    /** xyz of vertices. */
    positions: Float32Array;
    /** xyz, of length 1; 0 where a vertex has no area round it. */
    normals: Float32Array;
    /** Three a triangle. */
    indices: Uint32Array;
}

/** Beside a body at a time, by its vertices. */
export interface BodyValues {
    /** xyz of the velocity. */
    flow: Float32Array;
    /** Not a number where there is none; null: none was asked for. */
    field: Float32Array | null;
}

/** Calls `use` with both ends of each side of each cell, so twice for those between two. */
export type Sides = (use: (from: number, to: number) => void) => void;

/**
 * 1 for each vertex on a border. Inside, each neighbour is met by two cells, and what is written of it twice
 * is gone again; of a vertex on the border two neighbours are met once.
 */
export function borderOf(sides: Sides, vertices: number): Uint8Array {
    const met = new Int32Array(vertices);
    sides((from, to) => meet(met, from, to));
    return notZero(met);
}

/** Neighbours; a vertex that is met as its own changes nothing. */
export function meet(met: Int32Array, from: number, to: number): void {
    met[from]! ^= mixed(to);
    met[to]! ^= mixed(from);
}

/** 1 for each vertex that has met others an odd number of times. */
export function notZero(met: Int32Array): Uint8Array {
    const border = new Uint8Array(met.length);
    for (let v = 0; v < met.length; ++v) if (met[v] !== 0) border[v] = 1;
    return border;
}

/** So that no sums of a few numbers are the same by chance. */
function mixed(vertex: number): number {
    const spread = Math.imul(vertex + 1, 0x9e3779b1);
    return Math.imul(spread ^ (spread >>> 15), 0x85ebca6b);
}
