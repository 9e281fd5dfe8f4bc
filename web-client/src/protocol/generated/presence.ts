// Made by protocol/api/generate from presence.schema.json: do not edit.
import { flag, list, matching, members, number, optional, orNull, point, text } from '../checks.ts';
import type { Vec3 } from '../vec3.ts';
import { type InSession, type Role, roleCheck } from './shared.ts';

/** Where someone looks from. */
export interface Camera {
    /** position of the eye (the dataset's unit of length) */
    position: Vec3;
    /** the point in the middle of the picture (the dataset's unit of length) */
    target: Vec3;
    /** direction that points up in the picture (the dataset's unit of length) */
    up: Vec3;
    /** field of view from top to bottom; if left out, the view is orthographic or unknown (degrees) */
    fov?: number;
}

export const cameraCheck = members<Camera>({ position: point, target: point, up: point, fov: optional(number) });

/** A rake while it is dragged. */
export interface DraggedRake {
    /** id of the rake */
    rake: string;
    /** where the rake is now */
    points?: Vec3[];
}

export const draggedRakeCheck = members<DraggedRake>({ rake: text, points: optional(list(point)) });

/** Someone in a session. A notification has only what changed; null: no longer there. */
export interface Participant {
    /** id of the participant */
    participant: string;
    /** display name; two people in a session never have the same one */
    name: string;
    /** their colour, #rrggbb */
    colour: string;
    /** what someone may do; each role includes the ones before it */
    role: Role;
    /** false: the connection was lost less than 10 s ago */
    connected: boolean;
    /** the point they point at (the dataset's unit of length) */
    pointer?: Vec3 | null;
    /** where they look from */
    camera?: Camera | null;
    /** the rake they drag */
    dragging?: DraggedRake | null;
    /** id of the record they have selected */
    selected?: string | null;
}

export const participantCheck = members<Participant>({
    participant: text,
    name: text,
    colour: matching(/^#[0-9a-fA-F]{6}$/),
    role: roleCheck,
    connected: flag,
    pointer: optional(orNull(point)),
    camera: optional(orNull(cameraCheck)),
    dragging: optional(orNull(draggedRakeCheck)),
    selected: optional(orNull(text)),
});

/** What has changed of a Participant; null: it has been taken away. */
export type ParticipantChange = Partial<Participant> & { participant: string };
export const participantChangeCheck = members<ParticipantChange>({
    participant: text,
    name: optional(text),
    colour: optional(matching(/^#[0-9a-fA-F]{6}$/)),
    role: optional(roleCheck),
    connected: optional(flag),
    pointer: optional(orNull(point)),
    camera: optional(orNull(cameraCheck)),
    dragging: optional(orNull(draggedRakeCheck)),
    selected: optional(orNull(text)),
});

/** Parameters of presence.update. */
export interface PresenceUpdateParams extends InSession {
    /** the point they point at (the dataset's unit of length) */
    pointer?: Vec3 | null;
    /** where they look from */
    camera?: Camera | null;
    /** the rake they drag */
    dragging?: DraggedRake | null;
    /** id of the record they have selected */
    selected?: string | null;
}
