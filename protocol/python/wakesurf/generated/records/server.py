"""The server: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Dict, List, TypedDict

from ...plain import Json


class Quantiles(TypedDict, total=False):
    """Quantiles of the times measured in the last minute."""

    p50: float  # half took no longer than this (s)
    p95: float  # 95 % took no longer than this (s)
    p99: float  # 99 % took no longer than this (s)
    count: int  # number of measurements


class CacheStanding(TypedDict, total=False):
    """The cache of time-steps of a dataset."""

    dataset: str  # id of the dataset
    hits: int  # number of requests for a time-step that was in memory
    loads: int  # number of time-steps that were read
    bytes: int  # memory that the time-steps take (bytes)
    budget: int  # memory that the time-steps may take (bytes)


class MemoryStanding(TypedDict, total=False):
    """The memory of the process."""

    rss: int  # memory that the process holds now (bytes)
    peak: int  # the most memory that the process has held (bytes)
    budget: int  # memory that the server may use (--memory) (bytes)
    used: int  # how much of the budget is used (bytes)
    refused: int  # how often memory was refused because none was left
    byUse: Dict[str, int]  # memory by what it is used for: timeSteps, meshes, builds, surfaces, rings, histories, ...


class Stages(TypedDict, total=False):
    """How long each stage from an edit to the socket takes."""

    queue: Quantiles  # waiting until the pass begins
    load: Quantiles  # waiting for time-steps
    advect: Quantiles  # moving particles
    refine: Quantiles  # inserting and removing vertices
    encode: Quantiles  # encoding frames
    send: Quantiles  # waiting until the socket has taken the frames


class RpcDiscoverResult(TypedDict, total=False):
    """What rpc.discover answers."""

    openrpc: str  # the version of OpenRPC


class ServerInfoResult(TypedDict, total=False):
    """What server.info answers."""

    name: str  # always `wakesurf`
    version: str  # version of the program
    apiLevel: int  # raised whenever an older client could misunderstand the server
    capabilities: List[str]  # features that a client may look for before it relies on them
    limits: Json  # the limits of this server


class ServerStatsResult(TypedDict, total=False):
    """What server.stats answers."""

    uptime: float  # time since the server started (s); may be missing
    connections: int  # number of open connections; may be missing
    clients: int  # number of WebSockets; may be missing
    sessions: int  # number of sessions that the server keeps; may be missing
    participants: int  # number of participants now
    surfaces: int  # number of surfaces, in all sessions or in the share link's session
    stages: Stages  # how long each took
    firstFrame: Quantiles  # time from an edit to the first frame that was sent
    cache: List[CacheStanding]  # one entry for each dataset with a cache of time-steps; may be missing
    memory: MemoryStanding  # memory of the process; may be missing
    messages: int  # number of messages that were sent; may be missing
    frames: int  # number of frames that were sent; may be missing
    bytes: int  # size of all messages and frames that were sent (bytes); may be missing
    keyframes: int  # number of keyframes that were made for clients that had fallen behind; may be missing
    dropped: int  # number of updates that were left out; may be missing
