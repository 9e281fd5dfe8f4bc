// Made by protocol/api/generate from server.schema.json: do not edit.
import { mapOf, members, number, text, whole } from '../checks.ts';
import type { Limits } from './limits.ts';

/** Quantiles of the times measured in the last minute. */
export interface Quantiles {
    /** half took no longer than this (s) */
    p50: number;
    /** 95 % took no longer than this (s) */
    p95: number;
    /** 99 % took no longer than this (s) */
    p99: number;
    /** number of measurements */
    count: number;
}

export const quantilesCheck = members<Quantiles>({ p50: number, p95: number, p99: number, count: whole });

/** The cache of time-steps of a dataset. */
export interface CacheStanding {
    /** id of the dataset */
    dataset: string;
    /** number of requests for a time-step that was in memory */
    hits: number;
    /** number of time-steps that were read */
    loads: number;
    /** memory that the time-steps take (bytes) */
    bytes: number;
    /** memory that the time-steps may take (bytes) */
    budget: number;
}

export const cacheStandingCheck = members<CacheStanding>({
    dataset: text,
    hits: whole,
    loads: whole,
    bytes: whole,
    budget: whole,
});

/** The memory of the process. */
export interface MemoryStanding {
    /** memory that the process holds now (bytes) */
    rss: number;
    /** the most memory that the process has held (bytes) */
    peak: number;
    /** memory that the server may use (--memory) (bytes) */
    budget: number;
    /** how much of the budget is used (bytes) */
    used: number;
    /** how often memory was refused because none was left */
    refused: number;
    /**
     * memory by what it is used for: timeSteps, meshes, builds, surfaces, rings, histories, downloads, importers,
     * records, messages, other (bytes)
     */
    byUse: Record<string, number>;
}

export const memoryStandingCheck = members<MemoryStanding>({
    rss: whole,
    peak: whole,
    budget: whole,
    used: whole,
    refused: whole,
    byUse: mapOf(whole),
});

/** How long each stage from an edit to the socket takes. */
export interface Stages {
    /** waiting until the pass begins */
    queue: Quantiles;
    /** waiting for time-steps */
    load: Quantiles;
    /** moving particles */
    advect: Quantiles;
    /** inserting and removing vertices */
    refine: Quantiles;
    /** encoding frames */
    encode: Quantiles;
    /** waiting until the socket has taken the frames */
    send: Quantiles;
}

export const stagesCheck = members<Stages>({
    queue: quantilesCheck,
    load: quantilesCheck,
    advect: quantilesCheck,
    refine: quantilesCheck,
    encode: quantilesCheck,
    send: quantilesCheck,
});

/** What rpc.discover answers. */
export interface RpcDiscoverResult {
    /** the version of OpenRPC */
    openrpc: string;
}

/** What server.info answers. */
export interface ServerInfoResult {
    /** always `wakesurf` */
    name: string;
    /** version of the program */
    version: string;
    /** raised whenever an older client could misunderstand the server */
    apiLevel: number;
    /** features that a client may look for before it relies on them */
    capabilities: string[];
    /** the limits of this server */
    limits: Limits;
}

/** What server.stats answers. */
export interface ServerStatsResult {
    /** time since the server started (s) */
    uptime?: number;
    /** number of open connections */
    connections?: number;
    /** number of WebSockets */
    clients?: number;
    /** number of sessions that the server keeps */
    sessions?: number;
    /** number of participants now */
    participants: number;
    /** number of surfaces, in all sessions or in the share link's session */
    surfaces: number;
    /** how long each took */
    stages: Stages;
    /** time from an edit to the first frame that was sent */
    firstFrame: Quantiles;
    /** one entry for each dataset with a cache of time-steps */
    cache?: CacheStanding[];
    /** memory of the process */
    memory?: MemoryStanding;
    /** number of messages that were sent */
    messages?: number;
    /** number of frames that were sent */
    frames?: number;
    /** size of all messages and frames that were sent (bytes) */
    bytes?: number;
    /** number of keyframes that were made for clients that had fallen behind */
    keyframes?: number;
    /** number of updates that were left out */
    dropped?: number;
}

/** Parameters of $/cancelRequest. */
export interface CancelRequestParams {
    /** id of the call */
    id: string | number;
}
