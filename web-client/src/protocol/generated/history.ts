// Made by protocol/api/generate from history.schema.json: do not edit.
import { list, members, oneOf, optional, text, whole } from '../checks.ts';

/** A record that was changed. */
export interface Change {
    /** what became of it */
    op: 'put' | 'delete';
    /** rake, surface, bookmark or annotation */
    type: string;
    /** of the record */
    id: string;
    /** counts the edits of a record */
    rev?: number;
}

export const changeCheck = members<Change>({ op: oneOf(['put', 'delete']), type: text, id: text, rev: optional(whole) });

/** A record that someone else has changed since. */
export interface Skip {
    /** rake, surface, bookmark or annotation */
    type: string;
    /** of the record */
    id: string;
    /** it was skipped, for people */
    why: string;
}

export const skipCheck = members<Skip>({ type: text, id: text, why: text });

/** What there is to undo and redo. */
export interface HistoryDepth {
    /** of the session after the edit */
    seq: number;
    /** edits that are forgotten, once and for all */
    skipped: Skip[];
    /** edits that can still be taken back */
    undo: number;
    /** edits that can be made again */
    redo: number;
}

export const historyDepthCheck = members<HistoryDepth>({ seq: whole, skipped: list(skipCheck), undo: whole, redo: whole });

/** Parameters of history.undo. */
export interface HistoryUndoParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What history.undo answers. */
export interface HistoryUndoResult {
    /** what has changed; null: nothing */
    undone: Change[] | null;
    /** of the session after the edit */
    seq: number;
    /** edits that are forgotten, once and for all */
    skipped: Skip[];
    /** edits that can still be taken back */
    undo: number;
    /** edits that can be made again */
    redo: number;
}

/** Parameters of history.redo. */
export interface HistoryRedoParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What history.redo answers. */
export interface HistoryRedoResult {
    /** what has changed; null: nothing */
    redone: Change[] | null;
    /** of the session after the edit */
    seq: number;
    /** edits that are forgotten, once and for all */
    skipped: Skip[];
    /** edits that can still be taken back */
    undo: number;
    /** edits that can be made again */
    redo: number;
}
