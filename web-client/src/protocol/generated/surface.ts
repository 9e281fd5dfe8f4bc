// Made by protocol/api/generate from surface.schema.json: do not edit.
import { list, members, number, oneOf, optional, point, text, whole } from '../checks.ts';
import type { Vec3 } from '../vec3.ts';
import type { InSession } from './shared.ts';

/**
 * stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak: particles
 * released continuously from `from` on; time: a patch of particles released at `from`; level: where `field` has the
 * value `level`, at the time that is shown between `from` and `to`
 */
export const surfaceKinds = ['stream', 'path', 'streak', 'time', 'level'] as const;
export type SurfaceKind = (typeof surfaceKinds)[number];
export const surfaceKindCheck = oneOf(surfaceKinds);

/** which way particles are followed in time */
export const directions = ['forward', 'backward', 'both'] as const;
export type Direction = (typeof directions)[number];
export const directionCheck = oneOf(directions);

/** how accurately particles are traced and vertices inserted */
export const accuracies = ['fast', 'balanced', 'exact'] as const;
export type Accuracy = (typeof accuracies)[number];
export const accuracyCheck = oneOf(accuracies);

/**
 * of stored velocity. linear: between the nodes of a cell and in time, as ParaView shows it; smooth: cubic in space
 * and time, for uniform grids only, see `smooth` of dataset.describe
 */
export const interpolations = ['linear', 'smooth'] as const;
export type Interpolation = (typeof interpolations)[number];
export const interpolationCheck = oneOf(interpolations);

/**
 * whether quads are cut, joined and reconnected, and torn at obstacles. off: the grid that the rake begins with stays
 * as it is, with a column a seed, as in smoke surfaces; `merge` and `angle` then count for nothing, and `separation`
 * only along the flow. Quads with a particle that has ended are left out
 */
export const refines = ['on', 'off'] as const;
export type Refine = (typeof refines)[number];
export const refineCheck = oneOf(refines);

/** A surface as the session keeps it: its parameters, not its mesh. */
export interface SurfaceRecord {
    /** id of the surface */
    surface: string;
    /** counts the edits of a record */
    rev: number;
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
    /**
     * an id from rake.list; the particles start from this rake. A level surface takes no more of it than its place in
     * lists and its colour
     */
    rake: string;
    /** the patch lies between the rake and this second rake */
    rake2?: string;
    /** an id from dataset.list */
    dataset: string;
    /**
     * stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak:
     * particles released continuously from `from` on; time: a patch of particles released at `from`; level: where
     * `field` has the value `level`, at the time that is shown between `from` and `to`
     */
    kind: SurfaceKind;
    /** how accurately particles are traced and vertices inserted */
    accuracy: Accuracy;
    /**
     * of stored velocity. linear: between the nodes of a cell and in time, as ParaView shows it; smooth: cubic in
     * space and time, for uniform grids only, see `smooth` of dataset.describe
     */
    interpolation: Interpolation;
    /**
     * whether quads are cut, joined and reconnected, and torn at obstacles. off: the grid that the rake begins with
     * stays as it is, with a column a seed, as in smoke surfaces; `merge` and `angle` then count for nothing, and
     * `separation` only along the flow. Quads with a particle that has ended are left out
     */
    refine: Refine;
    /**
     * where the surface ends: before `from`, time runs backward. A stream surface is followed for `to` - `from`, and
     * `to` need not lie in the data; for the others it must (the dataset's unit of time)
     */
    to: number;
    /** time at which the release stops; if left out, `to` (the dataset's unit of time) */
    releaseUntil?: number;
    /**
     * longest age of a particle: it ends so long after its release; if left out, it lives as long as the surface (the
     * dataset's unit of time)
     */
    life?: number;
    /** the patch is the rake swept along this vector (the dataset's unit of length) */
    sweep?: Vec3;
    /**
     * scalar field of the dataset, or derived from its velocity, of which the surface is a level set: its magnitude by
     * the velocity's name, `vorticity`, `q_criterion`, `velocity_x` and the like
     */
    field?: string;
    /** value that the field has on the surface (the field's unit) */
    level?: number;
    /** quads smaller than this are joined; 0: never (part of the separation) */
    merge: number;
    /**
     * neighbouring quads at a larger angle are refined, as far as the separation and `maxQuads` allow; 180: never
     * (degrees)
     */
    angle: number;
    /**
     * a slower particle counts as at rest and ends; 0: only a particle that does not move at all (part of the largest
     * speed)
     */
    stagnationSpeed: number;
    /** maximum number of quads */
    maxQuads: number;
    /**
     * where the surface starts: the (first) release; for stream surfaces, the time at which the field is frozen (the
     * dataset's unit of time)
     */
    from: number;
    /** which way particles are followed in time */
    direction: Direction;
    /** longest edge allowed (the dataset's unit of length) */
    separation: number;
    /**
     * additional attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the
     * magnitude), `deformation`, `approximated`, `error`, `vorticity` (its magnitude), `vorticity_x`, `vorticity_y`,
     * `vorticity_z`, `q_criterion`, `velocity_x`, `velocity_y`, `velocity_z`, `normal_x`, `normal_y`, `normal_z` (of
     * the surface)
     */
    fields: string[];
}

export const surfaceRecordCheck = members<SurfaceRecord>({
    surface: text,
    rev: whole,
    epoch: whole,
    rake: text,
    rake2: optional(text),
    dataset: text,
    kind: surfaceKindCheck,
    accuracy: accuracyCheck,
    interpolation: interpolationCheck,
    refine: refineCheck,
    to: number,
    releaseUntil: optional(number),
    life: optional(number),
    sweep: optional(point),
    field: optional(text),
    level: optional(number),
    merge: number,
    angle: number,
    stagnationSpeed: number,
    maxQuads: whole,
    from: number,
    direction: directionCheck,
    separation: number,
    fields: list(text),
});

/** What surface.set returns. */
export interface SurfaceSetResult {
    /** id of the surface */
    surface: string;
    /** counts the edits of a record */
    rev: number;
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
    /** `seq` of the session after the edit */
    seq: number;
}

export const surfaceSetResultCheck = members<SurfaceSetResult>({ surface: text, rev: whole, epoch: whole, seq: whole });

/** Parameters of surface.set. */
export interface SurfaceSetParams extends InSession {
    /** id of the surface to replace; if left out, a new one is created */
    surface?: string;
    /**
     * an id from rake.list; the particles start from this rake. A level surface takes no more of it than its place in
     * lists and its colour
     */
    rake: string;
    /** the patch lies between the rake and this second rake */
    rake2?: string;
    /** an id from dataset.list */
    dataset: string;
    /**
     * stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak:
     * particles released continuously from `from` on; time: a patch of particles released at `from`; level: where
     * `field` has the value `level`, at the time that is shown between `from` and `to`
     */
    kind: SurfaceKind;
    /**
     * where the surface starts: the (first) release; for stream surfaces, the time at which the field is frozen; if
     * left out, the first time of the data, or the last where `direction` is backward (the dataset's unit of time)
     */
    from?: number;
    /**
     * where the surface ends: before `from`, time runs backward. A stream surface is followed for `to` - `from`, and
     * `to` need not lie in the data; for the others it must (the dataset's unit of time)
     */
    to: number;
    /**
     * if left out, forward or backward as `from` and `to` say; it must not contradict them. both: to the later time
     * `to`, and as long before `from`, a path surface as far as there are data; only for stream and path surfaces
     */
    direction?: Direction;
    /** how accurately particles are traced and vertices inserted */
    accuracy?: Accuracy;
    /**
     * of stored velocity. linear: between the nodes of a cell and in time, as ParaView shows it; smooth: cubic in
     * space and time, for uniform grids only, see `smooth` of dataset.describe
     */
    interpolation?: Interpolation;
    /**
     * whether quads are cut, joined and reconnected, and torn at obstacles. off: the grid that the rake begins with
     * stays as it is, with a column a seed, as in smoke surfaces; `merge` and `angle` then count for nothing, and
     * `separation` only along the flow. Quads with a particle that has ended are left out
     */
    refine?: Refine;
    /** time at which the release stops; if left out, `to` (the dataset's unit of time) */
    releaseUntil?: number;
    /**
     * longest age of a particle: it ends so long after its release; if left out, it lives as long as the surface (the
     * dataset's unit of time)
     */
    life?: number;
    /** the patch is the rake swept along this vector (the dataset's unit of length) */
    sweep?: Vec3;
    /**
     * scalar field of the dataset, or derived from its velocity, of which the surface is a level set: its magnitude by
     * the velocity's name, `vorticity`, `q_criterion`, `velocity_x` and the like
     */
    field?: string;
    /** value that the field has on the surface (the field's unit) */
    level?: number;
    /** quads smaller than this are joined; 0: never (part of the separation) */
    merge?: number;
    /**
     * neighbouring quads at a larger angle are refined, as far as the separation and `maxQuads` allow; 180: never
     * (degrees)
     */
    angle?: number;
    /**
     * a slower particle counts as at rest and ends; 0: only a particle that does not move at all (part of the largest
     * speed)
     */
    stagnationSpeed?: number;
    /** maximum number of quads */
    maxQuads?: number;
    /** longest edge allowed; if left out, the dataset's finest spacing (the dataset's unit of length) */
    separation?: number;
    /**
     * additional attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the
     * magnitude), `deformation`, `approximated`, `error`, `vorticity` (its magnitude), `vorticity_x`, `vorticity_y`,
     * `vorticity_z`, `q_criterion`, `velocity_x`, `velocity_y`, `velocity_z`, `normal_x`, `normal_y`, `normal_z` (of
     * the surface)
     */
    fields?: string[];
    /**
     * true: make the record only if no one has edited the session and it has no such record yet; this does not count
     * as an edit, and undo does not take it back
     */
    default?: boolean;
    /** a name for what the user is doing; consecutive edits with the same name are one step of undo */
    gesture?: string;
    /** the edit is refused if the record is at another revision */
    ifRev?: number;
}

/** What of a record surface.set asks for, beside its id. */
export const surfaceAskedNames = [
    'rake',
    'rake2',
    'dataset',
    'kind',
    'from',
    'to',
    'direction',
    'accuracy',
    'interpolation',
    'refine',
    'releaseUntil',
    'life',
    'sweep',
    'field',
    'level',
    'merge',
    'angle',
    'stagnationSpeed',
    'maxQuads',
    'separation',
    'fields',
] as const;

/** What holds of a surface where surface.set is not told. */
export const surfaceDefaults = {
    accuracy: 'balanced' as Accuracy,
    interpolation: 'linear' as Interpolation,
    refine: 'on' as Refine,
    merge: 0.35,
    angle: 20,
    stagnationSpeed: 1e-6,
    maxQuads: 1000000,
    fields: [] as string[],
};

/** Least and most of what is a number in surface.set; the least itself may be left out of the range. */
export const surfaceSetRanges = {
    from: [-3.40282e38, 3.40282e38],
    to: [-3.40282e38, 3.40282e38],
    releaseUntil: [-3.40282e38, 3.40282e38],
    merge: [0, 0.5],
    angle: [0, 180],
    stagnationSpeed: [0, 0.1],
    maxQuads: [1, 4e6],
} as const;

/** Which kinds take a parameter of surface.set that not all take. */
export const surfaceSetOnlyFor = {
    rake2: ['time'],
    releaseUntil: ['streak'],
    life: ['path', 'streak', 'time'],
    sweep: ['time'],
    field: ['level'],
    level: ['level'],
} as const;

/** Parameters of surface.delete. */
export interface SurfaceDeleteParams extends InSession {
    /** an id from surface.list */
    surface: string;
    /** a name for what the user is doing; consecutive edits with the same name are one step of undo */
    gesture?: string;
    /** the edit is refused if the record is at another revision */
    ifRev?: number;
}

/** Parameters of surface.stop. */
export interface SurfaceStopParams extends InSession {
    /** an id from surface.list */
    surface: string;
}

/** What surface.stop answers. */
export interface SurfaceStopResult {
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
    /** false: nothing was being computed */
    stopped: boolean;
}

/** Parameters of surface.list. */
export type SurfaceListParams = InSession;

/** What surface.list answers. */
export interface SurfaceListResult {
    /** all surfaces */
    surfaces: SurfaceRecord[];
}
