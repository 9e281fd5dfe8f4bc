// Made by protocol/api/generate from *.schema.json: do not edit.
import {
    type Check,
    anyObject,
    either,
    flag,
    list,
    mapOf,
    members,
    number,
    optional,
    orNull,
    point,
    text,
    whole,
} from '../checks.ts';
import * as annotation from './annotation.ts';
import * as bookmark from './bookmark.ts';
import * as dataset from './dataset.ts';
import * as family from './family.ts';
import * as history from './history.ts';
import { limitsCheck } from './limits.ts';
import type { Methods } from './methods.ts';
import * as presence from './presence.ts';
import * as rake from './rake.ts';
import * as server from './server.ts';
import * as session from './session.ts';
import * as share from './share.ts';
import * as shared from './shared.ts';
import * as subscription from './subscription.ts';
import * as surface from './surface.ts';
import * as time from './time.ts';

/** What a method must answer. */
export const resultChecks: { [Name in keyof Methods]: Check<Methods[Name]['result']> } = {
    'rpc.discover': members<server.RpcDiscoverResult>({ openrpc: text }),
    'server.info': members<server.ServerInfoResult>({
        name: text,
        version: text,
        apiLevel: whole,
        capabilities: list(text),
        limits: limitsCheck,
    }),
    'server.ping': anyObject,
    'server.stats': members<server.ServerStatsResult>({
        uptime: optional(number),
        connections: optional(whole),
        clients: optional(whole),
        sessions: optional(whole),
        participants: whole,
        surfaces: whole,
        stages: server.stagesCheck,
        firstFrame: server.quantilesCheck,
        cache: optional(list(server.cacheStandingCheck)),
        memory: optional(server.memoryStandingCheck),
        messages: optional(whole),
        frames: optional(whole),
        bytes: optional(whole),
        keyframes: optional(whole),
        dropped: optional(whole),
    }),
    '$/cancelRequest': anyObject,
    'dataset.list': members<dataset.DatasetListResult>({ datasets: list(dataset.datasetEntryCheck) }),
    'dataset.describe': dataset.datasetCheck,
    'dataset.open': dataset.datasetEntryCheck,
    'dataset.suggest': members<dataset.DatasetSuggestResult>({
        rake: dataset.suggestedRakeCheck,
        surfaces: list(dataset.suggestedSurfaceCheck),
        why: text,
    }),
    'cache.status': dataset.cacheStatusCheck,
    'probe.sample': members<dataset.ProbeSampleResult>({
        values: mapOf(list(either([orNull(number), point]))),
        inside: list(flag),
    }),
    'family.make': family.familyCheck,
    'family.remove': anyObject,
    'session.create': session.sessionMadeCheck,
    'session.fork': members<session.SessionForkResult>({
        session: text,
        name: text,
        remaining: whole,
        key: optional(text),
        link: optional(text),
    }),
    'session.list': members<session.SessionListResult>({
        sessions: list(session.sessionEntryCheck),
        limit: whole,
        trashLimit: whole,
    }),
    'session.join': session.joinedCheck,
    'session.leave': anyObject,
    'session.state': members<session.SessionStateResult>({
        session: text,
        name: text,
        units: optional(session.unitsCheck),
        rakes: list(rake.rakeRecordCheck),
        surfaces: list(surface.surfaceRecordCheck),
        bookmarks: list(bookmark.bookmarkRecordCheck),
        annotations: list(annotation.annotationRecordCheck),
        clock: time.clockRecordCheck,
        keptAside: optional(session.keptAsideCheck),
        seq: whole,
        participants: list(presence.participantCheck),
    }),
    'session.rename': session.sessionNameCheck,
    'session.setUnits': session.sessionNameCheck,
    'session.delete': members<session.SessionDeleteResult>({ session: text, deletedUntil: optional(text) }),
    'session.restore': session.sessionNameCheck,
    'session.export': members<session.SessionExportResult>({ file: session.sessionFileCheck }),
    'session.import': members<session.SessionImportResult>({ session: text, name: text, remaining: whole, notes: list(text) }),
    'session.thumbnail': anyObject,
    'session.share': members<share.SessionShareResult>({
        grant: text,
        role: shared.roleCheck,
        expires: optional(number),
        newcomers: optional(share.newcomerRoleCheck),
        madeBy: share.shareMakerCheck,
        copy: optional(text),
        children: whole,
        key: text,
        link: text,
    }),
    'session.shares': members<share.SessionSharesResult>({ shares: list(share.shareCheck) }),
    'session.unshare': members<share.SessionUnshareResult>({ children: list(share.shareCheck) }),
    'session.setRole': members<share.SessionSetRoleResult>({
        participant: text,
        role: shared.roleCheck,
        also: list(text),
        newcomers: optional(share.newcomerRoleCheck),
    }),
    'session.kick': anyObject,
    'presence.update': anyObject,
    'rake.set': members<rake.RakeSetResult>({
        rake: text,
        rev: whole,
        seq: whole,
        clipped: flag,
        points: list(point),
        surfaces: list(rake.surfaceEpochCheck),
    }),
    'rake.delete': shared.afterEditCheck,
    'rake.list': members<rake.RakeListResult>({ rakes: list(rake.rakeRecordCheck) }),
    'surface.set': surface.surfaceSetResultCheck,
    'surface.delete': shared.afterEditCheck,
    'surface.stop': members<surface.SurfaceStopResult>({ epoch: whole, stopped: flag }),
    'surface.list': members<surface.SurfaceListResult>({ surfaces: list(surface.surfaceRecordCheck) }),
    'surface.stats': subscription.statisticsCheck,
    'surface.wait': subscription.statisticsCheck,
    'surface.subscribe': members<subscription.SurfaceSubscribeResult>({
        subscription: whole,
        lattice: shared.latticeCheck,
        attributes: list(text),
        epoch: whole,
        resumed: flag,
        ranges: optional(list(subscription.valueRangeCheck)),
    }),
    'surface.unsubscribe': anyObject,
    'frame.ack': anyObject,
    'bookmark.set': members<bookmark.BookmarkSetResult>({ bookmark: text, rev: whole, seq: whole }),
    'bookmark.delete': shared.afterEditCheck,
    'bookmark.list': members<bookmark.BookmarkListResult>({ bookmarks: list(bookmark.bookmarkRecordCheck) }),
    'annotation.set': members<annotation.AnnotationSetResult>({ annotation: text, rev: whole, seq: whole }),
    'annotation.delete': shared.afterEditCheck,
    'annotation.list': members<annotation.AnnotationListResult>({ annotations: list(annotation.annotationRecordCheck) }),
    'history.undo': members<history.HistoryUndoResult>({
        undone: orNull(list(history.changeCheck)),
        seq: whole,
        skipped: list(history.skipCheck),
        undo: whole,
        redo: whole,
    }),
    'history.redo': members<history.HistoryRedoResult>({
        redone: orNull(list(history.changeCheck)),
        seq: whole,
        skipped: list(history.skipCheck),
        undo: whole,
        redo: whole,
    }),
    'time.set': time.clockAnswerCheck,
    'time.play': time.clockAnswerCheck,
    'time.pause': time.clockAnswerCheck,
};
