// Made by protocol/api/generate from history.schema.json: do not edit.
import { members, oneOf, optional, text, whole } from '../checks.ts';
import type { InSession } from './shared.ts';

/** A record that was changed. */
export interface Change {
    /** what happened to the record */
    op: 'put' | 'delete';
    /** kind of record: rake, surface, bookmark or annotation */
    type: string;
    /** id of the record */
    id: string;
    /** counts the edits of a record */
    rev?: number;
}

export const changeCheck = members<Change>({ op: oneOf(['put', 'delete']), type: text, id: text, rev: optional(whole) });

/** A record that was skipped because someone else has changed it since. */
export interface Skip {
    /** kind of record: rake, surface, bookmark or annotation */
    type: string;
    /** id of the record */
    id: string;
    /** why it was skipped, for people */
    why: string;
}

export const skipCheck = members<Skip>({ type: text, id: text, why: text });

/** Parameters of history.undo. */
export type HistoryUndoParams = InSession;

/** What history.undo answers. */
export interface HistoryUndoResult {
    /** what has changed; null: nothing */
    undone: Change[] | null;
    /** `seq` of the session after the edit */
    seq: number;
    /** records that were skipped; their edits are forgotten for good */
    skipped: Skip[];
    /** number of edits that can still be taken back */
    undo: number;
    /** number of edits that can be repeated */
    redo: number;
}

/** Parameters of history.redo. */
export type HistoryRedoParams = InSession;

/** What history.redo answers. */
export interface HistoryRedoResult {
    /** what has changed; null: nothing */
    redone: Change[] | null;
    /** `seq` of the session after the edit */
    seq: number;
    /** records that were skipped; their edits are forgotten for good */
    skipped: Skip[];
    /** number of edits that can still be taken back */
    undo: number;
    /** number of edits that can be repeated */
    redo: number;
}
