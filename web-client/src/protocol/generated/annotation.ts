// Made by protocol/api/generate from annotation.schema.json: do not edit.
import { members, optional, point, text, whole } from '../checks.ts';
import { type Vec3 } from '../vec3.ts';

/** What an annotation says. */
export interface AnnotationFields {
    /** of one line or several */
    text: string;
    /** where it points to (the dataset's unit of length) */
    position: Vec3;
    /** the surface it speaks of, which may be gone since */
    surface?: string;
}

export const annotationFieldsCheck = members<AnnotationFields>({ text, position: point, surface: optional(text) });

/** An annotation as the session keeps it. */
export interface AnnotationRecord {
    /** its id */
    annotation: string;
    /** counts the edits of a record */
    rev: number;
    /** of one line or several */
    text: string;
    /** where it points to (the dataset's unit of length) */
    position: Vec3;
    /** the name of the one who made it */
    author: string;
    /** the surface it speaks of, which may be gone since */
    surface?: string;
}

export const annotationRecordCheck = members<AnnotationRecord>({
    annotation: text,
    rev: whole,
    text,
    position: point,
    author: text,
    surface: optional(text),
});

/** Parameters of annotation.set. */
export interface AnnotationSetParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** left out: create one */
    annotation?: string;
    /** of one line or several */
    text: string;
    /** where it points to (the dataset's unit of length) */
    position: Vec3;
    /** the surface it speaks of, which may be gone since */
    surface?: string;
    /** a name for what the user does; edits that follow each other with the same one are one step of undo */
    gesture?: string;
    /** refuse the edit if the record is at another revision */
    ifRev?: number;
}

/** What annotation.set answers. */
export interface AnnotationSetResult {
    /** its id */
    annotation: string;
    /** counts the edits of a record */
    rev: number;
    /** of the session after the edit */
    seq: number;
}

/** Parameters of annotation.delete. */
export interface AnnotationDeleteParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from annotation.list */
    annotation: string;
    /** a name for what the user does; edits that follow each other with the same one are one step of undo */
    gesture?: string;
    /** refuse the edit if the record is at another revision */
    ifRev?: number;
}

/** Parameters of annotation.list. */
export interface AnnotationListParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
}

/** What annotation.list answers. */
export interface AnnotationListResult {
    /** all of them */
    annotations: AnnotationRecord[];
}

/** What of a record annotation.set asks for, beside its id. */
export const annotationAskedNames = ['text', 'position', 'surface'] as const;
