// Made by protocol/api/generate from bookmark.schema.json: do not edit.
import { anyObject, members, number, optional, text, whole } from '../checks.ts';

/** What a bookmark says. */
export interface BookmarkFields {
    /** camera, colours and the like, as the client that made it likes; at most 4 KiB as JSON text */
    view: Record<string, unknown>;
    /** the session's time the view belongs to (the dataset's unit of time) */
    time?: number;
}

export const bookmarkFieldsCheck = members<BookmarkFields>({ view: anyObject, time: optional(number) });

/** A bookmark as the session keeps it. */
export interface BookmarkRecord {
    /** its id */
    bookmark: string;
    /** counts the edits of a record */
    rev: number;
    /** for people */
    name: string;
    /** camera, colours and the like, as the client that made it likes; at most 4 KiB as JSON text */
    view: Record<string, unknown>;
    /** the session's time the view belongs to (the dataset's unit of time) */
    time?: number;
}

export const bookmarkRecordCheck = members<BookmarkRecord>({
    bookmark: text,
    rev: whole,
    name: text,
    view: anyObject,
    time: optional(number),
});

/** Parameters of bookmark.set. */
export interface BookmarkSetParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** left out: create one */
    bookmark?: string;
    /** for people */
    name?: string;
    /** camera, colours and the like, as the client that made it likes; at most 4 KiB as JSON text */
    view: Record<string, unknown>;
    /** the session's time the view belongs to (the dataset's unit of time) */
    time?: number;
    /** a name for what the user does; edits that follow each other with the same one are one step of undo */
    gesture?: string;
    /** refuse the edit if the record is at another revision */
    ifRev?: number;
}

/** What bookmark.set answers. */
export interface BookmarkSetResult {
    /** its id */
    bookmark: string;
    /** counts the edits of a record */
    rev: number;
    /** of the session after the edit */
    seq: number;
}

/** Parameters of bookmark.delete. */
export interface BookmarkDeleteParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from bookmark.list */
    bookmark: string;
    /** a name for what the user does; edits that follow each other with the same one are one step of undo */
    gesture?: string;
    /** refuse the edit if the record is at another revision */
    ifRev?: number;
}

/** Parameters of bookmark.list. */
export interface BookmarkListParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What bookmark.list answers. */
export interface BookmarkListResult {
    /** all of them */
    bookmarks: BookmarkRecord[];
}

/** What of a record bookmark.set asks for, beside its id. */
export const bookmarkAskedNames = ['name', 'view', 'time'] as const;

/** What holds of a bookmark where bookmark.set is not told. */
export const bookmarkDefaults = {
    name: '',
};
