// Made by protocol/api/generate from session.schema.json: do not edit.
import { anyObject, either, flag, list, members, number, oneOf, optional, text, whole } from '../checks.ts';
import { type AnnotationRecord, annotationRecordCheck } from './annotation.ts';
import { type BookmarkRecord, bookmarkRecordCheck } from './bookmark.ts';
import { type Participant, participantCheck } from './presence.ts';
import { type RakeRecord, rakeRecordCheck } from './rake.ts';
import { type InSession, type Role, roleCheck } from './shared.ts';
import { type SurfaceRecord, surfaceRecordCheck } from './surface.ts';
import { type ClockRecord, clockRecordCheck } from './time.ts';

/** A record that could not be used when the server started. */
export interface AsideRecord {
    /** kind of record: rake, surface, bookmark or annotation */
    type: string;
    /** id of the record */
    id: string;
    /** why it could not be used */
    why: string;
    /** when it was put aside (s since 1970) */
    since: number;
}

export const asideRecordCheck = members<AsideRecord>({ type: text, id: text, why: text, since: whole });

/** Records that could not be used when the server started. None of them is deleted. */
export interface KeptAside {
    /** number of all such records */
    count: number;
    /** the newest 50 of them */
    records: AsideRecord[];
}

export const keptAsideCheck = members<KeptAside>({ count: whole, records: list(asideRecordCheck) });

/** The units that the people of a session have typed. */
export interface Units {
    /** unit of lengths; empty: as in dataset.describe */
    length: string;
    /** unit of times; empty: as in dataset.describe */
    time: string;
}

export const unitsCheck = members<Units>({ length: text, time: text });

/** All records of a session. */
export interface Snapshot {
    /** id of the session */
    session: string;
    /** display name */
    name: string;
    /** left out if no one has typed any */
    units?: Units;
    /** all rakes */
    rakes: RakeRecord[];
    /** all surfaces */
    surfaces: SurfaceRecord[];
    /** all bookmarks */
    bookmarks: BookmarkRecord[];
    /** all annotations */
    annotations: AnnotationRecord[];
    /** the session's clock */
    clock: ClockRecord;
    /** records that are kept aside, if there are any */
    keptAside?: KeptAside;
}

export const snapshotCheck = members<Snapshot>({
    session: text,
    name: text,
    units: optional(unitsCheck),
    rakes: list(rakeRecordCheck),
    surfaces: list(surfaceRecordCheck),
    bookmarks: list(bookmarkRecordCheck),
    annotations: list(annotationRecordCheck),
    clock: clockRecordCheck,
    keptAside: optional(keptAsideCheck),
});

/** The id and the name of a session, and its units. */
export interface SessionName {
    /** id of the session */
    session: string;
    /** display name */
    name: string;
    /** left out if no one has typed any */
    units?: Units;
}

export const sessionNameCheck = members<SessionName>({ session: text, name: text, units: optional(unitsCheck) });

/** A new session. */
export interface SessionMade {
    /** id of the session */
    session: string;
    /** display name */
    name: string;
    /** how many more sessions can be made */
    remaining: number;
}

export const sessionMadeCheck = members<SessionMade>({ session: text, name: text, remaining: whole });

/** The time-steps of a dataset. */
export interface TimesOfDataset {
    /** number of time-steps */
    count: number;
    /** time of the first time-step (the dataset's unit of time) */
    first: number;
    /** time of the last time-step (the dataset's unit of time) */
    last: number;
}

export const timesOfDatasetCheck = members<TimesOfDataset>({ count: whole, first: number, last: number });

/**
 * A dataset that surfaces of a document use. Only the id is present if the dataset could not be used when the document
 * was written.
 */
export interface NamedDataset {
    /** id of the dataset */
    dataset: string;
    /** display name */
    name?: string;
    /** fingerprint of the mesh and of the names of the fields; it stays the same when time-steps are added */
    fingerprint?: string;
    /** its time-steps */
    times?: TimesOfDataset;
    /** bounding box: x0, x1, y0, y1, z0, z1 (the dataset's unit of length) */
    bounds?: [number, number, number, number, number, number];
}

export const namedDatasetCheck = members<NamedDataset>({
    dataset: text,
    name: optional(text),
    fingerprint: optional(text),
    times: optional(timesOfDatasetCheck),
    bounds: optional(list(number, 6)),
});

/** The records of a session as in a snapshot, with their ids, but without `rev` and `epoch`. */
export interface FileRecords {
    /** all rakes */
    rakes: Record<string, unknown>[];
    /** all surfaces */
    surfaces: Record<string, unknown>[];
    /** all bookmarks */
    bookmarks: Record<string, unknown>[];
    /** all annotations */
    annotations: Record<string, unknown>[];
    /** the session's clock */
    clock: ClockRecord;
}

export const fileRecordsCheck = members<FileRecords>({
    rakes: list(anyObject),
    surfaces: list(anyObject),
    bookmarks: list(anyObject),
    annotations: list(anyObject),
    clock: clockRecordCheck,
});

/**
 * A session as one document. Any wakesurf server can import it; it is checked like edits, and imported as a whole or
 * not at all.
 */
export interface SessionFile {
    /** version of the format */
    wakesurfSession: 1;
    /** display name */
    name: string;
    /** when the document was written, in UTC */
    exported: string;
    /** version of the program that wrote it */
    wakesurf: string;
    /** the records of the session */
    records: FileRecords;
    /** datasets that the surfaces use */
    datasets: NamedDataset[];
    /** left out if no one has typed any */
    units?: Units;
}

export const sessionFileCheck = members<SessionFile>({
    wakesurfSession: oneOf([1]),
    name: text,
    exported: text,
    wakesurf: text,
    records: fileRecordsCheck,
    datasets: list(namedDatasetCheck),
    units: optional(unitsCheck),
});

/** Someone who was in a session. */
export interface Visitor {
    /** the name they had */
    name: string;
    /** their colour, #rrggbb */
    colour: string;
}

export const visitorCheck = members<Visitor>({ name: text, colour: text });

/** A session as a list shows it. */
export interface SessionEntry {
    /** id of the session */
    session: string;
    /** display name */
    name: string;
    /** number of participants who are in the session now */
    participants: number;
    /** people who have been in the session; the last to join is the first in the list */
    people: Visitor[];
    /** when the session was made, in UTC; not recorded for old sessions */
    created?: string;
    /** when the session was last used, in UTC */
    lastUsed: string;
    /** true: someone has edited it, beyond the first rake and surface that a page makes */
    edited: boolean;
    /** number of rakes */
    rakes: number;
    /** number of surfaces */
    surfaces: number;
    /** number of bookmarks */
    bookmarks: number;
    /** number of annotations */
    annotations: number;
    /** true: there is a picture of it */
    thumbnail: boolean;
    /** for a session in the trash: when it was deleted, in UTC */
    deletedAt?: string;
    /** for a session in the trash: until when it can be restored, in UTC */
    deletedUntil?: string;
}

export const sessionEntryCheck = members<SessionEntry>({
    session: text,
    name: text,
    participants: whole,
    people: list(visitorCheck),
    created: optional(text),
    lastUsed: text,
    edited: flag,
    rakes: whole,
    surfaces: whole,
    bookmarks: whole,
    annotations: whole,
    thumbnail: flag,
    deletedAt: optional(text),
    deletedUntil: optional(text),
});

/**
 * A change of a record: the record as it is now, or that it was deleted. For the type `session`: the name of the
 * session and its units.
 */
export interface Patch {
    /** what happened to the record */
    op: 'put' | 'delete';
    /** kind of record */
    type: 'rake' | 'surface' | 'bookmark' | 'annotation' | 'clock' | 'session';
    /** id of the record */
    id: string;
    /** for put: the record as it is now */
    record?: RakeRecord | SurfaceRecord | BookmarkRecord | AnnotationRecord | ClockRecord | SessionName;
}

export const patchCheck = members<Patch>({
    op: oneOf(['put', 'delete']),
    type: oneOf(['rake', 'surface', 'bookmark', 'annotation', 'clock', 'session']),
    id: text,
    record: optional(
        either([
            rakeRecordCheck,
            surfaceRecordCheck,
            bookmarkRecordCheck,
            annotationRecordCheck,
            clockRecordCheck,
            sessionNameCheck,
        ]),
    ),
});

/** What session.join returns: either `snapshot` or `patches`. */
export interface Joined {
    /** your id as a participant */
    you: string;
    /** your role in the session */
    role: Role;
    /**
     * token with which you can come back; if it differs from the one you sent, nothing from before is valid: no epoch,
     * `seq` or subscription
     */
    resumeToken: string;
    /** `seq` of the session now */
    seq: number;
    /** all participants */
    participants: Participant[];
    /** when the session was made, in UTC, as in session.list */
    created?: string;
    /** for a session that session.fork has made: the one it is a copy of, with the name it had then */
    copyOf?: SessionName;
    /** true: `patches` is present; false: `snapshot` is present */
    resumed: boolean;
    /** all records of the session */
    snapshot?: Snapshot;
    /** what changed after `lastSeq`; for each record only the newest change */
    patches?: Patch[];
}

export const joinedCheck = members<Joined>({
    you: text,
    role: roleCheck,
    resumeToken: text,
    seq: whole,
    participants: list(participantCheck),
    created: optional(text),
    copyOf: optional(sessionNameCheck),
    resumed: flag,
    snapshot: optional(snapshotCheck),
    patches: optional(list(patchCheck)),
});

/** Parameters of session.create. */
export interface SessionCreateParams {
    /** display name */
    name?: string;
}

/** Parameters of session.fork. */
export interface SessionForkParams extends InSession {
    /** display name */
    name?: string;
}

/** What session.fork answers. */
export interface SessionForkResult {
    /** id of the session */
    session: string;
    /** display name */
    name: string;
    /** how many more sessions can be made */
    remaining: number;
    /** with a share link: secret key of a link into the copy; it is returned only this once */
    key?: string;
    /** with a share link: what to append to the address of the page */
    link?: string;
}

/** Parameters of session.list. */
export interface SessionListParams {
    /** true: list the deleted sessions instead */
    trash?: boolean;
}

/** What session.list answers. */
export interface SessionListResult {
    /** all sessions */
    sessions: SessionEntry[];
    /** how many sessions the server keeps */
    limit: number;
    /** how many deleted sessions the server keeps */
    trashLimit: number;
}

/** Parameters of session.join. */
export interface SessionJoinParams {
    /** an id from session.list or session.create; if left out, the share link's session, or else `main` */
    session?: string;
    /** display name */
    name?: string;
    /** #rrggbb; if left out, a colour that few others have */
    colour?: string;
    /** token of an earlier stay, to take up its place again */
    resumeToken?: string;
    /** with `resumeToken`: the last `seq` seen; what was missed is returned instead of the snapshot */
    lastSeq?: number;
}

/** Parameters of session.state. */
export type SessionStateParams = InSession;

/** What session.state answers. */
export interface SessionStateResult {
    /** id of the session */
    session: string;
    /** display name */
    name: string;
    /** left out if no one has typed any */
    units?: Units;
    /** all rakes */
    rakes: RakeRecord[];
    /** all surfaces */
    surfaces: SurfaceRecord[];
    /** all bookmarks */
    bookmarks: BookmarkRecord[];
    /** all annotations */
    annotations: AnnotationRecord[];
    /** the session's clock */
    clock: ClockRecord;
    /** records that are kept aside, if there are any */
    keptAside?: KeptAside;
    /** `seq` of the session now */
    seq: number;
    /** all participants */
    participants: Participant[];
}

/** Parameters of session.rename. */
export interface SessionRenameParams extends InSession {
    /** display name */
    name: string;
}

/** Parameters of session.setUnits. */
export interface SessionSetUnitsParams extends InSession {
    /** unit of lengths; empty: as in dataset.describe */
    length: string;
    /** unit of times; empty: as in dataset.describe */
    time: string;
}

/** Parameters of session.delete. */
export interface SessionDeleteParams {
    /** an id from session.list */
    session: string;
    /** true: permanently deletes a session that is in the trash */
    forever?: boolean;
}

/** What session.delete answers. */
export interface SessionDeleteResult {
    /** id of the session */
    session: string;
    /** until when the session can be restored, in UTC */
    deletedUntil?: string;
}

/** Parameters of session.restore. */
export interface SessionRestoreParams {
    /** an id from session.list */
    session: string;
}

/** Parameters of session.export. */
export type SessionExportParams = InSession;

/** What session.export answers. */
export interface SessionExportResult {
    /** the session as a document */
    file: SessionFile;
}

/** Parameters of session.import. */
export interface SessionImportParams {
    /** the `file` that session.export returned */
    file: Record<string, unknown>;
    /** name of the new session; if left out, the name in the document */
    name?: string;
}

/** What session.import answers. */
export interface SessionImportResult {
    /** id of the session */
    session: string;
    /** display name */
    name: string;
    /** how many more sessions can be made */
    remaining: number;
    /** for people: which datasets this server does not have, or which differ here */
    notes: string[];
}

/** Parameters of session.thumbnail. */
export interface SessionThumbnailParams extends InSession {
    /** a PNG, JPEG or WebP picture of at most 24 KiB, in base64 */
    image: string;
}
