// Made by protocol/api/generate from rake.schema.json: do not edit.
import { flag, list, matching, members, oneOf, optional, point, text, whole } from '../checks.ts';
import type { Vec3 } from '../vec3.ts';
import type { InSession } from './shared.ts';

/** what the points are; line: 2 points; polyline and points: 2 or more; circle: the centre and two points on the rim */
export const rakeKinds = ['line', 'polyline', 'circle', 'points'] as const;
export type RakeKind = (typeof rakeKinds)[number];
export const rakeKindCheck = oneOf(rakeKinds);

/** A rake as the session keeps it. */
export interface RakeRecord {
    /** id of the rake */
    rake: string;
    /** counts the edits of a record */
    rev: number;
    /**
     * what the points are; line: 2 points; polyline and points: 2 or more; circle: the centre and two points on the
     * rim
     */
    kind: RakeKind;
    /**
     * where the rake lies; parts outside the domain are cut off, and a circle releases from its longest arc inside
     * (the dataset's unit of length)
     */
    points: Vec3[];
    /** number of seeds on the rake */
    seeds: number;
    /** display name */
    name: string;
    /** #rrggbb */
    colour: string;
    /** name of the one who made it */
    author: string;
    /** true: a part was outside the domain and was cut off; a circle's points stay */
    clipped: boolean;
    /** true: someone holds the lease at the moment */
    dragging: boolean;
    /** id of the participant who holds the lease; only present while someone does */
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

/** A surface that is being built again. */
export interface SurfaceEpoch {
    /** id of the surface */
    surface: string;
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
}

export const surfaceEpochCheck = members<SurfaceEpoch>({ surface: text, epoch: whole });

/** Parameters of rake.set. */
export interface RakeSetParams extends InSession {
    /** id of the rake to replace; if left out, a new one is created */
    rake?: string;
    /**
     * what the points are; line: 2 points; polyline and points: 2 or more; circle: the centre and two points on the
     * rim
     */
    kind: RakeKind;
    /**
     * where the rake lies; parts outside the domain are cut off, and a circle releases from its longest arc inside
     * (the dataset's unit of length)
     */
    points: Vec3[];
    /** number of seeds on the rake */
    seeds: number;
    /** display name */
    name?: string;
    /** #rrggbb; if left out, a rake keeps its colour, and a new rake gets one that few others have */
    colour?: string;
    /**
     * true: no one else may edit the rake for 5 s from now; false: others may edit it again; if left out, nothing
     * changes
     */
    dragging?: boolean;
    /** true: lets a host edit the rake although someone else holds the lease */
    force?: boolean;
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

/** What rake.set answers. */
export interface RakeSetResult {
    /** id of the rake */
    rake: string;
    /** counts the edits of a record */
    rev: number;
    /** `seq` of the session after the edit */
    seq: number;
    /** true: a part was outside the domain and was cut off; a circle's points stay */
    clipped: boolean;
    /** the points, clipped to the domain */
    points: Vec3[];
    /** surfaces of the rake that are being built again */
    surfaces: SurfaceEpoch[];
}

/** Parameters of rake.delete. */
export interface RakeDeleteParams extends InSession {
    /** an id from rake.list */
    rake: string;
    /** true: lets a host delete the rake although someone else holds the lease */
    force?: boolean;
    /** a name for what the user is doing; consecutive edits with the same name are one step of undo */
    gesture?: string;
    /** the edit is refused if the record is at another revision */
    ifRev?: number;
}

/** Parameters of rake.list. */
export type RakeListParams = InSession;

/** What rake.list answers. */
export interface RakeListResult {
    /** all rakes */
    rakes: RakeRecord[];
}
