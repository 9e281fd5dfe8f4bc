// Made by protocol/api/generate from *.schema.json: do not edit.
import type { CancelRequestParams, RpcDiscoverResult, ServerInfoResult, ServerStatsResult } from './server.ts';
import type {
    CacheStatus,
    CacheStatusParams,
    Dataset,
    DatasetDescribeParams,
    DatasetEntry,
    DatasetListResult,
    DatasetOpenParams,
    ProbeSampleParams,
    ProbeSampleResult,
} from './dataset.ts';
import type {
    Joined,
    SessionCreateParams,
    SessionDeleteParams,
    SessionDeleteResult,
    SessionExportParams,
    SessionExportResult,
    SessionForkParams,
    SessionImportParams,
    SessionImportResult,
    SessionJoinParams,
    SessionListParams,
    SessionListResult,
    SessionMade,
    SessionName,
    SessionRenameParams,
    SessionRestoreParams,
    SessionStateParams,
    SessionStateResult,
    SessionThumbnailParams,
} from './session.ts';
import type {
    SessionKickParams,
    SessionSetRoleParams,
    SessionSetRoleResult,
    SessionShareParams,
    SessionShareResult,
    SessionSharesParams,
    SessionSharesResult,
    SessionUnshareParams,
    SessionUnshareResult,
} from './share.ts';
import type { PresenceUpdateParams } from './presence.ts';
import type { RakeDeleteParams, RakeListParams, RakeListResult, RakeSetParams, RakeSetResult } from './rake.ts';
import type { AfterEdit } from './shared.ts';
import type {
    SurfaceDeleteParams,
    SurfaceListParams,
    SurfaceListResult,
    SurfaceSetParams,
    SurfaceSetResult,
    SurfaceStopParams,
    SurfaceStopResult,
} from './surface.ts';
import type {
    FrameAckParams,
    Statistics,
    SurfaceStatsParams,
    SurfaceSubscribeParams,
    SurfaceSubscribeResult,
    SurfaceUnsubscribeParams,
    SurfaceWaitParams,
} from './subscription.ts';
import type {
    BookmarkDeleteParams,
    BookmarkListParams,
    BookmarkListResult,
    BookmarkSetParams,
    BookmarkSetResult,
} from './bookmark.ts';
import type {
    AnnotationDeleteParams,
    AnnotationListParams,
    AnnotationListResult,
    AnnotationSetParams,
    AnnotationSetResult,
} from './annotation.ts';
import type { HistoryRedoParams, HistoryRedoResult, HistoryUndoParams, HistoryUndoResult } from './history.ts';
import type { ClockAnswer, TimePauseParams, TimePlayParams, TimeSetParams } from './time.ts';

/** Every method of the server. */
export interface Methods {
    /** This description as an OpenRPC document: every method with its parameters. */
    'rpc.discover': { params: Record<string, never>; result: RpcDiscoverResult };
    /** What this server is, what it offers, and what it grants. */
    'server.info': { params: Record<string, never>; result: ServerInfoResult };
    /** Answers at once: a client's heartbeat. */
    'server.ping': { params: Record<string, never>; result: object };
    /**
     * How long each stage from an edit to the socket took in the last minute, and how the server stands; with a share
     * link only how its session does: participants, surfaces, stages and firstFrame.
     */
    'server.stats': { params: Record<string, never>; result: ServerStatsResult };
    /**
     * A notification: answers an open call of this WebSocket with -32800 at once and stops its work. What an edit has
     * changed stays changed.
     */
    '$/cancelRequest': { params: CancelRequestParams; result: object };
    /** The datasets this server serves. */
    'dataset.list': { params: Record<string, never>; result: DatasetListResult };
    /**
     * Grid, times, fields and lattice of one dataset, in the shape of `wakesurf info --json`, and what `fields` of
     * surface.set may name.
     */
    'dataset.describe': { params: DatasetDescribeParams; result: Dataset };
    /**
     * Answers once a dataset is imported; an import that was stopped goes on where it ended. $/cancelRequest ends the
     * waiting, and the import with it when no one else waits; a connection that is lost ends no import. The state is
     * importing when timeoutMs ran out, and incomplete where the import ended before the last time-step.
     */
    'dataset.open': { params: DatasetOpenParams; result: DatasetEntry };
    /** Which time-steps of a dataset are in memory. */
    'cache.status': { params: CacheStatusParams; result: CacheStatus };
    /** Fields at points and one time, interpolated as the surfaces' vertices are. */
    'probe.sample': { params: ProbeSampleParams; result: ProbeSampleResult };
    /**
     * Makes a new, empty session. One without a name that no one edits, shares or is in goes again when there are too
     * many; no other does.
     */
    'session.create': { params: SessionCreateParams; result: SessionMade };
    /** Makes a new session with the records of another, but none of its people, links and history. Not for share links. */
    'session.fork': { params: SessionForkParams; result: SessionMade };
    /** The sessions of this server; with a share link, its own. */
    'session.list': { params: SessionListParams; result: SessionListResult };
    /** Enters a session: its changes are told to this WebSocket from now on. */
    'session.join': { params: SessionJoinParams; result: Joined };
    /** Leaves the session joined; its changes are not told any more. */
    'session.leave': { params: Record<string, never>; result: object };
    /** Every record of a session. */
    'session.state': { params: SessionStateParams; result: SessionStateResult };
    /** Gives a session another name; everyone in it is told. */
    'session.rename': { params: SessionRenameParams; result: SessionName };
    /**
     * Moves a session to the trash, from where session.restore brings it back for 30 days; its people are told, its
     * share links let no one in meanwhile. `main` cannot be deleted.
     */
    'session.delete': { params: SessionDeleteParams; result: SessionDeleteResult };
    /** Brings a session back from the trash as it was, with its share links. */
    'session.restore': { params: SessionRestoreParams; result: SessionName };
    /**
     * A session as one document: its records, and the names and fingerprints of their datasets. A large one is refused
     * here: GET /api/v1/sessions/SESSION/session.json answers with any.
     */
    'session.export': { params: SessionExportParams; result: SessionExportResult };
    /** Makes a new session of such a document. POST /api/v1/sessions takes larger documents than a message may be. */
    'session.import': { params: SessionImportParams; result: SessionImportResult };
    /**
     * Keeps a small picture of the session for lists: the newest one sent. GET /api/v1/sessions/SESSION/thumbnail
     * answers with it.
     */
    'session.thumbnail': { params: SessionThumbnailParams; result: object };
    /**
     * Makes a link that lets people into this session, in a role, until it expires or is taken back. The key is told
     * this once; it works wherever the token does.
     */
    'session.share': { params: SessionShareParams; result: SessionShareResult };
    /** The links into this session that are in force, without their keys. */
    'session.shares': { params: SessionSharesParams; result: SessionSharesResult };
    /**
     * Takes a link back; all who came by it are disconnected. Links that were made by it stay, unless `children` says
     * otherwise.
     */
    'session.unshare': { params: SessionUnshareParams; result: SessionUnshareResult };
    /**
     * Sets what a participant may do here, from its next message on. A lesser role than that of the link they came by
     * also holds for their other places, for calls without a place, and for all others who come by that link from now
     * on.
     */
    'session.setRole': { params: SessionSetRoleParams; result: SessionSetRoleResult };
    /** Disconnects a participant, whose place is lost. A link it came by stays good: take that back as well. */
    'session.kick': { params: SessionKickParams; result: object };
    /**
     * Tells the others what one points at, looks at, drags and has selected. What is left out stays; null takes it
     * away. Best sent as a notification.
     */
    'presence.update': { params: PresenceUpdateParams; result: object };
    /**
     * Creates a rake, or replaces one as a whole; the surfaces that hang on it are rebuilt at once, unless only its
     * name or colour changes.
     */
    'rake.set': { params: RakeSetParams; result: RakeSetResult };
    /** Deletes a rake and the surfaces that hang on it. */
    'rake.delete': { params: RakeDeleteParams; result: AfterEdit };
    /** The rakes of a session. */
    'rake.list': { params: RakeListParams; result: RakeListResult };
    /** Creates a surface, or replaces its record as a whole, and starts building it. */
    'surface.set': { params: SurfaceSetParams; result: SurfaceSetResult };
    /** Deletes a surface. */
    'surface.delete': { params: SurfaceDeleteParams; result: AfterEdit };
    /**
     * Stops computing a surface, for everyone, within 50 ms. What is there of it stays, and its statistics and
     * surface.done say who stopped it; the next edit of it or its rake computes it again.
     */
    'surface.stop': { params: SurfaceStopParams; result: SurfaceStopResult };
    /** The surfaces of a session. */
    'surface.list': { params: SurfaceListParams; result: SurfaceListResult };
    /** What the newest state of a surface is and took. */
    'surface.stats': { params: SurfaceStatsParams; result: Statistics };
    /** Answers once the surface is complete; `complete` is false when the time ran out. */
    'surface.wait': { params: SurfaceWaitParams; result: Statistics };
    /** Sends the mesh of a surface, now and after every change, as binary frames. Cannot be part of a batch. */
    'surface.subscribe': { params: SurfaceSubscribeParams; result: SurfaceSubscribeResult };
    /** Ends a subscription. */
    'surface.unsubscribe': { params: SurfaceUnsubscribeParams; result: object };
    /**
     * Says up to which update a subscription's frames have been folded. A client that does so is sent at most eight
     * updates more than that; meant as a notification.
     */
    'frame.ack': { params: FrameAckParams; result: object };
    /** Creates a bookmark, or replaces one as a whole. */
    'bookmark.set': { params: BookmarkSetParams; result: BookmarkSetResult };
    /** Deletes a bookmark. */
    'bookmark.delete': { params: BookmarkDeleteParams; result: AfterEdit };
    /** The bookmarks of a session. */
    'bookmark.list': { params: BookmarkListParams; result: BookmarkListResult };
    /** Creates an annotation, or replaces one as a whole; it keeps the name of the one who made it. */
    'annotation.set': { params: AnnotationSetParams; result: AnnotationSetResult };
    /** Deletes an annotation. */
    'annotation.delete': { params: AnnotationDeleteParams; result: AfterEdit };
    /** The annotations of a session. */
    'annotation.list': { params: AnnotationListParams; result: AnnotationListResult };
    /**
     * Takes back the caller's newest edit, a whole gesture (or drag) at once. Never undoes others' work: an edit whose
     * records someone else has changed since is skipped.
     */
    'history.undo': { params: HistoryUndoParams; result: HistoryUndoResult };
    /** Makes the caller's newest undone edit again. */
    'history.redo': { params: HistoryRedoParams; result: HistoryRedoResult };
    /** Jumps to a time: path, streak and time surfaces are shown as they are then, within their own `from` and `to`. */
    'time.set': { params: TimeSetParams; result: ClockAnswer };
    /** Lets the clock run, from where it stands or from the start. */
    'time.play': { params: TimePlayParams; result: ClockAnswer };
    /** Stops the clock where it is. */
    'time.pause': { params: TimePauseParams; result: ClockAnswer };
}
