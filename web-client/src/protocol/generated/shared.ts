// Made by protocol/api/generate from shared.schema.json: do not edit.
import { flag, members, number, oneOf, optional, point, text, whole } from '../checks.ts';
import { type Vec3 } from '../vec3.ts';

/** what someone may do: each role includes the one before */
export const roles = ['viewer', 'editor', 'host'] as const;
export type Role = (typeof roles)[number];
export const roleCheck = oneOf(roles);

/** The integer grid of a dataset's frames: node (i, j, k) lies at origin + step * (i, j, k). */
export interface Lattice {
    /** of node (0, 0, 0) (the dataset's unit of length) */
    origin: Vec3;
    /** between nodes (the dataset's unit of length) */
    step: number;
    /** there are 2^bits nodes a side */
    bits: number;
}

export const latticeCheck = members<Lattice>({ origin: point, step: number, bits: whole });

/** An error as a value, where the call itself did not fail. */
export interface Problem {
    /** as of an error */
    code: number;
    /** what is wrong */
    message: string;
    /** a word for programs */
    kind: string;
    /** a sentence for people: what to do; may be empty */
    hint: string;
    /** of overLimit: the most that is granted */
    limit?: number;
}

export const problemCheck = members<Problem>({ code: whole, message: text, kind: text, hint: text, limit: optional(number) });

/** Of every method on the records of a session. */
export interface InSession {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

export const inSessionCheck = members<InSession>({ session: optional(text) });

/** Of every edit of a record. */
export interface Edit {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** a name for what the user does; edits that follow each other with the same one are one step of undo */
    gesture?: string;
    /** refuse the edit if the record is at another revision */
    ifRev?: number;
}

export const editCheck = members<Edit>({ session: optional(text), gesture: optional(text), ifRev: optional(whole) });

/** Of what makes the first records of a session. */
export interface FirstRecord {
    /**
     * true: only if no one has edited the session and there is no such record yet; it counts as no edit, so undo does
     * not turn it
     */
    default?: boolean;
}

export const firstRecordCheck = members<FirstRecord>({ default: optional(flag) });

/** Of the answer to an edit. */
export interface AfterEdit {
    /** of the session after the edit */
    seq: number;
}

export const afterEditCheck = members<AfterEdit>({ seq: whole });

/** Of the answer to an edit of a server that keeps sessions. */
export interface Durability {
    /** the edit is on the server's disk; only there with --state */
    durable?: boolean;
    /** why it is not */
    hint?: string;
}

export const durabilityCheck = members<Durability>({ durable: optional(flag), hint: optional(text) });
