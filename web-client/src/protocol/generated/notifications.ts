// Made by protocol/api/generate from *.schema.json: do not edit.
import { type Check, list, members, number, oneOf, optional, text, token, whole } from '../checks.ts';
import * as dataset from './dataset.ts';
import * as presence from './presence.ts';
import * as session from './session.ts';
import * as shared from './shared.ts';
import * as subscription from './subscription.ts';

/**
 * Something has happened to this connection, its session or the server. Kinds: catchingUp, caughtUp (stale updates of
 * a surface are left out until a keyframe comes), notDurable, durableAgain, recordsKeptAside, carefulStart (the server
 * died several times in a row shortly after it had started, so surfaces from before are not computed by themselves),
 * dataReplaced (the values of a dataset are others now, so its surfaces are computed again), sessionDeleted,
 * displaced, removed, linkEnded, loggedOut.
 */
export interface ServerNotice {
    /** a word for programs */
    kind: string;
    /** info or warning */
    level?: string;
    /** a sentence for people */
    text?: string;
    /** for catchingUp and caughtUp: id of the surface */
    surface?: string;
    /** for catchingUp and caughtUp: number of the subscription */
    subscription?: number;
}

/**
 * Reports the progress of a call with a `workDoneToken`: begin, at most ten reports a second, and end just before the
 * call returns.
 */
export interface Progress {
    /** the token of the call */
    token: string | number;
    /** for a surface it also has phase, epoch, quads and vertices of its newest state */
    value: {
        kind: 'begin' | 'report' | 'end';
        message?: string;
        percentage?: number;
        remaining?: number;
        seconds?: number;
        time?: number;
        quadsSoFar?: number;
    };
}

/** Time-steps, or parts of them, have been read into memory or removed from it. */
export interface CachePatched {
    /** id of the dataset */
    dataset: string;
    /** the time-steps that changed, each as [index, state] */
    changes: dataset.StepChange[];
    /** the time-steps of which another part is in memory or being read, each as [index, resident, loading] */
    held: dataset.HeldChange[];
    /** memory that the time-steps take (bytes) */
    bytes: number;
    /** memory that the time-steps may take (bytes) */
    budget: number;
}

/** Records have changed. Sent to the author of the change as well. */
export interface SessionPatched {
    /** id of the session */
    session: string;
    /** `seq` of the session after the change */
    seq: number;
    /** the changes, in the order in which they can be applied */
    patches: session.Patch[];
}

/**
 * Participants have changed. About the recipient it has only a role that a host has set. Sent at most every 50 ms;
 * with many participants less often, and about some of them at a time.
 */
export interface PresencePatched {
    /** id of the session */
    session: string;
    /** the id of each participant and what has changed */
    participants: presence.ParticipantChange[];
    /** ids of participants who have left */
    left: string[];
}

/** A state of a surface is on its way to the subscribers. Not sent while the surface plays. */
export interface SurfaceProgress {
    /** id of the surface */
    surface: string;
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
    /** coarse, refined, final: the quality of the pass; live: a moving surface that plays */
    phase: subscription.SurfacePhase;
    /** how long it took to make the state */
    seconds?: subscription.PassSeconds;
}

/**
 * The values of a surface range further than before, or it has become another. Sent before the state that does so,
 * also while the surface plays.
 */
export interface SurfaceRanges {
    /** id of the surface */
    surface: string;
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
    /**
     * what the values range over, of all states since the surface began to play: moving the clock, or the time at
     * which the field of a stream surface is frozen, only widens them; another edit of the surface or its rake begins
     * them anew
     */
    ranges: subscription.ValueRange[];
}

/** A surface is complete, or cannot be completed. */
export interface SurfaceDone {
    /** id of the surface */
    surface: string;
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
    /** its statistics; present if there is no error */
    stats?: subscription.Statistics;
    /** why the surface is not complete */
    error?: shared.Problem;
}

/** Every notification of the server, by its method. */
export interface Notifications {
    /**
     * Something has happened to this connection, its session or the server. Kinds: catchingUp, caughtUp (stale updates
     * of a surface are left out until a keyframe comes), notDurable, durableAgain, recordsKeptAside, carefulStart (the
     * server died several times in a row shortly after it had started, so surfaces from before are not computed by
     * themselves), dataReplaced (the values of a dataset are others now, so its surfaces are computed again),
     * sessionDeleted, displaced, removed, linkEnded, loggedOut.
     */
    'server.notice': ServerNotice;
    /**
     * Reports the progress of a call with a `workDoneToken`: begin, at most ten reports a second, and end just before
     * the call returns.
     */
    '$/progress': Progress;
    /** A dataset is being imported, or its import has ended. Sent to all clients. */
    'dataset.patched': dataset.DatasetEntry;
    /** Time-steps, or parts of them, have been read into memory or removed from it. */
    'cache.patched': CachePatched;
    /** Records have changed. Sent to the author of the change as well. */
    'session.patched': SessionPatched;
    /**
     * Participants have changed. About the recipient it has only a role that a host has set. Sent at most every 50 ms;
     * with many participants less often, and about some of them at a time.
     */
    'presence.patched': PresencePatched;
    /** A state of a surface is on its way to the subscribers. Not sent while the surface plays. */
    'surface.progress': SurfaceProgress;
    /**
     * The values of a surface range further than before, or it has become another. Sent before the state that does so,
     * also while the surface plays.
     */
    'surface.ranges': SurfaceRanges;
    /** A surface is complete, or cannot be completed. */
    'surface.done': SurfaceDone;
}

/** What a notification must say. */
export const notificationChecks: { [Name in keyof Notifications]: Check<Notifications[Name]> } = {
    'server.notice': members<ServerNotice>({
        kind: text,
        level: optional(text),
        text: optional(text),
        surface: optional(text),
        subscription: optional(whole),
    }),
    '$/progress': members<Progress>({
        token,
        value: members({
            kind: oneOf(['begin', 'report', 'end']),
            message: optional(text),
            percentage: optional(number),
            remaining: optional(number),
            seconds: optional(number),
            time: optional(number),
            quadsSoFar: optional(whole),
        }),
    }),
    'dataset.patched': dataset.datasetEntryCheck,
    'cache.patched': members<CachePatched>({
        dataset: text,
        changes: list(dataset.stepChangeCheck),
        held: list(dataset.heldChangeCheck),
        bytes: whole,
        budget: whole,
    }),
    'session.patched': members<SessionPatched>({ session: text, seq: whole, patches: list(session.patchCheck) }),
    'presence.patched': members<PresencePatched>({
        session: text,
        participants: list(presence.participantChangeCheck),
        left: list(text),
    }),
    'surface.progress': members<SurfaceProgress>({
        surface: text,
        epoch: whole,
        phase: subscription.surfacePhaseCheck,
        seconds: optional(subscription.passSecondsCheck),
    }),
    'surface.ranges': members<SurfaceRanges>({ surface: text, epoch: whole, ranges: list(subscription.valueRangeCheck) }),
    'surface.done': members<SurfaceDone>({
        surface: text,
        epoch: whole,
        stats: optional(subscription.statisticsCheck),
        error: optional(shared.problemCheck),
    }),
};
