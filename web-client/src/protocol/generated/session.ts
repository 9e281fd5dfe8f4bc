// Made by protocol/api/generate from session.schema.json: do not edit.
import { anyObject, either, flag, list, members, number, oneOf, optional, text, whole } from '../checks.ts';
import { annotationRecordCheck, type AnnotationRecord } from './annotation.ts';
import { bookmarkRecordCheck, type BookmarkRecord } from './bookmark.ts';
import { participantCheck, type Participant } from './presence.ts';
import { rakeRecordCheck, type RakeRecord } from './rake.ts';
import { roleCheck, type Role } from './shared.ts';
import { surfaceRecordCheck, type SurfaceRecord } from './surface.ts';
import { clockRecordCheck, type ClockRecord } from './time.ts';

/** A record that could not be used when the server started. */
export interface AsideRecord {
    /** rake, surface, bookmark or annotation */
    type: string;
    /** of the record */
    id: string;
    /** it could not be used */
    why: string;
    /** when it was put aside (s since 1970) */
    since: number;
}

export const asideRecordCheck = members<AsideRecord>({ type: text, id: text, why: text, since: whole });

/** Records that could not be used when the server started; nothing of them is deleted. */
export interface KeptAside {
    /** of all of them */
    count: number;
    /** the newest 50 */
    records: AsideRecord[];
}

export const keptAsideCheck = members<KeptAside>({ count: whole, records: list(asideRecordCheck) });

/** Every record of a session. */
export interface Snapshot {
    /** its id */
    session: string;
    /** for people */
    name: string;
    /** all of them */
    rakes: RakeRecord[];
    /** all of them */
    surfaces: SurfaceRecord[];
    /** all of them */
    bookmarks: BookmarkRecord[];
    /** all of them */
    annotations: AnnotationRecord[];
    /**
     * A session's clock. `time` is as the message is written; it runs on by `speed` while `playing`, up to `to`, and
     * there it stops or goes on at `from` (`loop`).
     */
    clock: ClockRecord;
    /** where there are such records */
    keptAside?: KeptAside;
}

export const snapshotCheck = members<Snapshot>({
    session: text,
    name: text,
    rakes: list(rakeRecordCheck),
    surfaces: list(surfaceRecordCheck),
    bookmarks: list(bookmarkRecordCheck),
    annotations: list(annotationRecordCheck),
    clock: clockRecordCheck,
    keptAside: optional(keptAsideCheck),
});

/** A session and what it is called. */
export interface SessionName {
    /** its id */
    session: string;
    /** for people */
    name: string;
}

export const sessionNameCheck = members<SessionName>({ session: text, name: text });

/** A new session. */
export interface SessionMade {
    /** its id */
    session: string;
    /** for people */
    name: string;
    /** how many more sessions can be made */
    remaining: number;
}

export const sessionMadeCheck = members<SessionMade>({ session: text, name: text, remaining: whole });

/** The time-steps of a dataset. */
export interface TimesOfDataset {
    /** how many */
    count: number;
    /** time of the first one (the dataset's unit of time) */
    first: number;
    /** time of the last one (the dataset's unit of time) */
    last: number;
}

export const timesOfDatasetCheck = members<TimesOfDataset>({ count: whole, first: number, last: number });

/** A dataset that surfaces of a file name; only its id where it could not be used when the file was written. */
export interface NamedDataset {
    /** its id */
    dataset: string;
    /** for people */
    name?: string;
    /** of the mesh and the names of the fields, the same for a dataset that grows */
    fingerprint?: string;
    /** The time-steps of a dataset. */
    times?: TimesOfDataset;
    /** x0, x1, y0, y1, z0, z1 (the dataset's unit of length) */
    bounds?: [number, number, number, number, number, number];
}

export const namedDatasetCheck = members<NamedDataset>({
    dataset: text,
    name: optional(text),
    fingerprint: optional(text),
    times: optional(timesOfDatasetCheck),
    bounds: optional(list(number, 6)),
});

/** As in a snapshot, without rev and epoch; ids stay. */
export interface FileRecords {
    /** all of them */
    rakes: Record<string, unknown>[];
    /** all of them */
    surfaces: Record<string, unknown>[];
    /** all of them */
    bookmarks: Record<string, unknown>[];
    /** all of them */
    annotations: Record<string, unknown>[];
    /**
     * A session's clock. `time` is as the message is written; it runs on by `speed` while `playing`, up to `to`, and
     * there it stops or goes on at `from` (`loop`).
     */
    clock: ClockRecord;
}

export const fileRecordsCheck = members<FileRecords>({
    rakes: list(anyObject),
    surfaces: list(anyObject),
    bookmarks: list(anyObject),
    annotations: list(anyObject),
    clock: clockRecordCheck,
});

/** A session as one document, which any wakesurf takes in, checked like edits and as a whole or not at all. */
export interface SessionFile {
    /** version of the format */
    wakesurfSession: 1;
    /** for people */
    name: string;
    /** when it was written, in UTC */
    exported: string;
    /** version of the program */
    wakesurf: string;
    /** As in a snapshot, without rev and epoch; ids stay. */
    records: FileRecords;
    /** that surfaces name */
    datasets: NamedDataset[];
}

export const sessionFileCheck = members<SessionFile>({
    wakesurfSession: oneOf([1]),
    name: text,
    exported: text,
    wakesurf: text,
    records: fileRecordsCheck,
    datasets: list(namedDatasetCheck),
});

/** Someone who was in a session. */
export interface Visitor {
    /** what they were called */
    name: string;
    /** #rrggbb */
    colour: string;
}

export const visitorCheck = members<Visitor>({ name: text, colour: text });

/** A session in a list. */
export interface SessionEntry {
    /** its id */
    session: string;
    /** for people */
    name: string;
    /** who are here now */
    participants: number;
    /** who were here; the last to come is the first */
    people: Visitor[];
    /** in UTC; missing where the session is older than this was noted */
    created?: string;
    /** in UTC */
    lastUsed: string;
    /** by anyone, beyond the first rake and surface that a page puts there */
    edited: boolean;
    /** how many */
    rakes: number;
    /** how many */
    surfaces: number;
    /** how many */
    bookmarks: number;
    /** how many */
    annotations: number;
    /** there is a picture of it */
    thumbnail: boolean;
    /** in UTC; of a session in the trash */
    deletedAt?: string;
    /** in UTC; it can be restored until then */
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

/** a kind of record */
export const recordTypes = ['rake', 'surface', 'bookmark', 'annotation'] as const;
export type RecordType = (typeof recordTypes)[number];
export const recordTypeCheck = oneOf(recordTypes);

/** A record as it is now, or that it is gone. Of the type session: the session's name. */
export interface Patch {
    /** what became of it */
    op: 'put' | 'delete';
    /** of the record */
    type: 'rake' | 'surface' | 'bookmark' | 'annotation' | 'clock' | 'session';
    /** of the record */
    id: string;
    /** as it is now; of put */
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

/** What session.join answers: either `snapshot` or `patches`. */
export interface Joined {
    /** your id as a participant */
    you: string;
    /** what someone may do: each role includes the one before */
    role: Role;
    /** to come back with; another one than was sent means that nothing from before holds: no epoch, seq or subscription */
    resumeToken: string;
    /** of the session now */
    seq: number;
    /** all of them */
    participants: Participant[];
    /** in UTC, as in session.list */
    created?: string;
    /** true: `patches` come; false: `snapshot` comes */
    resumed: boolean;
    /** Every record of a session. */
    snapshot?: Snapshot;
    /** what changed after `lastSeq`: of each record the newest change */
    patches?: Patch[];
}

export const joinedCheck = members<Joined>({
    you: text,
    role: roleCheck,
    resumeToken: text,
    seq: whole,
    participants: list(participantCheck),
    created: optional(text),
    resumed: flag,
    snapshot: optional(snapshotCheck),
    patches: optional(list(patchCheck)),
});

/** Parameters of session.create. */
export interface SessionCreateParams {
    /** for people */
    name?: string;
}

/** Parameters of session.fork. */
export interface SessionForkParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** for people */
    name?: string;
}

/** Parameters of session.list. */
export interface SessionListParams {
    /** true: those that were deleted instead */
    trash?: boolean;
}

/** What session.list answers. */
export interface SessionListResult {
    /** all of them */
    sessions: SessionEntry[];
    /** how many sessions the server keeps */
    limit: number;
    /** and how many deleted ones */
    trashLimit: number;
}

/** Parameters of session.join. */
export interface SessionJoinParams {
    /** an id from session.list or session.create; left out: the share link's, else `main` */
    session?: string;
    /** for people */
    name?: string;
    /** #rrggbb; left out: one that few others have */
    colour?: string;
    /** of an earlier stay, to take up its place again */
    resumeToken?: string;
    /** with resumeToken: the last seq seen; what was missed comes instead of the snapshot */
    lastSeq?: number;
}

/** Parameters of session.state. */
export interface SessionStateParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What session.state answers. */
export interface SessionStateResult {
    /** its id */
    session: string;
    /** for people */
    name: string;
    /** all of them */
    rakes: RakeRecord[];
    /** all of them */
    surfaces: SurfaceRecord[];
    /** all of them */
    bookmarks: BookmarkRecord[];
    /** all of them */
    annotations: AnnotationRecord[];
    /**
     * A session's clock. `time` is as the message is written; it runs on by `speed` while `playing`, up to `to`, and
     * there it stops or goes on at `from` (`loop`).
     */
    clock: ClockRecord;
    /** where there are such records */
    keptAside?: KeptAside;
    /** of the session now */
    seq: number;
    /** all of them */
    participants: Participant[];
}

/** Parameters of session.rename. */
export interface SessionRenameParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** for people */
    name: string;
}

/** Parameters of session.delete. */
export interface SessionDeleteParams {
    /** an id from session.list */
    session: string;
    /** true: removes a session that is in the trash for good */
    forever?: boolean;
}

/** What session.delete answers. */
export interface SessionDeleteResult {
    /** its id */
    session: string;
    /** in UTC; it can be restored until then */
    deletedUntil?: string;
}

/** Parameters of session.restore. */
export interface SessionRestoreParams {
    /** an id from session.list */
    session: string;
}

/** Parameters of session.export. */
export interface SessionExportParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What session.export answers. */
export interface SessionExportResult {
    /** the document */
    file: SessionFile;
}

/** Parameters of session.import. */
export interface SessionImportParams {
    /** what session.export answered */
    file: Record<string, unknown>;
    /** left out: the document's */
    name?: string;
}

/** What session.import answers. */
export interface SessionImportResult {
    /** its id */
    session: string;
    /** for people */
    name: string;
    /** how many more sessions can be made */
    remaining: number;
    /** for people: which datasets are not here, or are other ones */
    notes: string[];
}

/** Parameters of session.thumbnail. */
export interface SessionThumbnailParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** base64 of a PNG, JPEG or WebP picture of at most 24 KiB */
    image: string;
}
