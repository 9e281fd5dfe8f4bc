// Made by protocol/api/generate from subscription.schema.json: do not edit.
import { flag, members, number, oneOf, optional, text, whole } from '../checks.ts';
import { problemCheck, type Lattice, type Problem } from './shared.ts';
import { surfaceKindCheck, type SurfaceKind } from './surface.ts';

/** What the pass that made the newest state took. */
export interface PassSeconds {
    /** from the edit, or the state before, until it began (s) */
    queue: number;
    /** waiting for time-steps of the velocity (s) */
    load: number;
    /** all else of building (s) */
    compute: number;
    /** making frames (s) */
    encode: number;
}

export const passSecondsCheck = members<PassSeconds>({ queue: number, load: number, compute: number, encode: number });

/** Particles by what ended them. */
export interface Terminations {
    /** left the domain */
    domain: number;
    /** reached the end of the time asked for */
    time: number;
    /** came to an obstacle */
    obstacle: number;
    /** came to rest */
    stagnation: number;
    /** used up the steps allowed */
    budget: number;
}

export const terminationsCheck = members<Terminations>({
    domain: whole,
    time: whole,
    obstacle: whole,
    stagnation: whole,
    budget: whole,
});

/** What building a surface took. */
export interface BuildSeconds {
    /** waiting for time-steps (s) */
    load: number;
    /** moving particles (s) */
    advect: number;
    /** putting in vertices and taking them out (s) */
    refine: number;
    /** all else (s) */
    other: number;
    /** all of it (s) */
    total: number;
}

export const buildSecondsCheck = members<BuildSeconds>({
    load: number,
    advect: number,
    refine: number,
    other: number,
    total: number,
});

/** What the newest state of a surface is and took, in the shape of `wakesurf surface --stats`. */
export interface Statistics {
    /** its id */
    surface: string;
    /** counts the surfaces that a record has had; only grows */
    epoch: number;
    /** it is the final surface of this epoch */
    complete: boolean;
    /**
     * stream: of the field frozen at `from`; path: particles released at `from`; streak: particles released from
     * `from` on; time: a patch of particles released at `from`
     */
    kind: SurfaceKind;
    /** of the mesh */
    quads: number;
    /** of the mesh */
    vertices: number;
    /** of the surface, in time or along its curves */
    steps: number;
    /** of the integrator, all particles together */
    vertexSteps: number;
    /** vertices that were interpolated, not traced from the rake */
    approximated: number;
    /** of streak and time surfaces of all particles there have been */
    terminated: Terminations;
    /** the longest edge there is (the dataset's unit of length) */
    maxEdge: number;
    /** the longest edge asked for (the dataset's unit of length) */
    separation: number;
    /** what building it took */
    seconds: BuildSeconds;
    /** what making this state took */
    pass?: PassSeconds;
    /** the most memory that building it took (bytes) */
    peakBytes: number;
    /** why the surface ends early */
    stopped?: string;
    /** checksum of what clients show, as in the frames (protocol/wire/FORMAT.md, State sum) */
    stateSum: number;
    /** why there is none */
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
    terminated: terminationsCheck,
    maxEdge: number,
    separation: number,
    seconds: buildSecondsCheck,
    pass: optional(passSecondsCheck),
    peakBytes: whole,
    stopped: optional(text),
    stateSum: whole,
    error: optional(problemCheck),
});

/** live: of a moving surface that plays */
export const surfacePhases = ['coarse', 'refined', 'final', 'live'] as const;
export type SurfacePhase = (typeof surfacePhases)[number];
export const surfacePhaseCheck = oneOf(surfacePhases);

/** Parameters of surface.stats. */
export interface SurfaceStatsParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from surface.list */
    surface: string;
}

/** Parameters of surface.wait. */
export interface SurfaceWaitParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from surface.list */
    surface: string;
    /** this one or a later one; left out: the current */
    epoch?: number;
    /** patience (ms) */
    timeoutMs: number;
    /** on a WebSocket: $/progress with this token tells how far the work is */
    workDoneToken?: string | number;
}

/** Parameters of surface.subscribe. */
export interface SurfaceSubscribeParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** an id from surface.list */
    surface: string;
    /** the newest update folded before a lost connection: go on after it if possible */
    from?: { epoch: number; seq: number };
}

/** What surface.subscribe answers. */
export interface SurfaceSubscribeResult {
    /** the number in the frames' headers */
    subscription: number;
    /** of the frames */
    lattice: Lattice;
    /** of the vertices, in the frames' order */
    attributes: string[];
    /** counts the surfaces that a record has had; only grows */
    epoch: number;
    /** what follows `from` comes, and no keyframe */
    resumed: boolean;
}

/** Parameters of surface.unsubscribe. */
export interface SurfaceUnsubscribeParams {
    /** an id from session.list; may be left out on a WebSocket that has joined one, and with a share link */
    session?: string;
    /** the number, or name the surface */
    subscription?: number;
    /** instead of the number */
    surface?: string;
}

/** Parameters of frame.ack. */
export interface FrameAckParams {
    /** the number */
    subscription: number;
    /** left out: the surface's current one */
    epoch?: number;
    /** of the update in its epoch */
    seq: number;
}
