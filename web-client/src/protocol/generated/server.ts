// Made by protocol/api/generate from server.schema.json: do not edit.
import { mapOf, members, number, text, whole } from '../checks.ts';
import { type Limits } from './limits.ts';

/** Of the last minute. */
export interface Quantiles {
    /** half took no longer (s) */
    p50: number;
    /** 95 % took no longer (s) */
    p95: number;
    /** 99 % took no longer (s) */
    p99: number;
    /** how many there were */
    count: number;
}

export const quantilesCheck = members<Quantiles>({ p50: number, p95: number, p99: number, count: whole });

/** A dataset's cache of time-steps. */
export interface CacheStanding {
    /** its id */
    dataset: string;
    /** time-steps that were there */
    hits: number;
    /** time-steps that were read */
    loads: number;
    /** in memory (bytes) */
    bytes: number;
    /** that may be in memory (bytes) */
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
    /** that it holds (bytes) */
    rss: number;
    /** the most that it held (bytes) */
    peak: number;
    /** --memory (bytes) */
    budget: number;
    /** of the budget (bytes) */
    used: number;
    /** how often there was none left */
    refused: number;
    /**
     * by what it is for: timeSteps, meshes, builds, surfaces, rings, histories, downloads, importers, records,
     * messages, other (bytes)
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

/** From an edit to the socket. */
export interface Stages {
    /** until the pass began */
    queue: Quantiles;
    /** waiting for time-steps */
    load: Quantiles;
    /** moving particles */
    advect: Quantiles;
    /** putting in vertices and taking them out */
    refine: Quantiles;
    /** making frames */
    encode: Quantiles;
    /** until the socket took them */
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
    /** wakesurf */
    name: string;
    /** of the program */
    version: string;
    /** raised when a client of before could misunderstand the server */
    apiLevel: number;
    /** what a client may look for before it relies on it */
    capabilities: string[];
    /** what it grants */
    limits: Limits;
}

/** What server.stats answers. */
export interface ServerStatsResult {
    /** since the start (s) */
    uptime?: number;
    /** open ones */
    connections?: number;
    /** WebSockets */
    clients?: number;
    /** that the server keeps */
    sessions?: number;
    /** here now */
    participants: number;
    /** of all sessions, or of the link's */
    surfaces: number;
    /** how long each took */
    stages: Stages;
    /** from an edit to the first frame that was sent */
    firstFrame: Quantiles;
    /** one entry a dataset */
    cache?: CacheStanding[];
    /** of the process */
    memory?: MemoryStanding;
    /** sent */
    messages?: number;
    /** sent */
    frames?: number;
    /** sent (bytes) */
    bytes?: number;
    /** made for clients that were behind */
    keyframes?: number;
    /** updates that were left out */
    dropped?: number;
}

/** Parameters of $/cancelRequest. */
export interface CancelRequestParams {
    /** of the call */
    id: string | number;
}
