// Made by protocol/api/generate from presence.schema.json: do not edit.
import { flag, list, matching, members, number, optional, orNull, point, text } from '../checks.ts';
import { type Vec3 } from '../vec3.ts';
import { roleCheck, type Role } from './shared.ts';

/** Where someone looks from. */
export interface Camera {
    /** of the eye (the dataset's unit of length) */
    position: Vec3;
    /** what is in the middle of the picture (the dataset's unit of length) */
    target: Vec3;
    /** points up in the picture (the dataset's unit of length) */
    up: Vec3;
    /** from top to bottom; left out: orthographic, or unknown (degrees) */
    fov?: number;
}

export const cameraCheck = members<Camera>({ position: point, target: point, up: point, fov: optional(number) });

/** A rake as it is on its way. */
export interface DraggedRake {
    /** its id */
    rake: string;
    /** where it is now */
    points?: Vec3[];
}

export const draggedRakeCheck = members<DraggedRake>({ rake: text, points: optional(list(point)) });

/** What someone does just now. */
export interface Presence {
    /** what they point at (the dataset's unit of length) */
    pointer?: Vec3 | null;
    /** where they look from */
    camera?: Camera | null;
    /** what they drag */
    dragging?: DraggedRake | null;
    /** id of the record they have selected */
    selected?: string | null;
}

export const presenceCheck = members<Presence>({
    pointer: optional(orNull(point)),
    camera: optional(orNull(cameraCheck)),
    dragging: optional(orNull(draggedRakeCheck)),
    selected: optional(orNull(text)),
});

/** Someone in a session. A notification has only what changed; null: taken away. */
export interface Participant {
    /** their id */
    participant: string;
    /** two people of a session are never called the same */
    name: string;
    /** #rrggbb */
    colour: string;
    /** what someone may do: each role includes the one before */
    role: Role;
    /** false: the connection was lost less than 10 s ago */
    connected: boolean;
    /** what they point at (the dataset's unit of length) */
    pointer?: Vec3 | null;
    /** where they look from */
    camera?: Camera | null;
    /** what they drag */
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

/** Parameters of presence.update. */
export interface PresenceUpdateParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** what they point at (the dataset's unit of length) */
    pointer?: Vec3 | null;
    /** where they look from */
    camera?: Camera | null;
    /** what they drag */
    dragging?: DraggedRake | null;
    /** id of the record they have selected */
    selected?: string | null;
}
