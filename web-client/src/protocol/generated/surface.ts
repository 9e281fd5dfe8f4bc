// Made by protocol/api/generate from surface.schema.json: do not edit.
import { list, members, number, oneOf, optional, point, text, whole } from '../checks.ts';
import { type Vec3 } from '../vec3.ts';

/**
 * stream: of the field frozen at `from`; path: particles released at `from`; streak: particles released from `from`
 * on; time: a patch of particles released at `from`
 */
export const surfaceKinds = ['stream', 'path', 'streak', 'time'] as const;
export type SurfaceKind = (typeof surfaceKinds)[number];
export const surfaceKindCheck = oneOf(surfaceKinds);

/** which way in time particles go */
export const directions = ['forward', 'backward', 'both'] as const;
export type Direction = (typeof directions)[number];
export const directionCheck = oneOf(directions);

/** of the integration, and of how vertices are put in */
export const accuracies = ['fast', 'balanced', 'exact'] as const;
export type Accuracy = (typeof accuracies)[number];
export const accuracyCheck = oneOf(accuracies);

/** What a surface is asked to be. */
export interface SurfaceFields {
    /** an id from rake.list: the particles start there */
    rake: string;
    /** the patch lies between the rake and this one */
    rake2?: string;
    /** an id from dataset.list */
    dataset: string;
    /**
     * stream: of the field frozen at `from`; path: particles released at `from`; streak: particles released from
     * `from` on; time: a patch of particles released at `from`
     */
    kind: SurfaceKind;
    /** which way in time particles go */
    direction?: Direction;
    /** of the integration, and of how vertices are put in */
    accuracy?: Accuracy;
    /** the surface is shown until this time; the integration takes to - from (the dataset's unit of time) */
    to: number;
    /** the release stops here; left out: at `to` (the dataset's unit of time) */
    releaseUntil?: number;
    /** the patch is the rake swept along this vector (the dataset's unit of length) */
    sweep?: Vec3;
    /** cells smaller than this merge; 0: never (part of the separation) */
    merge?: number;
    /**
     * cells that meet at more than this are refined, as far as the separation and `maxQuads` allow; 180: never
     * (degrees)
     */
    angle?: number;
    /**
     * a particle that is slower counts as at rest and ends; 0: only one that does not move at all (part of the largest
     * speed)
     */
    stagnationSpeed?: number;
    /** quads to build at most */
    maxQuads?: number;
}

export const surfaceFieldsCheck = members<SurfaceFields>({
    rake: text,
    rake2: optional(text),
    dataset: text,
    kind: surfaceKindCheck,
    direction: optional(directionCheck),
    accuracy: optional(accuracyCheck),
    to: number,
    releaseUntil: optional(number),
    sweep: optional(point),
    merge: optional(number),
    angle: optional(number),
    stagnationSpeed: optional(number),
    maxQuads: optional(whole),
});

/** A surface as the session keeps it: its parameters, not its mesh. */
export interface SurfaceRecord {
    /** its id */
    surface: string;
    /** counts the edits of a record */
    rev: number;
    /** counts the surfaces that a record has had; only grows */
    epoch: number;
    /** an id from rake.list: the particles start there */
    rake: string;
    /** the patch lies between the rake and this one */
    rake2?: string;
    /** an id from dataset.list */
    dataset: string;
    /**
     * stream: of the field frozen at `from`; path: particles released at `from`; streak: particles released from
     * `from` on; time: a patch of particles released at `from`
     */
    kind: SurfaceKind;
    /** which way in time particles go */
    direction: Direction;
    /** of the integration, and of how vertices are put in */
    accuracy: Accuracy;
    /** the surface is shown until this time; the integration takes to - from (the dataset's unit of time) */
    to: number;
    /** the release stops here; left out: at `to` (the dataset's unit of time) */
    releaseUntil?: number;
    /** the patch is the rake swept along this vector (the dataset's unit of length) */
    sweep?: Vec3;
    /** cells smaller than this merge; 0: never (part of the separation) */
    merge: number;
    /**
     * cells that meet at more than this are refined, as far as the separation and `maxQuads` allow; 180: never
     * (degrees)
     */
    angle: number;
    /**
     * a particle that is slower counts as at rest and ends; 0: only one that does not move at all (part of the largest
     * speed)
     */
    stagnationSpeed: number;
    /** quads to build at most */
    maxQuads: number;
    /** time of the (first) release (the dataset's unit of time) */
    from: number;
    /** the longest edge (the dataset's unit of length) */
    separation: number;
    /**
     * further attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the
     * magnitude), `deformation`, `approximated`, `vorticity` (its magnitude), `q_criterion`
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
    direction: directionCheck,
    accuracy: accuracyCheck,
    to: number,
    releaseUntil: optional(number),
    sweep: optional(point),
    merge: number,
    angle: number,
    stagnationSpeed: number,
    maxQuads: whole,
    from: number,
    separation: number,
    fields: list(text),
});

/** What surface.set answers. */
export interface SurfaceSetResult {
    /** its id */
    surface: string;
    /** counts the edits of a record */
    rev: number;
    /** counts the surfaces that a record has had; only grows */
    epoch: number;
    /** of the session after the edit */
    seq: number;
}

export const surfaceSetResultCheck = members<SurfaceSetResult>({ surface: text, rev: whole, epoch: whole, seq: whole });

/** Parameters of surface.set. */
export interface SurfaceSetParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** left out: create one */
    surface?: string;
    /** an id from rake.list: the particles start there */
    rake: string;
    /** the patch lies between the rake and this one */
    rake2?: string;
    /** an id from dataset.list */
    dataset: string;
    /**
     * stream: of the field frozen at `from`; path: particles released at `from`; streak: particles released from
     * `from` on; time: a patch of particles released at `from`
     */
    kind: SurfaceKind;
    /** time of release; streak: of the first one; left out: the dataset's first time (the dataset's unit of time) */
    from?: number;
    /** the surface is shown until this time; the integration takes to - from (the dataset's unit of time) */
    to: number;
    /** which way in time particles go */
    direction?: Direction;
    /** of the integration, and of how vertices are put in */
    accuracy?: Accuracy;
    /** the release stops here; left out: at `to` (the dataset's unit of time) */
    releaseUntil?: number;
    /** the patch is the rake swept along this vector (the dataset's unit of length) */
    sweep?: Vec3;
    /** cells smaller than this merge; 0: never (part of the separation) */
    merge?: number;
    /**
     * cells that meet at more than this are refined, as far as the separation and `maxQuads` allow; 180: never
     * (degrees)
     */
    angle?: number;
    /**
     * a particle that is slower counts as at rest and ends; 0: only one that does not move at all (part of the largest
     * speed)
     */
    stagnationSpeed?: number;
    /** quads to build at most */
    maxQuads?: number;
    /** the longest edge; left out: the dataset's finest spacing (the dataset's unit of length) */
    separation?: number;
    /**
     * further attributes of the vertices, in frames and exports: scalar fields of the dataset, its velocity (the
     * magnitude), `deformation`, `approximated`, `vorticity` (its magnitude), `q_criterion`
     */
    fields?: string[];
    /**
     * true: only if no one has edited the session and there is no such record yet; it counts as no edit, so undo does
     * not turn it
     */
    default?: boolean;
    /** a name for what the user does; edits that follow each other with the same one are one step of undo */
    gesture?: string;
    /** refuse the edit if the record is at another revision */
    ifRev?: number;
}

/** Parameters of surface.delete. */
export interface SurfaceDeleteParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from surface.list */
    surface: string;
    /** a name for what the user does; edits that follow each other with the same one are one step of undo */
    gesture?: string;
    /** refuse the edit if the record is at another revision */
    ifRev?: number;
}

/** Parameters of surface.stop. */
export interface SurfaceStopParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from surface.list */
    surface: string;
}

/** What surface.stop answers. */
export interface SurfaceStopResult {
    /** counts the surfaces that a record has had; only grows */
    epoch: number;
    /** false: nothing was under way */
    stopped: boolean;
}

/** Parameters of surface.list. */
export interface SurfaceListParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What surface.list answers. */
export interface SurfaceListResult {
    /** all of them */
    surfaces: SurfaceRecord[];
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
    'releaseUntil',
    'sweep',
    'merge',
    'angle',
    'stagnationSpeed',
    'maxQuads',
    'separation',
    'fields',
] as const;

/** What holds of a surface where surface.set is not told. */
export const surfaceDefaults = {
    direction: 'forward' as Direction,
    accuracy: 'balanced' as Accuracy,
    merge: 0.35,
    angle: 20,
    stagnationSpeed: 1e-6,
    maxQuads: 1000000,
    fields: [] as string[],
};

/** Which kinds take a parameter of surface.set that not all take. */
export const surfaceSetOnlyFor = {
    rake2: ['time'],
    releaseUntil: ['streak'],
    sweep: ['time'],
} as const;

/** Numbers that surface.set takes: what holds where one is left out, and the range. */
export const surfaceSetNumbers = {
    merge: { usual: 0.35, least: 0, most: 0.5 },
    angle: { usual: 20, most: 180 },
    stagnationSpeed: { usual: 1e-6, least: 0, most: 0.1 },
    maxQuads: { usual: 1000000, least: 1, most: 4000000 },
} as const;
