// Made by protocol/api/generate from bookmark.schema.json: do not edit.
import { anyObject, members, number, optional, text, whole } from '../checks.ts';
import type { InSession } from './shared.ts';

/** A bookmark as the session keeps it. */
export interface BookmarkRecord {
    /** id of the bookmark */
    bookmark: string;
    /** counts the edits of a record */
    rev: number;
    /** display name */
    name: string;
    /** camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text */
    view: Record<string, unknown>;
    /** the session's time that belongs to the view (the dataset's unit of time) */
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
export interface BookmarkSetParams extends InSession {
    /** id of the bookmark to replace; if left out, a new one is created */
    bookmark?: string;
    /** display name */
    name?: string;
    /** camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text */
    view: Record<string, unknown>;
    /** the session's time that belongs to the view (the dataset's unit of time) */
    time?: number;
    /** a name for what the user is doing; consecutive edits with the same name are one step of undo */
    gesture?: string;
    /** the edit is refused if the record is at another revision */
    ifRev?: number;
}

/** What bookmark.set answers. */
export interface BookmarkSetResult {
    /** id of the bookmark */
    bookmark: string;
    /** counts the edits of a record */
    rev: number;
    /** `seq` of the session after the edit */
    seq: number;
}

/** Parameters of bookmark.delete. */
export interface BookmarkDeleteParams extends InSession {
    /** an id from bookmark.list */
    bookmark: string;
    /** a name for what the user is doing; consecutive edits with the same name are one step of undo */
    gesture?: string;
    /** the edit is refused if the record is at another revision */
    ifRev?: number;
}

/** Parameters of bookmark.list. */
export type BookmarkListParams = InSession;

/** What bookmark.list answers. */
export interface BookmarkListResult {
    /** all bookmarks */
    bookmarks: BookmarkRecord[];
}
