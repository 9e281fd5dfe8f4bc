// The records of a session, of datasets and of people, under the names that this client has for them. Shapes
// and checks are made from the description of the API: generated/.
import { is } from './checks.ts';
import { type AnnotationRecord, annotationRecordCheck } from './generated/annotation.ts';
import { type BookmarkRecord, bookmarkRecordCheck } from './generated/bookmark.ts';
import { type RakeRecord, rakeRecordCheck } from './generated/rake.ts';
import { sessionNameCheck } from './generated/session.ts';
import { type SurfaceRecord, surfaceRecordCheck } from './generated/surface.ts';
import { type ClockRecord, clockRecordCheck } from './generated/time.ts';
import { isObject } from './jsonRpc.ts';

export type { AnnotationRecord, BookmarkRecord, ClockRecord, RakeRecord, SurfaceRecord };
export type {
    Dataset as DatasetDescription,
    DatasetEntry,
    DatasetState,
    Field as FieldDescription,
    StepHeld,
    StepState,
} from './generated/dataset.ts';
export { datasetStates } from './generated/dataset.ts';
export type { Camera as CameraPlace, Participant, PresenceUpdateParams as Presence } from './generated/presence.ts';
export type { RakeKind } from './generated/rake.ts';
export type { Snapshot as SessionSnapshot } from './generated/session.ts';
export type { Lattice as LatticeDescription, Role } from './generated/shared.ts';
export type { Accuracy, Direction, Interpolation, Refine, SurfaceKind } from './generated/surface.ts';
export { isVec3, type Vec3 } from './vec3.ts';

/** Why something failed, as records and notifications carry it. */
export interface ReportedError {
    message: string;
    hint?: string;
    /** A word for programs. */
    kind?: string;
}

export function isRakeRecord(value: unknown): value is RakeRecord {
    return is(value, rakeRecordCheck);
}

export function isSurfaceRecord(value: unknown): value is SurfaceRecord {
    return is(value, surfaceRecordCheck);
}

/** Checks of records, by the type that patches name. */
export const recordChecks = {
    rake: rakeRecordCheck,
    surface: surfaceRecordCheck,
    bookmark: bookmarkRecordCheck,
    annotation: annotationRecordCheck,
    clock: clockRecordCheck,
    session: sessionNameCheck,
} as const;

/** Why something failed, as an object of that shape; null if it is none. */
export function readError(error: unknown): ReportedError | null {
    if (!isObject(error) || typeof error['message'] !== 'string') return null;
    const { message, hint, kind } = error;
    return {
        message,
        ...(typeof hint === 'string' && hint !== '' ? { hint } : {}),
        ...(typeof kind === 'string' ? { kind } : {}),
    };
}

/** Returns what went wrong and what to do, as one text. */
export function errorWords({ message, hint }: ReportedError): string {
    return hint === undefined || hint === '' ? message : `${message}: ${hint}`;
}
