// Made by protocol/api/generate from limits.schema.json: do not edit.
import { wholeMembers } from '../checks.ts';

/** What one server of this version grants, as far as server.info returns it. */
export const toldLimits = {
    /** size of one message (bytes) */
    messageBytes: 65_536,
    /** calls in one message */
    batch: 64,
    /** levels of nesting in a message */
    depth: 32,
    /** WebSockets of all people together */
    clients: 2_048,
    /** calls of one person in a second; bursts may have twice as many */
    callsPerSecond: 2_000,
    /** edits of one person in a second; bursts may have twice as many */
    editsPerSecond: 200,
    /** sessions that the server keeps */
    sessions: 1_024,
    /** deleted sessions that can be restored */
    trash: 256,
    /** size of a session's picture (bytes) */
    thumbnailBytes: 24_576,
    /** participants in a session at a time */
    participants: 1_536,
    /** rakes in a session */
    rakes: 256,
    /** points of a rake */
    rakePoints: 1_024,
    /** seeds of a rake */
    seeds: 4_096,
    /** surfaces in a session */
    surfaces: 64,
    /** bookmarks in a session */
    bookmarks: 256,
    /** annotations in a session */
    annotations: 512,
    /** size of all records of a session; as text, when someone joins, they take three times as much (bytes) */
    sessionBytes: 1_048_576,
    /** edits of one participant that can be taken back */
    undo: 100,
    /** valid share links of a session */
    shareLinks: 32,
    /** subscriptions of one WebSocket */
    subscriptions: 1_024,
    /** unanswered surface.wait calls of one surface */
    waiters: 64,
    /** unanswered calls of one WebSocket */
    pendingCalls: 256,
    /** unanswered probe.sample calls of one person */
    probes: 4,
    /** WebSockets of one person */
    sockets: 64,
    /** unfinished downloads of one person */
    downloads: 8,
    /** quads of a surface */
    quads: 4_000_000,
    /** additional attributes of a surface's vertices */
    fields: 5,
    /** time that a call may wait (ms) */
    waitMs: 600_000,
} as const;

/** What one server of this version grants. */
export const limits = {
    ...toldLimits,
    /** length of a name (bytes) */
    nameBytes: 120,
    /** length of the name of a unit (bytes) */
    unitBytes: 32,
    /** length of a gesture's name (bytes) */
    gestureBytes: 64,
    /** length of a bookmark's view, as JSON text (bytes) */
    viewBytes: 4_096,
    /** length of an annotation's text (bytes) */
    annotationBytes: 4_096,
    /** points of a rake while it is dragged */
    presencePoints: 64,
    /** points in one call of probe.sample */
    probePoints: 4_096,
    /** fields in one call of probe.sample */
    probeFields: 64,
    /** fewest seeds of a rake */
    seedsLeast: 2,
    /** quads of a surface, if `maxQuads` is left out */
    quadsDefault: 1_000_000,
    /** lifetime of a share link that expires (s) */
    grantSeconds: 316_224_000,
    /** lifetime of a share link, if `expiresIn` is left out (s) */
    grantSecondsDefault: 604_800,
    /** speed of a clock, in simulation time a second */
    clockSpeed: 1_000_000,
    /** duration of a rake's lease (ms) */
    leaseMs: 5_000,
    /** days for which a deleted session can be restored (days) */
    trashDays: 30,
} as const;

/** The limits that server.info returns. */
export type Limits = { -readonly [Name in keyof typeof toldLimits]: number };

export const limitsCheck = wholeMembers(toldLimits);
