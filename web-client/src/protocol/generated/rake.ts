// Made by protocol/api/generate from rake.schema.json: do not edit.
import { flag, list, matching, members, oneOf, optional, point, text, whole } from '../checks.ts';
import { type Vec3 } from '../vec3.ts';

/** what the points are: line: 2; polyline and points: 2 or more; circle: the centre and two points of the rim */
export const rakeKinds = ['line', 'polyline', 'circle', 'points'] as const;
export type RakeKind = (typeof rakeKinds)[number];
export const rakeKindCheck = oneOf(rakeKinds);

/** What a rake is, to the engine. */
export interface RakeShape {
    /** what the points are: line: 2; polyline and points: 2 or more; circle: the centre and two points of the rim */
    kind: RakeKind;
    /** where it lies; a part outside of the domain is cut away (the dataset's unit of length) */
    points: Vec3[];
    /** how many seeds lie on it */
    seeds: number;
}

export const rakeShapeCheck = members<RakeShape>({ kind: rakeKindCheck, points: list(point), seeds: whole });

/** A rake as the session keeps it. */
export interface RakeRecord {
    /** its id */
    rake: string;
    /** counts the edits of a record */
    rev: number;
    /** what the points are: line: 2; polyline and points: 2 or more; circle: the centre and two points of the rim */
    kind: RakeKind;
    /** where it lies; a part outside of the domain is cut away (the dataset's unit of length) */
    points: Vec3[];
    /** how many seeds lie on it */
    seeds: number;
    /** for people */
    name: string;
    /** #rrggbb */
    colour: string;
    /** the name of the one who made it */
    author: string;
    /** a part was outside the domain and is cut away */
    clipped: boolean;
    /** someone holds it just now */
    dragging: boolean;
    /** the participant who holds it; only while someone does */
    leasedBy?: string;
}

export const rakeRecordCheck = members<RakeRecord>({
    rake: text,
    rev: whole,
    kind: rakeKindCheck,
    points: list(point),
    seeds: whole,
    name: text,
    colour: matching(/^#[0-9a-fA-F]{6}$/),
    author: text,
    clipped: flag,
    dragging: flag,
    leasedBy: optional(text),
});

/** A surface that is built again. */
export interface SurfaceEpoch {
    /** an id that the server gave */
    surface: string;
    /** counts the surfaces that a record has had; only grows */
    epoch: number;
}

export const surfaceEpochCheck = members<SurfaceEpoch>({ surface: text, epoch: whole });

/** Parameters of rake.set. */
export interface RakeSetParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** left out: create one */
    rake?: string;
    /** what the points are: line: 2; polyline and points: 2 or more; circle: the centre and two points of the rim */
    kind: RakeKind;
    /** where it lies; a part outside of the domain is cut away (the dataset's unit of length) */
    points: Vec3[];
    /** how many seeds lie on it */
    seeds: number;
    /** for people */
    name?: string;
    /** #rrggbb; left out: as it was, of a new rake one that few others have */
    colour?: string;
    /** true: no one else may edit the rake for 5 s from now; false: they may again; left out: as it was */
    dragging?: boolean;
    /** a host's edit goes before someone else's lease */
    force?: boolean;
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

/** What rake.set answers. */
export interface RakeSetResult {
    /** its id */
    rake: string;
    /** counts the edits of a record */
    rev: number;
    /** of the session after the edit */
    seq: number;
    /** a part was outside the domain and is cut away */
    clipped: boolean;
    /** as clipped to the domain */
    points: Vec3[];
    /** those that hang on it and are built again */
    surfaces: SurfaceEpoch[];
}

/** Parameters of rake.delete. */
export interface RakeDeleteParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from rake.list */
    rake: string;
    /** although someone else drags it; for hosts */
    force?: boolean;
    /** a name for what the user does; edits that follow each other with the same one are one step of undo */
    gesture?: string;
    /** refuse the edit if the record is at another revision */
    ifRev?: number;
}

/** Parameters of rake.list. */
export interface RakeListParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What rake.list answers. */
export interface RakeListResult {
    /** all of them */
    rakes: RakeRecord[];
}

/** What of a record rake.set asks for, beside its id. */
export const rakeAskedNames = ['kind', 'points', 'seeds', 'name', 'colour', 'dragging'] as const;

/** What holds of a rake where rake.set is not told. */
export const rakeDefaults = {
    name: '',
};
