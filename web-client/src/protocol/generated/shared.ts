// Made by protocol/api/generate from shared.schema.json: do not edit.
import { members, number, oneOf, optional, point, text, whole } from '../checks.ts';
import type { Vec3 } from '../vec3.ts';

/** The parameter of every method on the records of a session. */
export interface InSession {
    /** an id from session.list; it may be left out on a WebSocket that has joined a session, and with a share link */
    session?: string;
}

/** what someone may do; each role includes the ones before it */
export const roles = ['viewer', 'editor', 'host'] as const;
export type Role = (typeof roles)[number];
export const roleCheck = oneOf(roles);

/** The integer grid of a dataset's frames: node (i, j, k) lies at origin + step * (i, j, k). */
export interface Lattice {
    /** position of node (0, 0, 0) (the dataset's unit of length) */
    origin: Vec3;
    /** distance between neighbouring nodes (the dataset's unit of length) */
    step: number;
    /** there are 2^bits nodes along each side */
    bits: number;
}

export const latticeCheck = members<Lattice>({ origin: point, step: number, bits: whole });

/** An error that is part of a result, where the call itself did not fail. */
export interface Problem {
    /** code of the error */
    code: number;
    /** what is wrong */
    message: string;
    /** a word for programs */
    kind: string;
    /** a sentence for people: what to do about it; may be empty */
    hint: string;
    /** for overLimit: the most that is allowed */
    limit?: number;
}

export const problemCheck = members<Problem>({ code: whole, message: text, kind: text, hint: text, limit: optional(number) });

/** What every edit returns. */
export interface AfterEdit {
    /** `seq` of the session after the edit */
    seq: number;
}

export const afterEditCheck = members<AfterEdit>({ seq: whole });
