// Made by protocol/api/generate from limits.schema.json: do not edit.
import { members, whole } from '../checks.ts';

/** What one server of this version grants. */
export const limits = {
    /** of one message (bytes) */
    messageBytes: 65_536,
    /** calls in one message */
    batch: 64,
    /** levels of nesting in a message */
    depth: 32,
    /** WebSockets of all people together */
    clients: 2_048,
    /** of one person; twice as many at once */
    callsPerSecond: 2_000,
    /** of one person; twice as many at once */
    editsPerSecond: 200,
    /** that the server keeps */
    sessions: 1_024,
    /** deleted sessions that can be restored */
    trash: 256,
    /** of a session's picture (bytes) */
    thumbnailBytes: 24_576,
    /** in a session at a time */
    participants: 1_536,
    /** in a session */
    rakes: 256,
    /** of a rake */
    rakePoints: 1_024,
    /** of a rake */
    seeds: 4_096,
    /** in a session */
    surfaces: 64,
    /** in a session */
    bookmarks: 256,
    /** in a session */
    annotations: 512,
    /** of all records of a session; as text, when someone joins, three times as much (bytes) */
    sessionBytes: 1_048_576,
    /** edits of one participant that can be taken back */
    undo: 100,
    /** of a session */
    shareLinks: 32,
    /** of one WebSocket */
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
    /** of a surface */
    quads: 4_000_000,
    /** of a surface: further attributes of its vertices */
    fields: 4,
    /** that a call may wait (ms) */
    waitMs: 600_000,
    /** of a name (bytes) */
    nameBytes: 120,
    /** of a gesture's name (bytes) */
    gestureBytes: 64,
    /** of a bookmark's view, as JSON text (bytes) */
    viewBytes: 4_096,
    /** of an annotation's text (bytes) */
    annotationBytes: 4_096,
    /** of a rake while it is dragged */
    presencePoints: 64,
    /** of one probe.sample */
    probePoints: 4_096,
    /** of one probe.sample */
    probeFields: 64,
    /** of a rake */
    seedsLeast: 2,
    /** of a surface that does not say */
    quadsDefault: 1_000_000,
    /** of a share link that ends (s) */
    grantSeconds: 316_224_000,
    /** of a share link that does not say (s) */
    grantSecondsDefault: 604_800,
    /** of a clock, simulation time a second */
    clockSpeed: 1_000_000,
    /** of a rake's lease (ms) */
    leaseMs: 5_000,
    /** in which a deleted session can be restored (days) */
    trashDays: 30,
} as const;

/** What server.info tells. */
export interface Limits {
    /** of one message (bytes) */
    messageBytes: number;
    /** calls in one message */
    batch: number;
    /** levels of nesting in a message */
    depth: number;
    /** WebSockets of all people together */
    clients: number;
    /** of one person; twice as many at once */
    callsPerSecond: number;
    /** of one person; twice as many at once */
    editsPerSecond: number;
    /** that the server keeps */
    sessions: number;
    /** deleted sessions that can be restored */
    trash: number;
    /** of a session's picture (bytes) */
    thumbnailBytes: number;
    /** in a session at a time */
    participants: number;
    /** in a session */
    rakes: number;
    /** of a rake */
    rakePoints: number;
    /** of a rake */
    seeds: number;
    /** in a session */
    surfaces: number;
    /** in a session */
    bookmarks: number;
    /** in a session */
    annotations: number;
    /** of all records of a session; as text, when someone joins, three times as much (bytes) */
    sessionBytes: number;
    /** edits of one participant that can be taken back */
    undo: number;
    /** of a session */
    shareLinks: number;
    /** of one WebSocket */
    subscriptions: number;
    /** unanswered surface.wait calls of one surface */
    waiters: number;
    /** unanswered calls of one WebSocket */
    pendingCalls: number;
    /** unanswered probe.sample calls of one person */
    probes: number;
    /** WebSockets of one person */
    sockets: number;
    /** unfinished downloads of one person */
    downloads: number;
    /** of a surface */
    quads: number;
    /** of a surface: further attributes of its vertices */
    fields: number;
    /** that a call may wait (ms) */
    waitMs: number;
}

export const limitsCheck = members<Limits>({
    messageBytes: whole,
    batch: whole,
    depth: whole,
    clients: whole,
    callsPerSecond: whole,
    editsPerSecond: whole,
    sessions: whole,
    trash: whole,
    thumbnailBytes: whole,
    participants: whole,
    rakes: whole,
    rakePoints: whole,
    seeds: whole,
    surfaces: whole,
    bookmarks: whole,
    annotations: whole,
    sessionBytes: whole,
    undo: whole,
    shareLinks: whole,
    subscriptions: whole,
    waiters: whole,
    pendingCalls: whole,
    probes: whole,
    sockets: whole,
    downloads: whole,
    quads: whole,
    fields: whole,
    waitMs: whole,
});
