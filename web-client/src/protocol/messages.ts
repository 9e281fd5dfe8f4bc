// The methods of the server, under the names that this client has for what they take and answer. Made from
// the description of the API: generated/methods.ts.
import type { Methods as Described } from './generated/methods.ts';
import type { Joined } from './generated/session.ts';
import type { SessionSnapshot } from './records.ts';

export type { SurfaceEpoch } from './generated/rake.ts';
export type { RakeSetParams as RakeSetting } from './generated/rake.ts';
export type { ServerInfoResult as ServerInfo } from './generated/server.ts';
export type { Share as ShareLink } from './generated/share.ts';
export type { PassSeconds, Statistics as SurfaceStats, Terminations, ValueRange } from './generated/subscription.ts';
export type { SurfaceSetParams } from './generated/surface.ts';
export type { ProbeSampleResult as SampledPoints } from './generated/dataset.ts';
export type { SurfaceSubscribeResult as Subscription } from './generated/subscription.ts';
export type {
    SessionEntry,
    SessionImportResult as SessionImported,
    SessionListResult as SessionList,
    SessionMade,
} from './generated/session.ts';
export * from './notifications.ts';
export * from './records.ts';

/** This page never sends `lastSeq`, so that a snapshot always comes. */
export type JoinedSession = Joined & { snapshot: SessionSnapshot };

export interface Methods extends Omit<Described, 'session.join'> {
    'session.join': { params: Described['session.join']['params']; result: JoinedSession };
}

export type MethodName = keyof Methods;
export type ParamsOf<M extends MethodName> = Methods[M]['params'];
export type ResultOf<M extends MethodName> = Methods[M]['result'];

/** Describes what history.undo and history.redo answer. */
export type HistoryDepth = Omit<ResultOf<'history.undo'>, 'undone'>;

/** Describes what surface.set takes from this page: a surface that says when it begins. */
export type SurfaceSetting = Methods['surface.set']['params'] & { from: number };
