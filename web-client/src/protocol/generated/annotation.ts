// Made by protocol/api/generate from annotation.schema.json: do not edit.
import { members, optional, point, text, whole } from '../checks.ts';
import type { Vec3 } from '../vec3.ts';
import type { InSession } from './shared.ts';

/** An annotation as the session keeps it. */
export interface AnnotationRecord {
    /** id of the annotation */
    annotation: string;
    /** counts the edits of a record */
    rev: number;
    /** text of one or more lines */
    text: string;
    /** the point that it refers to (the dataset's unit of length) */
    position: Vec3;
    /** name of the one who made it */
    author: string;
    /** id of the surface that it refers to, which may have been deleted since */
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
export interface AnnotationSetParams extends InSession {
    /** id of the annotation to replace; if left out, a new one is created */
    annotation?: string;
    /** text of one or more lines */
    text: string;
    /** the point that it refers to (the dataset's unit of length) */
    position: Vec3;
    /** id of the surface that it refers to, which may have been deleted since */
    surface?: string;
    /** a name for what the user is doing; consecutive edits with the same name are one step of undo */
    gesture?: string;
    /** the edit is refused if the record is at another revision */
    ifRev?: number;
}

/** What annotation.set answers. */
export interface AnnotationSetResult {
    /** id of the annotation */
    annotation: string;
    /** counts the edits of a record */
    rev: number;
    /** `seq` of the session after the edit */
    seq: number;
}

/** Parameters of annotation.delete. */
export interface AnnotationDeleteParams extends InSession {
    /** an id from annotation.list */
    annotation: string;
    /** a name for what the user is doing; consecutive edits with the same name are one step of undo */
    gesture?: string;
    /** the edit is refused if the record is at another revision */
    ifRev?: number;
}

/** Parameters of annotation.list. */
export type AnnotationListParams = InSession;

/** What annotation.list answers. */
export interface AnnotationListResult {
    /** all annotations */
    annotations: AnnotationRecord[];
}
