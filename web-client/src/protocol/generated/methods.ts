// Made by protocol/api/generate from *.schema.json: do not edit.
import type * as annotation from './annotation.ts';
import type * as bookmark from './bookmark.ts';
import type * as dataset from './dataset.ts';
import type * as family from './family.ts';
import type * as history from './history.ts';
import type * as presence from './presence.ts';
import type * as rake from './rake.ts';
import type * as server from './server.ts';
import type * as session from './session.ts';
import type * as share from './share.ts';
import type * as shared from './shared.ts';
import type * as subscription from './subscription.ts';
import type * as surface from './surface.ts';
import type * as time from './time.ts';

/** Every method of the server. */
export interface Methods {
    /**
     * Returns this description as an OpenRPC document: every method with its parameters. The example shows only a part
     * of the document.
     */
    'rpc.discover': { params: Record<string, never>; result: server.RpcDiscoverResult };
    /** Reports what this server is, what it offers, and what its limits are. */
    'server.info': { params: Record<string, never>; result: server.ServerInfoResult };
    /** Returns at once. Clients use it as their heartbeat. */
    'server.ping': { params: Record<string, never>; result: object };
    /**
     * Reports how long each stage from an edit to the socket took in the last minute, and how the server is doing.
     * With a share link it returns only participants, surfaces, stages and firstFrame, where participants and surfaces
     * are those of the link's session.
     */
    'server.stats': { params: Record<string, never>; result: server.ServerStatsResult };
    /**
     * A notification. The open call of this WebSocket with this id fails at once with the error -32800, and its work
     * stops. What an edit has changed stays changed.
     */
    '$/cancelRequest': { params: server.CancelRequestParams; result: object };
    /** Lists the datasets that this server serves. */
    'dataset.list': { params: Record<string, never>; result: dataset.DatasetListResult };
    /**
     * Returns the grid, times, fields and lattice of one dataset, in the shape of `wakesurf info --json`, and the
     * names that `fields` of surface.set accepts.
     */
    'dataset.describe': { params: dataset.DatasetDescribeParams; result: dataset.Dataset };
    /**
     * Returns once a dataset is imported. An import that was stopped goes on where it ended. $/cancelRequest ends the
     * waiting, and the import with it if no one else waits for it. A lost connection does not end an import. The state
     * is `importing` if `timeoutMs` ran out, and `incomplete` if the import ended before the last time-step.
     */
    'dataset.open': { params: dataset.DatasetOpenParams; result: dataset.DatasetEntry };
    /**
     * Returns a rake and the parameters of a surface of each kind to begin with, found in the data: the rake stands
     * ahead of a body that the flow meets, else where the flow turns, else where it enters. All surfaces are shown at
     * the same time. Reads one or two time-steps.
     */
    'dataset.suggest': { params: dataset.DatasetSuggestParams; result: dataset.DatasetSuggestResult };
    /** Reports which time-steps of a dataset are in memory. */
    'cache.status': { params: dataset.CacheStatusParams; result: dataset.CacheStatus };
    /** Returns the values of fields at points and one time, interpolated as at the vertices of surfaces. */
    'probe.sample': { params: dataset.ProbeSampleParams; result: dataset.ProbeSampleResult };
    /**
     * Carries a scalar along the streamlines of one time-step to all nodes of a dataset, and keeps it there as a
     * scalar field: surfaces are coloured by it, files and probes have it. Answers once it is kept. $/cancelRequest,
     * or a lost connection, ends the work, and nothing is kept.
     */
    'family.make': { params: family.FamilyMakeParams; result: family.Family };
    /** Removes a family, and its files. Surfaces that show it are shown without it. */
    'family.remove': { params: family.FamilyRemoveParams; result: object };
    /**
     * Makes a new, empty session. When there are too many sessions, one without a name that no one has edited or
     * shared and no one is in is removed; no other session ever is.
     */
    'session.create': { params: session.SessionCreateParams; result: session.SessionMade };
    /**
     * Makes a new session with the records of another and the time it shows, but without its people, links and
     * history. With a share link, of any role, it copies the link's session only, and `key` lets you into the copy as
     * an editor, for as long as your link is valid.
     */
    'session.fork': { params: session.SessionForkParams; result: session.SessionForkResult };
    /** Lists the sessions of this server. With a share link, only the session of the link is listed. */
    'session.list': { params: session.SessionListParams; result: session.SessionListResult };
    /** Enters a session. From now on its changes are sent to this WebSocket. */
    'session.join': { params: session.SessionJoinParams; result: session.Joined };
    /** Leaves the session. Its changes are no longer sent. */
    'session.leave': { params: Record<string, never>; result: object };
    /** Returns all records of a session. */
    'session.state': { params: session.SessionStateParams; result: session.SessionStateResult };
    /** Renames a session. Everyone in it is notified. */
    'session.rename': { params: session.SessionRenameParams; result: session.SessionName };
    /**
     * Sets the units in which lengths and times are read. They only name what the numbers of the data mean: no number
     * changes. Everyone in the session is notified.
     */
    'session.setUnits': { params: session.SessionSetUnitsParams; result: session.SessionName };
    /**
     * Moves a session to the trash, from which session.restore can bring it back for 30 days. The people in it are
     * notified, and meanwhile its share links let no one in. `main` cannot be deleted. Who copied a session by a share
     * link may delete the copy as long as no one has edited, named or shared it and no one else is in it; it is gone
     * for good then.
     */
    'session.delete': { params: session.SessionDeleteParams; result: session.SessionDeleteResult };
    /** Brings a session back from the trash as it was, with its share links. */
    'session.restore': { params: session.SessionRestoreParams; result: session.SessionName };
    /**
     * Returns a session as one document: its records, and the names and fingerprints of their datasets. A large
     * session is refused here; GET /api/v1/sessions/SESSION/session.json returns sessions of any size.
     */
    'session.export': { params: session.SessionExportParams; result: session.SessionExportResult };
    /**
     * Makes a new session from a document of session.export. POST /api/v1/sessions takes documents that are too large
     * for a message.
     */
    'session.import': { params: session.SessionImportParams; result: session.SessionImportResult };
    /**
     * Stores a small picture of the session for lists; it replaces the one before. GET
     * /api/v1/sessions/SESSION/thumbnail returns it.
     */
    'session.thumbnail': { params: session.SessionThumbnailParams; result: object };
    /**
     * Makes a link that lets people into this session, in a role, until it expires or is revoked. The key is returned
     * only this once; it works wherever the token does.
     */
    'session.share': { params: share.SessionShareParams; result: share.SessionShareResult };
    /** Lists the valid links into this session, without their keys. */
    'session.shares': { params: share.SessionSharesParams; result: share.SessionSharesResult };
    /**
     * Revokes a link. Everyone who came by it is disconnected. Links that were made through it stay valid, unless
     * `children` is true.
     */
    'session.unshare': { params: share.SessionUnshareParams; result: share.SessionUnshareResult };
    /**
     * Sets what a participant may do here, from their next message on. A role below that of the link they came by also
     * applies to their other places, to calls without a place, and to everyone else who comes by that link from now
     * on.
     */
    'session.setRole': { params: share.SessionSetRoleParams; result: share.SessionSetRoleResult };
    /**
     * Disconnects a participant, who loses their place. The link they came by stays valid; revoke it as well to keep
     * them out.
     */
    'session.kick': { params: share.SessionKickParams; result: object };
    /**
     * Shows the others what the caller points at, looks at, drags and has selected. What is left out stays as it is;
     * null removes it. Best sent as a notification.
     */
    'presence.update': { params: presence.PresenceUpdateParams; result: object };
    /**
     * Creates a rake, or replaces one as a whole. The surfaces of the rake are rebuilt at once, unless only its name
     * or colour changes.
     */
    'rake.set': { params: rake.RakeSetParams; result: rake.RakeSetResult };
    /** Deletes a rake and its surfaces. */
    'rake.delete': { params: rake.RakeDeleteParams; result: shared.AfterEdit };
    /** Lists the rakes of a session. */
    'rake.list': { params: rake.RakeListParams; result: rake.RakeListResult };
    /** Creates a surface, or replaces its record as a whole, and starts to build it. */
    'surface.set': { params: surface.SurfaceSetParams; result: surface.SurfaceSetResult };
    /** Deletes a surface. */
    'surface.delete': { params: surface.SurfaceDeleteParams; result: shared.AfterEdit };
    /**
     * Stops the computation of a surface, for everyone, within 50 ms. What has been computed stays; the surface's
     * statistics and surface.done say who stopped it. The next edit of the surface or of its rake computes it again.
     */
    'surface.stop': { params: surface.SurfaceStopParams; result: surface.SurfaceStopResult };
    /** Lists the surfaces of a session. */
    'surface.list': { params: surface.SurfaceListParams; result: surface.SurfaceListResult };
    /** Returns statistics of the newest state of a surface. */
    'surface.stats': { params: subscription.SurfaceStatsParams; result: subscription.Statistics };
    /** Returns once the surface is complete; `complete` is false if the time ran out. */
    'surface.wait': { params: subscription.SurfaceWaitParams; result: subscription.Statistics };
    /** Sends the mesh of a surface as binary frames, now and after every change. It cannot be part of a batch. */
    'surface.subscribe': { params: subscription.SurfaceSubscribeParams; result: subscription.SurfaceSubscribeResult };
    /**
     * Ends a subscription. A surface that someone had subscribed to, and that no one shows or waits for two seconds
     * later, is not computed any further: until someone subscribes to it or waits for it.
     */
    'surface.unsubscribe': { params: subscription.SurfaceUnsubscribeParams; result: object };
    /**
     * Reports the last update of a subscription that the client has applied. The server then sends at most eight
     * updates beyond the reported one. Best sent as a notification.
     */
    'frame.ack': { params: subscription.FrameAckParams; result: object };
    /** Creates a bookmark, or replaces one as a whole. */
    'bookmark.set': { params: bookmark.BookmarkSetParams; result: bookmark.BookmarkSetResult };
    /** Deletes a bookmark. */
    'bookmark.delete': { params: bookmark.BookmarkDeleteParams; result: shared.AfterEdit };
    /** Lists the bookmarks of a session. */
    'bookmark.list': { params: bookmark.BookmarkListParams; result: bookmark.BookmarkListResult };
    /** Creates an annotation, or replaces one as a whole. It keeps the name of the one who made it. */
    'annotation.set': { params: annotation.AnnotationSetParams; result: annotation.AnnotationSetResult };
    /** Deletes an annotation. */
    'annotation.delete': { params: annotation.AnnotationDeleteParams; result: shared.AfterEdit };
    /** Lists the annotations of a session. */
    'annotation.list': { params: annotation.AnnotationListParams; result: annotation.AnnotationListResult };
    /**
     * Takes back the caller's newest edit, or a whole gesture (or drag) at once. It never undoes the work of others:
     * an edit is skipped if someone else has changed its records since.
     */
    'history.undo': { params: history.HistoryUndoParams; result: history.HistoryUndoResult };
    /** Repeats the caller's newest edit that was taken back. */
    'history.redo': { params: history.HistoryRedoParams; result: history.HistoryRedoResult };
    /**
     * Jumps to a time of the data. Path, streak and time surfaces are shown as they are at this time, within their own
     * `from` and `to`. A time that neither the data of the session's surfaces nor a surface has is refused; any will
     * do where a surface is of a flow that is steady or a formula.
     */
    'time.set': { params: time.TimeSetParams; result: time.ClockAnswer };
    /**
     * Starts the clock, from where it stands or from the beginning. `from` and `to` are times of the data, as in
     * `time.set`.
     */
    'time.play': { params: time.TimePlayParams; result: time.ClockAnswer };
    /** Stops the clock where it is. */
    'time.pause': { params: time.TimePauseParams; result: time.ClockAnswer };
}
