// Made by protocol/api/generate from subscription.schema.json: do not edit.
import { flag, list, members, number, oneOf, optional, text, whole } from '../checks.ts';
import { type InSession, type Lattice, type Problem, problemCheck } from './shared.ts';
import { type SurfaceKind, surfaceKindCheck } from './surface.ts';

/** How long the pass that made the newest state took. */
export interface PassSeconds {
    /** from the edit, or the state before, until the pass began (s) */
    queue: number;
    /** waiting for time-steps of the velocity (s) */
    load: number;
    /** everything else in building the surface (s) */
    compute: number;
    /** encoding frames (s) */
    encode: number;
}

export const passSecondsCheck = members<PassSeconds>({ queue: number, load: number, compute: number, encode: number });

/** Numbers of particles, by what ended them. */
export interface Terminations {
    /** particles that left the domain */
    domain: number;
    /** particles that reached the end of the requested time */
    time: number;
    /** particles that reached an obstacle */
    obstacle: number;
    /** particles that came to rest */
    stagnation: number;
    /** particles that used up the steps allowed */
    budget: number;
}

export const terminationsCheck = members<Terminations>({
    domain: whole,
    time: whole,
    obstacle: whole,
    stagnation: whole,
    budget: whole,
});

/** How long it took to build a surface. */
export interface BuildSeconds {
    /** waiting for time-steps (s) */
    load: number;
    /** moving particles (s) */
    advect: number;
    /** inserting and removing vertices (s) */
    refine: number;
    /** everything else (s) */
    other: number;
    /** the whole build (s) */
    total: number;
    /** of all processors together, for the whole build; only in `wakesurf surface --stats` (s) */
    processor?: number;
}

export const buildSecondsCheck = members<BuildSeconds>({
    load: number,
    advect: number,
    refine: number,
    other: number,
    total: number,
    processor: optional(number),
});

/**
 * why a surface shows nothing. inBody, outsideCells: the rake is there; atRest: the fluid does not move at the rake;
 * notFinite: the velocities there, or a level surface's values, are no numbers; sameRakes: both rakes of a time
 * surface are the same; noArea: the rake lies along the flow; nothingYet: before the first release; allLeft: all
 * particles have left or reached the body; tooCoarse: no quad is left at this separation; outsideRange: no such value
 */
export const emptyReasons = [
    'inBody',
    'outsideCells',
    'atRest',
    'notFinite',
    'sameRakes',
    'noArea',
    'nothingYet',
    'allLeft',
    'tooCoarse',
    'outsideRange',
] as const;
export type EmptyReason = (typeof emptyReasons)[number];
export const emptyReasonCheck = oneOf(emptyReasons);

/** Why there is nothing to see of a surface. */
export interface Emptiness {
    /**
     * why a surface shows nothing. inBody, outsideCells: the rake is there; atRest: the fluid does not move at the
     * rake; notFinite: the velocities there, or a level surface's values, are no numbers; sameRakes: both rakes of a
     * time surface are the same; noArea: the rake lies along the flow; nothingYet: before the first release; allLeft:
     * all particles have left or reached the body; tooCoarse: no quad is left at this separation; outsideRange: no
     * such value
     */
    reason: EmptyReason;
    /** the reason, for people */
    message: string;
    /** what to do about it */
    hint: string;
}

export const emptinessCheck = members<Emptiness>({ reason: emptyReasonCheck, message: text, hint: text });

/** Statistics of the newest state of a surface, in the shape of `wakesurf surface --stats`. */
export interface Statistics {
    /** id of the surface */
    surface: string;
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
    /** true: this is the final surface of its epoch */
    complete: boolean;
    /**
     * stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak:
     * particles released continuously from `from` on; time: a patch of particles released at `from`; level: where
     * `field` has the value `level`, at the time that is shown between `from` and `to`
     */
    kind: SurfaceKind;
    /** number of quads */
    quads: number;
    /** number of vertices */
    vertices: number;
    /** number of steps of the surface, in time or along its curves */
    steps: number;
    /** number of steps of the integrator, for all particles together */
    vertexSteps: number;
    /** number of vertices that were interpolated, not traced from the rake */
    approximated: number;
    /**
     * 99 % of the vertices that are not `uncertain` are estimated to be no farther than this from the surface as it
     * truly is, across it: what has slid along the surface does not count; left out where there is no surface to see
     * (the dataset's unit of length)
     */
    error99?: number;
    /**
     * number of vertices that may be farther than the separation from the surface as it truly is: they have passed
     * close by a stagnation line, or the flow has stretched what was interpolated; left out where there is no surface
     * to see
     */
    uncertain?: number;
    /**
     * numbers of particles from the rake's seeds, by what ended them; of streak and time surfaces those of all rows
     * released until then. Particles inserted on the way between others are not counted
     */
    terminated: Terminations;
    /**
     * number of cells that have been deleted amid living particles, which went apart or came together so much that no
     * cells between them can follow: small holes, for instance where a mesh is folded; streak and time surfaces only
     */
    torn?: number;
    /** length of the longest edge (the dataset's unit of length) */
    maxEdge: number;
    /** longest edge allowed in the end (the dataset's unit of length) */
    separation: number;
    /** longest edge that was asked for (the dataset's unit of length) */
    requestedSeparation: number;
    /**
     * true: within `maxQuads` the separation asked for is not possible, so `separation` is larger; false until the
     * surface is complete
     */
    coarsened: boolean;
    /** how long it took to build the surface */
    seconds: BuildSeconds;
    /** how long it took to make this state */
    pass?: PassSeconds;
    /** the most memory that the process has held, for everything that it does (bytes) */
    peakBytes: number;
    /**
     * first time of the data, where it cuts the backward side of a path surface of both directions short (the
     * dataset's unit of time)
     */
    dataEnd?: number;
    /** of a level surface: what its field ranges over at the time that is shown */
    fieldRange?: [number, number];
    /** why the surface ends early */
    stopped?: string;
    /** why there is nothing to see; left out where there is something */
    empty?: Emptiness;
    /** checksum of what clients show, as in the frames (protocol/wire/FORMAT.md, State sum) */
    stateSum: number;
    /** why the surface is not complete */
    error?: Problem;
}

export const statisticsCheck = members<Statistics>({
    surface: text,
    epoch: whole,
    complete: flag,
    kind: surfaceKindCheck,
    quads: whole,
    vertices: whole,
    steps: whole,
    vertexSteps: whole,
    approximated: whole,
    error99: optional(number),
    uncertain: optional(whole),
    terminated: terminationsCheck,
    torn: optional(whole),
    maxEdge: number,
    separation: number,
    requestedSeparation: number,
    coarsened: flag,
    seconds: buildSecondsCheck,
    pass: optional(passSecondsCheck),
    peakBytes: whole,
    dataEnd: optional(number),
    fieldRange: optional(list(number, 2)),
    stopped: optional(text),
    empty: optional(emptinessCheck),
    stateSum: whole,
    error: optional(problemCheck),
});

/** What the values of an attribute range over, for colours. */
export interface ValueRange {
    /** name of the attribute, as in the frames; `t` stands for the age: of a streak surface the time since the release */
    attribute: string;
    /**
     * lower end, without the last per cent of the surface's area where there are values below zero and it would take
     * more than a fifth of the range
     */
    low: number;
    /** upper end, without the last per cent of the surface's area where it would take more than a fifth of the range */
    high: number;
    /** the least of all values */
    least: number;
    /** the greatest of all values */
    greatest: number;
}

export const valueRangeCheck = members<ValueRange>({
    attribute: text,
    low: number,
    high: number,
    least: number,
    greatest: number,
});

/** coarse, refined, final: the quality of the pass; live: a moving surface that plays */
export const surfacePhases = ['coarse', 'refined', 'final', 'live'] as const;
export type SurfacePhase = (typeof surfacePhases)[number];
export const surfacePhaseCheck = oneOf(surfacePhases);

/** Parameters of surface.stats. */
export interface SurfaceStatsParams extends InSession {
    /** an id from surface.list */
    surface: string;
}

/** Parameters of surface.wait. */
export interface SurfaceWaitParams extends InSession {
    /** an id from surface.list */
    surface: string;
    /** epoch to wait for: this one or a later one; if left out, the current one */
    epoch?: number;
    /** how long to wait, at most (ms) */
    timeoutMs: number;
    /** on a WebSocket: $/progress reports the progress of the work with this token */
    workDoneToken?: string | number;
}

/** Parameters of surface.subscribe. */
export interface SurfaceSubscribeParams extends InSession {
    /** an id from surface.list */
    surface: string;
    /** the last update that was applied before a connection was lost; the server goes on after it if possible */
    from?: { epoch: number; seq: number };
}

/** What surface.subscribe answers. */
export interface SurfaceSubscribeResult {
    /** number of the subscription, as in the frames' headers */
    subscription: number;
    /** lattice of the frames */
    lattice: Lattice;
    /** names of the vertices' attributes, in the frames' order */
    attributes: string[];
    /** counts the surfaces that have been built for the record; it never decreases */
    epoch: number;
    /** true: the updates after `from` follow, and no keyframe */
    resumed: boolean;
    /**
     * what the values range over, of all states since the surface began to play: moving the clock, or the time at
     * which the field of a stream surface is frozen, only widens them; another edit of the surface or its rake begins
     * them anew
     */
    ranges?: ValueRange[];
}

/** Parameters of surface.unsubscribe. */
export interface SurfaceUnsubscribeParams extends InSession {
    /** number of the subscription; or give `surface` instead */
    subscription?: number;
    /** id of the surface, instead of the number */
    surface?: string;
}

/** Parameters of frame.ack. */
export interface FrameAckParams {
    /** number of the subscription */
    subscription: number;
    /** epoch of the update; if left out, the surface's current one */
    epoch?: number;
    /** number of the update in its epoch */
    seq: number;
}
