"""A client of wakesurf for scripts and notebooks: one file, the standard library and numpy.

    from wakesurf import Client

    with Client("http://127.0.0.1:8080/#token=...") as server:     # the line the server prints; or $WAKESURF_URL
        print(server.datasets())
        session = server.session()                                 # the one called "main"
        rake = session.rake(line=[(-1.5, -1.2, 1), (-1.5, 1.2, 5)], seeds=64)
        surface = session.surface(rake, "streak", dataset="sqcyl", to=16)
        print(surface.wait()["quads"])
        mesh = surface.mesh()                                      # mesh.points, mesh.polygons, mesh["speed"]: numpy
        surface.export("wake.vtp")                                 # for ParaView, see also .glb, .ply, .obj

Everything goes over HTTP (urllib). Only `Surface.watch` and `Surface.live` need a WebSocket, and for it the package
`websocket-client` (Debian: python3-websocket). `watch` tells *that* a surface changed and how, `live` decodes each state
as clients show it (with wakesurf_frames.py), and `mesh` fetches the newest, in full precision. The protocol itself is
described in protocol/README.md and, machine readable, by the server at /openrpc.json.

Failures are subclasses of `WakesurfError`; each has `code`, `kind`, `hint` and `data` as the server gave them.
Objects may be used by one thread at a time.
"""
from __future__ import annotations

import base64
import itertools
import json
import math
import os
import ssl
import struct
import time
import urllib.error
import urllib.parse
import urllib.request
import zlib
import xml.etree.ElementTree
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Tuple, TypedDict, Union

import numpy as np

__all__ = ["Client", "Session", "Rake", "Surface", "Mesh", "Update", "WakesurfError", "InvalidRequest",
           "InvalidParameters", "MethodNotFound", "Unauthenticated", "NotPermitted", "NotFound", "Stale", "Leased",
           "Cancelled", "OutsideDomain", "OutsideTimeRange", "OverLimit", "DatasetError", "ServerFault",
           "Unreachable", "WaitTimeout"]

Point = Sequence[float]
Json = Dict[str, Any]
_LONGEST_WAIT_MS = 60_000
_NULL = object()  # a parameter that is null, not left out
_USUAL = object()  # a parameter that is left out where null means something
_FORMATS = (".vtp", ".glb", ".ply", ".obj", ".drc")
# <limits: made by protocol/api/generate>
_PROBE_POINTS = 4096  # of one call
_MESSAGE_BYTES = 65536  # that the server takes
# </limits>
_PROBE_BYTES = _MESSAGE_BYTES * 3 // 4  # of one call's points
# <spelling: made by protocol/api/generate>
_SURFACE_NAMES = {"rake": "rake", "kind": "kind", "dataset": "dataset", "to": "to", "from_": "from", "rake2": "rake2",
                  "direction": "direction", "accuracy": "accuracy", "interpolation": "interpolation",
                  "release_until": "releaseUntil", "sweep": "sweep", "merge": "merge", "angle": "angle",
                  "stagnation_speed": "stagnationSpeed", "max_quads": "maxQuads", "separation": "separation",
                  "fields": "fields"}
# </spelling>


# What the server answers. Members that may be missing are not there then.
# <records: made by protocol/api/generate>
class Lattice(TypedDict, total=False):
    """The integer grid of a dataset's frames: node (i, j, k) lies at origin + step * (i, j, k)."""

    origin: List[float]  # position of node (0, 0, 0) (the dataset's unit of length)
    step: float  # distance between neighbouring nodes (the dataset's unit of length)
    bits: int  # there are 2^bits nodes along each side


class Problem(TypedDict, total=False):
    """An error that is part of a result, where the call itself did not fail."""

    code: int  # code of the error
    message: str  # what is wrong
    kind: str  # a word for programs
    hint: str  # a sentence for people: what to do about it; may be empty
    limit: float  # for overLimit: the most that is allowed; may be missing


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


class Steps(TypedDict, total=False):
    """Numbers of time-steps."""

    ready: int  # time-steps that can be used
    total: int  # time-steps that there will be after the import


class DatasetEntry(TypedDict, total=False):
    """A dataset as a list shows it."""

    dataset: str  # id of the dataset
    name: str  # display name
    state: str  # state of the import
    steps: Steps  # numbers of time-steps
    progress: float  # progress of the import; may be missing
    remaining: float  # time that the import still needs (s); may be missing
    error: Problem  # why the import failed or ended early; may be missing


class Field(TypedDict, total=False):
    """A field of a dataset."""

    name: str  # name of the field in the files
    components: int  # number of components; 3: a vector
    source: str  # whether the files have the values at points or in cells
    range: List[Optional[float]]  # smallest and largest value (for a vector, of its magnitude); null: unknown
    unit: str  # unit of the values, as stated in the files; may be missing


class Dataset(TypedDict, total=False):
    """The description of a dataset."""

    dataset: str  # id of the dataset
    name: str  # display name
    reader: str  # name of the reader that read the files
    grid: str  # kind of grid
    bounds: List[float]  # bounding box: x0, x1, y0, y1, z0, z1 (the dataset's unit of length)
    points: int  # number of points of the grid
    cells: int  # number of cells of the grid
    times: List[float]  # times of the time-steps (the dataset's unit of time)
    steady: bool  # true: the flow does not change in time
    fields: List[Field]  # all fields
    velocity: str  # name of the field that particles follow
    why: str  # why this field was taken as the velocity
    obstacle: bool  # true: there is an obstacle in the flow
    bytesPerStep: int  # memory that one time-step takes (bytes)
    finestSpacing: float  # smallest spacing of the grid (the dataset's unit of length)
    lattice: Lattice  # lattice of the frames of its surfaces
    smooth: bool  # true: surface.set accepts `interpolation` smooth
    surfaceFields: List[str]  # names that `fields` of surface.set accepts
    note: str  # a remark about the data, for people; may be missing
    lengthUnit: str  # unit of lengths and coordinates; left out if the files do not state it; may be missing
    timeUnit: str  # unit of times; left out if the files do not state it; may be missing
    precision: str  # half: the values are stored with 16 bits each; may be missing
    dimensions: List[int]  # number of points along x, y and z; may be missing
    spacing: List[float]  # spacing of a uniform grid along x, y and z (the dataset's unit of length); may be missing


SuggestedSurface = TypedDict("SuggestedSurface", {  # Parameters to begin a surface with, as surface.set takes them.
    "kind": "str",  # stream: streamlines of the field frozen at `from`; path: particles released together at ...
    "from": "float",  # where the surface starts (the dataset's unit of time)
    "to": "float",  # where it ends (the dataset's unit of time)
    "separation": "float",  # longest edge allowed (the dataset's unit of length)
    "sweep": "List[float]",  # of a time surface: the patch is the rake swept along this vector (the dataset's unit ...
}, total=False)


class SuggestedRake(TypedDict, total=False):
    """A line to release particles from, as rake.set takes it."""

    kind: str  # kind of rake
    points: List[List[float]]  # both ends of the line (the dataset's unit of length)
    seeds: int  # initial number of seeds


class CacheStatus(TypedDict, total=False):
    """Which time-steps are in memory."""

    dataset: str  # id of the dataset
    steps: List[str]  # state of each time-step; empty for a built-in flow
    bytes: int  # memory that the time-steps take (bytes)
    budget: int  # memory that the time-steps may take (bytes)


class AsideRecord(TypedDict, total=False):
    """A record that could not be used when the server started."""

    type: str  # kind of record: rake, surface, bookmark or annotation
    id: str  # id of the record
    why: str  # why it could not be used
    since: int  # when it was put aside (s since 1970)


class KeptAside(TypedDict, total=False):
    """Records that could not be used when the server started."""

    count: int  # number of all such records
    records: List[AsideRecord]  # the newest 50 of them


class Units(TypedDict, total=False):
    """The units that the people of a session have typed."""

    length: str  # unit of lengths; empty: as in dataset.describe
    time: str  # unit of times; empty: as in dataset.describe


class Snapshot(TypedDict, total=False):
    """All records of a session."""

    session: str  # id of the session
    name: str  # display name
    units: Units  # left out if no one has typed any; may be missing
    rakes: List[RakeRecord]  # all rakes
    surfaces: List[SurfaceRecord]  # all surfaces
    bookmarks: List[BookmarkRecord]  # all bookmarks
    annotations: List[AnnotationRecord]  # all annotations
    clock: ClockRecord  # the session's clock
    keptAside: KeptAside  # records that are kept aside, if there are any; may be missing


class SessionName(TypedDict, total=False):
    """The id and the name of a session, and its units."""

    session: str  # id of the session
    name: str  # display name
    units: Units  # left out if no one has typed any; may be missing


class SessionMade(TypedDict, total=False):
    """A new session."""

    session: str  # id of the session
    name: str  # display name
    remaining: int  # how many more sessions can be made


class TimesOfDataset(TypedDict, total=False):
    """The time-steps of a dataset."""

    count: int  # number of time-steps
    first: float  # time of the first time-step (the dataset's unit of time)
    last: float  # time of the last time-step (the dataset's unit of time)


class NamedDataset(TypedDict, total=False):
    """A dataset that surfaces of a document use."""

    dataset: str  # id of the dataset
    name: str  # display name; may be missing
    fingerprint: str  # fingerprint of the mesh and of the names of the fields; it stays the same when time-steps ...
    times: TimesOfDataset  # its time-steps; may be missing
    bounds: List[float]  # bounding box: x0, x1, y0, y1, z0, z1 (the dataset's unit of length); may be missing


class FileRecords(TypedDict, total=False):
    """The records of a session as in a snapshot, with their ids, but without `rev` and `epoch`."""

    rakes: List[Json]  # all rakes
    surfaces: List[Json]  # all surfaces
    bookmarks: List[Json]  # all bookmarks
    annotations: List[Json]  # all annotations
    clock: ClockRecord  # the session's clock


class SessionFile(TypedDict, total=False):
    """A session as one document."""

    wakesurfSession: int  # version of the format
    name: str  # display name
    exported: str  # when the document was written, in UTC
    wakesurf: str  # version of the program that wrote it
    records: FileRecords  # the records of the session
    datasets: List[NamedDataset]  # datasets that the surfaces use
    units: Units  # left out if no one has typed any; may be missing


class Visitor(TypedDict, total=False):
    """Someone who was in a session."""

    name: str  # the name they had
    colour: str  # their colour, #rrggbb


class SessionEntry(TypedDict, total=False):
    """A session as a list shows it."""

    session: str  # id of the session
    name: str  # display name
    participants: int  # number of participants who are in the session now
    people: List[Visitor]  # people who have been in the session; the last to join is the first in the list
    created: str  # when the session was made, in UTC; not recorded for old sessions; may be missing
    lastUsed: str  # when the session was last used, in UTC
    edited: bool  # true: someone has edited it, beyond the first rake and surface that a page makes
    rakes: int  # number of rakes
    surfaces: int  # number of surfaces
    bookmarks: int  # number of bookmarks
    annotations: int  # number of annotations
    thumbnail: bool  # true: there is a picture of it
    deletedAt: str  # for a session in the trash: when it was deleted, in UTC; may be missing
    deletedUntil: str  # for a session in the trash: until when it can be restored, in UTC; may be missing


class Patch(TypedDict, total=False):
    """A change of a record: the record as it is now, or that it was deleted."""

    op: str  # what happened to the record
    type: str  # kind of record
    id: str  # id of the record
    record: Any  # for put: the record as it is now; may be missing


class Joined(TypedDict, total=False):
    """What session.join returns: either `snapshot` or `patches`."""

    you: str  # your id as a participant
    role: str  # your role in the session
    resumeToken: str  # token with which you can come back; if it differs from the one you sent, nothing from before ...
    seq: int  # `seq` of the session now
    participants: List[Participant]  # all participants
    created: str  # when the session was made, in UTC, as in session.list; may be missing
    resumed: bool  # true: `patches` is present; false: `snapshot` is present
    snapshot: Snapshot  # all records of the session; may be missing
    patches: List[Patch]  # what changed after `lastSeq`; for each record only the newest change; may be missing


class ShareMaker(TypedDict, total=False):
    """Who made a link."""

    grant: str  # id of the link by which they came; if left out, they had the server's own token; may be missing
    name: str  # name of the participant; empty: a script


class Share(TypedDict, total=False):
    """A valid share link, without its key."""

    grant: str  # id of the link
    role: str  # role of those who come by it
    expires: float  # when the link expires; if left out, never (s since 1970); may be missing
    newcomers: str  # role of those who come by it from now on; present if a host has given someone who came by it a ...
    madeBy: ShareMaker  # who made it
    children: int  # number of valid links that were made through this one, directly or indirectly


class Camera(TypedDict, total=False):
    """Where someone looks from."""

    position: List[float]  # position of the eye (the dataset's unit of length)
    target: List[float]  # the point in the middle of the picture (the dataset's unit of length)
    up: List[float]  # direction that points up in the picture (the dataset's unit of length)
    fov: float  # field of view from top to bottom; if left out, the view is orthographic or unknown (degrees); may ...


class DraggedRake(TypedDict, total=False):
    """A rake while it is dragged."""

    rake: str  # id of the rake
    points: List[List[float]]  # where the rake is now; may be missing


class Presence(TypedDict, total=False):
    """What someone is doing at the moment."""

    pointer: Optional[List[float]]  # the point they point at (the dataset's unit of length); may be missing
    camera: Optional[Camera]  # where they look from; may be missing
    dragging: Optional[DraggedRake]  # the rake they drag; may be missing
    selected: Optional[str]  # id of the record they have selected; may be missing


class Participant(TypedDict, total=False):
    """Someone in a session."""

    participant: str  # id of the participant
    name: str  # display name; two people in a session never have the same one
    colour: str  # their colour, #rrggbb
    role: str  # what someone may do; each role includes the ones before it
    connected: bool  # false: the connection was lost less than 10 s ago
    pointer: Optional[List[float]]  # the point they point at (the dataset's unit of length); may be missing
    camera: Optional[Camera]  # where they look from; may be missing
    dragging: Optional[DraggedRake]  # the rake they drag; may be missing
    selected: Optional[str]  # id of the record they have selected; may be missing


class RakeRecord(TypedDict, total=False):
    """A rake as the session keeps it."""

    rake: str  # id of the rake
    rev: int  # counts the edits of a record
    kind: str  # what the points are; line: 2 points; polyline and points: 2 or more; circle: the centre and two ...
    points: List[List[float]]  # where the rake lies; parts outside the domain are cut off (the dataset's unit of ...
    seeds: int  # number of seeds on the rake
    name: str  # display name
    colour: str  # #rrggbb
    author: str  # name of the one who made it
    clipped: bool  # true: a part was outside the domain and was cut off
    dragging: bool  # true: someone holds the lease at the moment
    leasedBy: str  # id of the participant who holds the lease; only present while someone does; may be missing


class SurfaceEpoch(TypedDict, total=False):
    """A surface that is being built again."""

    surface: str  # id of the surface
    epoch: int  # counts the surfaces that have been built for the record; it never decreases


SurfaceRecord = TypedDict("SurfaceRecord", {  # A surface as the session keeps it: its parameters, not its mesh.
    "surface": "str",  # id of the surface
    "rev": "int",  # counts the edits of a record
    "epoch": "int",  # counts the surfaces that have been built for the record; it never decreases
    "rake": "str",  # an id from rake.list; the particles start from this rake
    "rake2": "str",  # the patch lies between the rake and this second rake; may be missing
    "dataset": "str",  # an id from dataset.list
    "kind": "str",  # stream: streamlines of the field frozen at `from`; path: particles released together at ...
    "accuracy": "str",  # how accurately particles are traced and vertices inserted
    "interpolation": "str",  # of stored velocity. linear: between the nodes of a cell and in time, as ParaView ...
    "to": "float",  # where the surface ends: before `from`, time runs backward. A stream surface is followed for ...
    "releaseUntil": "float",  # time at which the release stops; if left out, `to` (the dataset's unit of time); may ...
    "sweep": "List[float]",  # the patch is the rake swept along this vector (the dataset's unit of length); may be ...
    "merge": "float",  # quads smaller than this are joined; 0: never (part of the separation)
    "angle": "float",  # neighbouring quads at a larger angle are refined, as far as the separation and `maxQuads` ...
    "stagnationSpeed": "float",  # a slower particle counts as at rest and ends; 0: only a particle that does not ...
    "maxQuads": "int",  # maximum number of quads
    "from": "float",  # where the surface starts: the (first) release; for stream surfaces, the time at which the ...
    "direction": "str",  # which way particles are followed in time
    "separation": "float",  # longest edge allowed (the dataset's unit of length)
    "fields": "List[str]",  # additional attributes of the vertices, in frames and exports: scalar fields of the ...
}, total=False)


class SurfaceSetResult(TypedDict, total=False):
    """What surface.set returns."""

    surface: str  # id of the surface
    rev: int  # counts the edits of a record
    epoch: int  # counts the surfaces that have been built for the record; it never decreases
    seq: int  # `seq` of the session after the edit


class PassSeconds(TypedDict, total=False):
    """How long the pass that made the newest state took."""

    queue: float  # from the edit, or the state before, until the pass began (s)
    load: float  # waiting for time-steps of the velocity (s)
    compute: float  # everything else in building the surface (s)
    encode: float  # encoding frames (s)


class Terminations(TypedDict, total=False):
    """Numbers of particles, by what ended them."""

    domain: int  # particles that left the domain
    time: int  # particles that reached the end of the requested time
    obstacle: int  # particles that reached an obstacle
    stagnation: int  # particles that came to rest
    budget: int  # particles that used up the steps allowed


class BuildSeconds(TypedDict, total=False):
    """How long it took to build a surface."""

    load: float  # waiting for time-steps (s)
    advect: float  # moving particles (s)
    refine: float  # inserting and removing vertices (s)
    other: float  # everything else (s)
    total: float  # the whole build (s)
    processor: float  # of all processors together, for the whole build; only in `wakesurf surface --stats` (s); may ...


class Emptiness(TypedDict, total=False):
    """Why there is nothing to see of a surface."""

    reason: str  # why a surface shows nothing. inBody, outsideCells: the whole rake lies there; atRest: the fluid ...
    message: str  # the reason, for people
    hint: str  # what to do about it


Statistics = TypedDict("Statistics", {  # Statistics of the newest state of a surface, in the shape of `wakesurf surface --stats`.
    "surface": "str",  # id of the surface
    "epoch": "int",  # counts the surfaces that have been built for the record; it never decreases
    "complete": "bool",  # true: this is the final surface of its epoch
    "kind": "str",  # stream: streamlines of the field frozen at `from`; path: particles released together at ...
    "quads": "int",  # number of quads
    "vertices": "int",  # number of vertices
    "steps": "int",  # number of steps of the surface, in time or along its curves
    "vertexSteps": "int",  # number of steps of the integrator, for all particles together
    "approximated": "int",  # number of vertices that were interpolated, not traced from the rake
    "error99": "float",  # 99 % of the vertices are estimated to be no farther than this from the particles they ...
    "terminated": "Terminations",  # numbers of particles from the rake's seeds, by what ended them; of streak and ...
    "maxEdge": "float",  # length of the longest edge (the dataset's unit of length)
    "separation": "float",  # longest edge allowed in the end (the dataset's unit of length)
    "requestedSeparation": "float",  # longest edge that was asked for (the dataset's unit of length)
    "coarsened": "bool",  # true: within `maxQuads` the separation asked for is not possible, so `separation` is ...
    "seconds": "BuildSeconds",  # how long it took to build the surface
    "pass": "PassSeconds",  # how long it took to make this state; may be missing
    "peakBytes": "int",  # the most memory that the process has held, for everything that it does (bytes)
    "dataEnd": "float",  # first time of the data, where it cuts the backward side of a path surface of both ...
    "stopped": "str",  # why the surface ends early; may be missing
    "empty": "Emptiness",  # why there is nothing to see; left out where there is something; may be missing
    "stateSum": "int",  # checksum of what clients show, as in the frames (protocol/wire/FORMAT.md, State sum)
    "error": "Problem",  # why the surface is not complete; may be missing
}, total=False)


class BookmarkRecord(TypedDict, total=False):
    """A bookmark as the session keeps it."""

    bookmark: str  # id of the bookmark
    rev: int  # counts the edits of a record
    name: str  # display name
    view: Json  # camera, colours and so on, in whatever form the client chooses; at most 4 KiB as JSON text
    time: float  # the session's time that belongs to the view (the dataset's unit of time); may be missing


class AnnotationRecord(TypedDict, total=False):
    """An annotation as the session keeps it."""

    annotation: str  # id of the annotation
    rev: int  # counts the edits of a record
    text: str  # text of one or more lines
    position: List[float]  # the point that it refers to (the dataset's unit of length)
    author: str  # name of the one who made it
    surface: str  # id of the surface that it refers to, which may have been deleted since; may be missing


class Change(TypedDict, total=False):
    """A record that was changed."""

    op: str  # what happened to the record
    type: str  # kind of record: rake, surface, bookmark or annotation
    id: str  # id of the record
    rev: int  # counts the edits of a record; may be missing


class Skip(TypedDict, total=False):
    """A record that was skipped because someone else has changed it since."""

    type: str  # kind of record: rake, surface, bookmark or annotation
    id: str  # id of the record
    why: str  # why it was skipped, for people


class HistoryDepth(TypedDict, total=False):
    """What can be undone and redone."""

    seq: int  # `seq` of the session after the edit
    skipped: List[Skip]  # records that were skipped; their edits are forgotten for good
    undo: int  # number of edits that can still be taken back
    redo: int  # number of edits that can be repeated


ClockRecord = TypedDict("ClockRecord", {  # The clock of a session.
    "time": "Optional[float]",  # simulation time; null: it was never set, and surfaces are shown at their end (the ...
    "playing": "bool",  # true: the clock runs
    "speed": "float",  # how fast the clock runs (simulation time a second)
    "loop": "bool",  # true: the clock goes on at `from` when it reaches `to`
    "from": "Optional[float]",  # time at which playing starts; null before the clock was first played (the ...
    "to": "Optional[float]",  # time at which playing ends; null before the clock was first played (the dataset's ...
}, total=False)


class ClockAnswer(TypedDict, total=False):
    """The clock after the call."""

    clock: ClockRecord  # the clock as it is now
# </records>


class WakesurfError(Exception):
    """What the server refused, or why it could not be asked."""

    def __init__(self, message: str, code: int = 0, kind: str = "", hint: str = "", data: Optional[Json] = None):
        super().__init__(message + (f" ({hint})" if hint else ""))
        self.message, self.code, self.kind, self.hint, self.data = message, code, kind, hint, data or {}


class InvalidRequest(WakesurfError):
    """Not a call, too long, or a method that needs a WebSocket."""


class InvalidParameters(WakesurfError):
    """A parameter is missing, unknown, malformed or out of range; the message names it."""


class MethodNotFound(WakesurfError):
    """This server has no such method: it may be older than this file."""


class Unauthenticated(WakesurfError):
    """No token, or not a valid one."""


class NotPermitted(WakesurfError):
    """The role of the token does not allow it."""


class NotFound(WakesurfError):
    """There is no such session, record or dataset."""


class Stale(WakesurfError):
    """`if_rev` is not the record's revision; `current` is the record."""

    @property
    def current(self) -> Json:
        return self.data.get("current", {})


class Leased(WakesurfError):
    """Someone else is dragging the rake: `by` whom, `until` when."""

    @property
    def by(self) -> str:
        return self.data.get("by", "")

    @property
    def until(self) -> str:
        return self.data.get("until", "")


class Cancelled(WakesurfError):
    """The work was replaced by a newer edit."""


class OutsideDomain(WakesurfError):
    """The message says by how much."""


class OutsideTimeRange(WakesurfError):
    """Not within the dataset's times."""


class OverLimit(WakesurfError):
    """More than the server grants."""


class DatasetError(WakesurfError):
    """The data are unreadable or damaged."""


class ServerFault(WakesurfError):
    """A fault of the server; its log has the details."""


class Unreachable(WakesurfError, ConnectionError):
    """No one answers at the address, or the connection broke."""


class WaitTimeout(WakesurfError, TimeoutError):
    """The surface was not complete in time; it is still being computed."""


# <errors: made by protocol/api/generate>
_BY_CODE = {-32700: InvalidRequest, -32600: InvalidRequest, -32601: MethodNotFound, -32602: InvalidParameters,
            -32603: ServerFault, -32800: Cancelled, -32801: Stale, -32001: Unauthenticated, -32003: NotPermitted,
            -32004: NotFound, -32011: Leased, -32012: OutsideDomain, -32013: OutsideTimeRange, -32014: OverLimit,
            -32015: DatasetError}
# </errors>


def _error(fault: Mapping[str, Any]) -> WakesurfError:
    data = dict(fault.get("data") or {})
    kind = _BY_CODE.get(fault.get("code", 0), WakesurfError)
    return kind(fault.get("message", ""), fault.get("code", 0), data.pop("kind", ""), data.pop("hint", ""), data)


class Client:
    """A server. `url` is its address, with or without `#token=...` behind it; left out, `$WAKESURF_URL` or
    http://127.0.0.1:8080. The token: `token`, else the one in `url`, else `$WAKESURF_TOKEN`.

    `timeout`: seconds without an answer after which a call fails with `Unreachable`. `tls`: an `ssl.SSLContext` for a
    certificate that the system does not know.
    """

    def __init__(self, url: Optional[str] = None, token: Optional[str] = None, timeout: float = 60.0,
                 tls: Optional[ssl.SSLContext] = None):
        url = url or os.environ.get("WAKESURF_URL") or "http://127.0.0.1:8080"
        if "://" not in url:
            url = "http://" + url
        parts = urllib.parse.urlsplit(url)
        words = urllib.parse.parse_qs(parts.fragment)
        self.url = urllib.parse.urlunsplit((parts.scheme, parts.netloc, parts.path.rstrip("/"), "", ""))
        self.timeout = timeout
        self._token = token or words.get("token", [""])[0] or os.environ.get("WAKESURF_TOKEN", "")
        self._session = words.get("session", ["main"])[0]
        self._tls = tls
        handlers: List[urllib.request.BaseHandler] = [urllib.request.HTTPSHandler(context=tls)] if tls else []
        if parts.hostname in ("127.0.0.1", "localhost", "::1"):
            handlers.append(urllib.request.ProxyHandler({}))
        self._opener = urllib.request.build_opener(*handlers)
        self._ids = itertools.count(1)
        self._velocities: Dict[str, str] = {}

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, *_: object) -> None:
        """Nothing is held open between calls."""

    def __repr__(self) -> str:
        return f"Client({self.url!r})"

    def _request(self, path: str, body: Optional[bytes] = None, headers: Optional[Dict[str, str]] = None,
                 timeout: Optional[float] = None) -> Tuple[int, Mapping[str, str], bytes]:
        request = urllib.request.Request(self.url + path, data=body, headers=dict(headers or {}))
        if self._token:
            request.add_header("Authorization", "Bearer " + self._token)
        if body is not None:
            request.add_header("Content-Type", "application/json")
        try:
            with self._opener.open(request, timeout=timeout or self.timeout) as reply:
                return reply.status, reply.headers, reply.read()
        except urllib.error.HTTPError as reply:
            with reply:
                return reply.code, reply.headers, reply.read()
        except (OSError, urllib.error.URLError) as problem:
            reason = getattr(problem, "reason", problem)
            raise Unreachable(f"no answer from {self.url}: {reason}", hint="is the server running?") from None

    def _rpc(self, message: Any, timeout: Optional[float] = None) -> Any:
        status, _, body = self._request("/rpc", json.dumps(message).encode(), timeout=timeout)
        if status == 204:
            return None
        try:
            answer = json.loads(body)
        except ValueError:
            raise ServerFault(f"HTTP status {status} and no JSON", hint="is this a wakesurf server?") from None
        if status != 200:
            raise _error(answer["error"])
        return answer

    def call(self, method: str, _timeout: Optional[float] = None, /, **parameters: Any) -> Any:
        """Any method of the server, by its name; parameters that are None are left out. Waits and asks again, up to
        five times, where the server says that calls come too fast."""
        request = {"jsonrpc": "2.0", "id": next(self._ids), "method": method,
                   "params": {name: _plain(value, name) for name, value in parameters.items() if value is not None}}
        for attempt in range(6):
            answer = self._rpc(request, _timeout)
            if "error" not in answer:
                return answer["result"]
            problem = _error(answer["error"])
            if attempt == 5 or "retryAfterMs" not in problem.data:
                raise problem
            time.sleep(min(problem.data["retryAfterMs"], 5000) / 1000)

    def batch(self, calls: Iterable[Tuple[str, Json]]) -> List[Any]:
        """Several calls in one message. Results in order; a call that failed has its error as a value."""
        requests = [{"jsonrpc": "2.0", "id": next(self._ids), "method": method,
                     "params": {name: _plain(value, name) for name, value in parameters.items()}}
                    for method, parameters in calls]
        if not requests:
            return []
        answers = self._rpc(requests)
        if isinstance(answers, dict):
            raise _error(answers["error"])
        by_id = {answer["id"]: answer for answer in answers}
        return [by_id[each["id"]]["result"] if "result" in by_id[each["id"]] else _error(by_id[each["id"]]["error"])
                for each in requests]

    def info(self) -> Json:
        """Name, version, capabilities and limits of the server."""
        return self.call("server.info")

    def datasets(self) -> List[DatasetEntry]:
        """What there is to look at: {dataset, name, state, ...} each."""
        return self.call("dataset.list")["datasets"]

    def describe(self, dataset: str) -> Dataset:
        """Grid, bounds, times and fields of a dataset."""
        return self.call("dataset.describe", dataset=dataset)

    def suggest(self, dataset: str) -> Json:
        """A rake and the parameters of surfaces to begin with in a dataset, and why they were chosen."""
        return self.call("dataset.suggest", dataset=dataset)

    def cache(self, dataset: str) -> CacheStatus:
        """Which of its time-steps are in the server's memory."""
        return self.call("cache.status", dataset=dataset)

    def probe(self, dataset: str, points: Iterable[Point], time: float,
              fields: Optional[Sequence[str]] = None) -> Dict[str, np.ndarray]:
        """Fields at points, (n,) or (n, 3) each, NaN outside of the fluid; `inside` says which points are in it. Many
        points are asked for in several calls, as a message has at most 64 KiB: some 1,000 points each."""
        parts = [self._probe(dataset, part, time, fields) for part in _slices(_plain(list(points), "points"))]
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def _probe(self, dataset: str, points: Sequence[Point], time: float,
               fields: Optional[Sequence[str]]) -> Dict[str, np.ndarray]:
        answer = self.call("probe.sample", dataset=dataset, points=points, time=time, fields=fields)
        out: Dict[str, np.ndarray] = {}
        for name, values in answer["values"].items():
            vector = any(isinstance(value, list) for value in values) or (
                all(value is None for value in values) and name == self._velocity(dataset))
            missing = [np.nan] * 3 if vector else np.nan
            found = np.array([missing if value is None else value for value in values], dtype=float)
            out[name] = found.reshape(-1, 3) if vector else found
        out["inside"] = np.array(answer["inside"], dtype=bool)
        return out

    def _velocity(self, dataset: str) -> str:
        """Of a part that lies outside as a whole, nothing else tells that it is a vector."""
        if dataset not in self._velocities:
            self._velocities[dataset] = self.describe(dataset)["velocity"]
        return self._velocities[dataset]

    def sessions(self, trash: bool = False) -> List["Session"]:
        """Those this token lets in, or those in the trash. `Session.about` of each says what it is called, who was in it,
        when it was last used and what it has."""
        return [Session(self, each["session"], each)
                for each in self.call("session.list", trash=trash or None)["sessions"]]

    def session(self, session: Optional[str] = None) -> "Session":
        """The session with this id; left out, the one in the address, else `main`. Error: NotFound."""
        found = Session(self, session or self._session)
        found.state()
        return found

    def create_session(self, name: str = "") -> "Session":
        """A new, empty one; `Session.about["remaining"]` says how many more there may be. Give it a name: the server may
        give up one without a name that no one ever edits. Error: OverLimit."""
        made = self.call("session.create", name=name)
        return Session(self, made["session"], made)

    def import_session(self, path: Union[str, "os.PathLike[str]"], name: str = "") -> "Session":
        """A new session of a file that `Session.export` wrote, here or on another server. `Session.about["notes"]` are
        sentences about datasets that are not here, or are other ones. Error: InvalidParameters, OverLimit."""
        with open(path, "rb") as file:
            body = file.read()
        status, _, answer = self._request("/api/v1/sessions", body)
        made = json.loads(answer)
        if status != 200:
            raise _error(made["error"])
        session = Session(self, made["session"], made)
        if name:
            session.rename(name)
        return session


class Session:
    """Rakes and surfaces that several people and scripts look at and edit together. Edits are seen by all at once."""

    def __init__(self, client: Client, id: str, about: Optional[Json] = None):
        self.client, self.id = client, id
        self.about: Json = dict(about or {})  # what the call told that gave this object: see session.list

    def __repr__(self) -> str:
        return f"Session({self.id!r})"

    def call(self, method: str, _timeout: Optional[float] = None, /, **parameters: Any) -> Any:
        """Any method on this session's records."""
        return self.client.call(method, _timeout, session=self.id, **parameters)

    def state(self) -> Json:
        """Every record, and who is here."""
        return self.call("session.state")

    def rename(self, name: str) -> None:
        """Another name, for everyone."""
        self.about.update(self.call("session.rename", name=name))

    def delete(self, forever: bool = False) -> None:
        """Moves the session to the trash, where it can be restored for 30 days (`about["deletedUntil"]`); `forever`: out
        of the trash for good. `main` cannot be deleted. Error: NotFound, NotPermitted."""
        self.about.update(self.call("session.delete", forever=forever or None))

    def restore(self) -> None:
        """Out of the trash, as it was. Error: NotFound, OverLimit."""
        self.about.update(self.call("session.restore"))

    def export(self, path: Union[str, "os.PathLike[str]"]) -> str:
        """Writes the session as one file: records, notes, views, and the names and fingerprints of its datasets.
        `Client.import_session` makes a session of it again. Returns the path."""
        status, _, body = self.client._request(f"/api/v1/sessions/{urllib.parse.quote(self.id, safe='')}/session.json")
        if status != 200:
            raise _error(json.loads(body)["error"])
        with open(path, "wb") as file:
            file.write(body)
        return os.fspath(path)

    def thumbnail(self) -> Optional[bytes]:
        """The picture (PNG, JPEG or WebP) that a page sent of it; None where there is none."""
        status, _, body = self.client._request(f"/api/v1/sessions/{urllib.parse.quote(self.id, safe='')}/thumbnail")
        if status == 200:
            return body
        problem = _error(json.loads(body)["error"])
        if isinstance(problem, NotFound) and self.state():
            return None
        raise problem

    def fork(self, name: str = "") -> "Session":
        """A new session with copies of the records."""
        return Session(self.client, self.call("session.fork", name=name)["session"])

    def share(self, role: str = "viewer", expires_in: Any = _USUAL) -> str:
        """The address that lets others into this session, as viewer, editor or host, for `expires_in` seconds; None: until
        it is taken back; left out: a week, or as long as the link you came by. Anyone who has it is in: treat it as a password."""
        lasts = None if expires_in is _USUAL else _NULL if expires_in is None else expires_in
        return self.client.url + "/" + self.call("session.share", role=role, expiresIn=lasts)["link"]

    def rake(self, line: Optional[Sequence[Point]] = None, polyline: Optional[Sequence[Point]] = None,
             circle: Optional[Sequence[Point]] = None, points: Optional[Sequence[Point]] = None, seeds: int = 32,
             name: str = "", colour: Optional[str] = None) -> "Rake":
        """Makes a rake; give one of `line` (2 points), `polyline` (2 or more), `circle` (centre and two points of the
        rim) and `points`. What is outside of the domain is cut away, see `Rake.clipped`. `colour` is "#rrggbb"; without,
        it gets one that few others have."""
        kind, where = _one_of(line=line, polyline=polyline, circle=circle, points=points)
        answer = self.call("rake.set", kind=kind, points=where, seeds=seeds, name=name, colour=colour)
        return Rake(self, answer["rake"])

    def rakes(self) -> List["Rake"]:
        return [Rake(self, each["rake"]) for each in self.call("rake.list")["rakes"]]

    # <surface: made by protocol/api/generate>
    def surface(self, rake: Union["Rake", str], kind: str, dataset: str, to: float, from_: Optional[float] = None, *,
                rake2: Optional[Union["Rake", str]] = None, direction: Optional[str] = None,
                accuracy: Optional[str] = None, interpolation: Optional[str] = None,
                release_until: Optional[float] = None, sweep: Optional[Point] = None, merge: Optional[float] = None,
                angle: Optional[float] = None, stagnation_speed: Optional[float] = None,
                max_quads: Optional[int] = None, separation: Optional[float] = None,
                fields: Optional[Sequence[str]] = None, **more: Any) -> "Surface":
        """Makes a surface and starts computing it. What is left out has the default of `surface.set`, whose spelling, as in
        maxQuads, is taken too. What `fields` names is also in `Surface.mesh`, by name.

        `rake`: an id from rake.list; the particles start from this rake.
        `kind`: stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak:
            particles released continuously from `from` on; time: a patch of particles released at `from`.
        `dataset`: an id from dataset.list.
        `to`: where the surface ends: before `from`, time runs backward. A stream surface is followed for `to` - `from`,
            and `to` need not lie in the data; for the others it must (the dataset's unit of time).
        `from_`: where the surface starts: the (first) release; for stream surfaces, the time at which the field is
            frozen; if left out, the first time of the data, or the last where `direction` is backward (the dataset's
            unit of time).
        `rake2`: the patch lies between the rake and this second rake; only for time surfaces.
        `direction`: if left out, forward or backward as `from` and `to` say; it must not contradict them. both: to the
            later time `to`, and as long before `from`, a path surface as far as there are data; only for stream and
            path surfaces.
        `accuracy`: how accurately particles are traced and vertices inserted; default balanced.
        `interpolation`: of stored velocity. linear: between the nodes of a cell and in time, as ParaView shows it;
            smooth: cubic in space and time, for uniform grids only, see `smooth` of dataset.describe; default linear.
        `release_until`: time at which the release stops; if left out, `to` (the dataset's unit of time); only for
            streak surfaces.
        `sweep`: the patch is the rake swept along this vector (the dataset's unit of length); only for time surfaces.
        `merge`: quads smaller than this are joined; 0: never (part of the separation); 0 to 0.5; default 0.35.
        `angle`: neighbouring quads at a larger angle are refined, as far as the separation and `max_quads` allow; 180:
            never (degrees); above 0, at most 180; default 20.
        `stagnation_speed`: a slower particle counts as at rest and ends; 0: only a particle that does not move at all
            (part of the largest speed); 0 to 0.1; default 1e-06.
        `max_quads`: maximum number of quads; 1 to 4,000,000; default 1,000,000.
        `separation`: longest edge allowed; if left out, the dataset's finest spacing (the dataset's unit of length);
            above 0.
        `fields`: additional attributes of the vertices, in frames and exports: scalar fields of the dataset, its
            velocity (the magnitude), `deformation`, `approximated`, `error`, `vorticity` (its magnitude),
            `q_criterion`.
        """
        given: Json = {"rake": _id(rake), "kind": kind, "dataset": dataset, "to": to, "from": from_, "rake2": rake2,
                       "direction": direction, "accuracy": accuracy, "interpolation": interpolation,
                       "releaseUntil": release_until, "sweep": sweep, "merge": merge, "angle": angle,
                       "stagnationSpeed": stagnation_speed, "maxQuads": max_quads, "separation": separation,
                       "fields": fields}
        return self._surface(given, more)
    # </surface>

    def _surface(self, given: Json, more: Json) -> "Surface":
        twice = [name for name, value in given.items() if value is not None and name in more]
        if twice:
            raise InvalidParameters(f"`{twice[0]}` is given twice", -32602, "invalidParameters", "give it once")
        return Surface(self, self.call("surface.set", **{**given, **more})["surface"])

    def surfaces(self) -> List["Surface"]:
        return [Surface(self, each["surface"]) for each in self.call("surface.list")["surfaces"]]

    def undo(self) -> Json:
        """Takes back the newest edit made with this token outside of any WebSocket: {undone, skipped, undo, redo}."""
        return self.call("history.undo")

    def redo(self) -> Json:
        return self.call("history.redo")

    def set_time(self, time: Optional[float]) -> Json:
        """Sets the clock that everyone in the session shares; None: no time, surfaces are shown at their end."""
        return self.call("time.set", time=_NULL if time is None else time)

    def play(self, **how: Any) -> Json:
        """Lets the clock run; `how` as in `time.play`: speed, loop, from, to."""
        return self.call("time.play", **how)

    def pause(self) -> Json:
        return self.call("time.pause")


class _Record:
    """Something of a session that has an id and a revision."""

    noun = ""

    def __init__(self, session: Session, id: str):
        self.session, self.id = session, id

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.id!r})"

    def record(self) -> Json:
        """As it is now. Error: NotFound."""
        for each in self.session.call(self.noun + ".list")[self.noun + "s"]:
            if each[self.noun] == self.id:
                return each
        raise NotFound(f"there is no {self.noun} {self.id}", -32004, "notFound")

    def delete(self) -> None:
        self.session.call(self.noun + ".delete", **{self.noun: self.id})

    def _change(self, members: Sequence[str], changes: Json, if_rev: Optional[int]) -> Json:
        """Setters take whole records, so that a repeated edit does no harm."""
        record = self.record()
        whole = {name: record[name] for name in members if name in record}
        whole.update(changes)
        return self.session.call(self.noun + ".set", **{self.noun: self.id}, **whole, ifRev=if_rev)


class Rake(_Record):
    """Where particles are released."""

    noun = "rake"

    def set(self, line: Optional[Sequence[Point]] = None, polyline: Optional[Sequence[Point]] = None,
            circle: Optional[Sequence[Point]] = None, points: Optional[Sequence[Point]] = None,
            seeds: Optional[int] = None, name: Optional[str] = None, colour: Optional[str] = None,
            if_rev: Optional[int] = None) -> Json:
        """Changes what is given; the surfaces on it are computed again, unless only name or colour change.
        {rev, clipped, points, surfaces, ...}"""
        given = (("seeds", seeds), ("name", name), ("colour", colour))
        changes: Json = {key: value for key, value in given if value is not None}
        if any(each is not None for each in (line, polyline, circle, points)):
            changes["kind"], changes["points"] = _one_of(line=line, polyline=polyline, circle=circle, points=points)
        return self._change(("kind", "points", "seeds", "name", "colour"), changes, if_rev)

    @property
    def colour(self) -> str:
        """#rrggbb"""
        return str(self.record()["colour"])

    @property
    def points(self) -> np.ndarray:
        """(n, 3), as cut to the domain."""
        return np.array(self.record()["points"], dtype=float)

    @property
    def clipped(self) -> bool:
        return bool(self.record()["clipped"])


class Surface(_Record):
    """A surface that the server keeps up to date with its rake and its parameters."""

    noun = "surface"

    def __init__(self, session: Session, id: str):
        super().__init__(session, id)
        self._kept: Optional[Tuple[str, Mesh]] = None

    def set(self, if_rev: Optional[int] = None, **changes: Any) -> Json:
        """Changes the parameters given, as in `Session.surface`, and computes it again. Where `from_` or `to` change, forward or backward
        follows from them. {rev, epoch, ...}"""
        changes = {_SURFACE_NAMES.get(name, name): value for name, value in changes.items()}
        kept = set(_SURFACE_NAMES.values())
        if changes.keys() & {"from", "to"} and self.record()["direction"] != "both":
            kept.discard("direction")
        return self._change(tuple(kept), changes, if_rev)

    def stats(self) -> Statistics:
        """What the newest state is and took; `complete` says whether it is the final one."""
        return self.session.call("surface.stats", surface=self.id)

    def wait(self, timeout: Optional[float] = None, progress: Optional[Callable[[Statistics], None]] = None) -> Statistics:
        """The statistics, once the surface is complete. `progress` is called with those so far, every second or so.
        Error: WaitTimeout after `timeout` seconds; what computing it failed with."""
        end = None if timeout is None else time.monotonic() + timeout
        slice_ms = 1000 if progress else _LONGEST_WAIT_MS
        while True:
            left = slice_ms if end is None else max(0, min(slice_ms, int(1000 * (end - time.monotonic()))))
            stats = self.session.call("surface.wait", left / 1000 + self.session.client.timeout, surface=self.id,
                                      timeoutMs=left)
            if stats["complete"]:
                return stats
            if progress:
                progress(stats)
            if end is not None and time.monotonic() >= end:
                raise WaitTimeout(f"surface {self.id} is not complete after {timeout} s",
                                  hint="wait again, or ask for less: a larger separation, fewer seeds")

    def download(self, format: str = "ply", timeout: float = 600.0, *, time: Union[float, str, None] = None,
                 draco: bool = True) -> bytes:
        """The whole mesh as the bytes of a .vtp, .glb, .ply, .obj or .drc file, once it is computed: as the session shows
        it, at the time of its clock. `time`: at another time instead, or "end". `draco=False`: a .glb for readers that
        cannot decompress, as ParaView's, some 12 times as large."""
        return self._fetch(format, None, timeout, time, draco)[1]

    def _fetch(self, format: str, tag: Optional[str], timeout: float, time: Union[float, str, None],
               draco: bool = True, lines: Optional[str] = None) -> Tuple[str, bytes]:
        path = "/api/v1/sessions/{}/surfaces/{}/mesh.{}".format(
            *(urllib.parse.quote(word, safe="") for word in (self.session.id, self.id, format)))
        query = {} if time is None else {"time": time if isinstance(time, str) else repr(float(_plain(time, "time")))}
        if not draco:
            query["draco"] = "false"
        if lines:
            query["lines"] = lines
        if query:
            path += "?" + urllib.parse.urlencode(query)
        headers = {"If-None-Match": tag} if tag else {}
        status, reply, body = self.session.client._request(path, None, headers, timeout)
        if status not in (200, 304):
            raise _error(json.loads(body)["error"])
        return reply.get("ETag", ""), body if status == 200 else b""

    def export(self, path: Union[str, "os.PathLike[str]"], timeout: float = 600.0, *,
               time: Union[float, str, None] = None, draco: bool = True) -> None:
        """Writes the mesh to a file, in the format of its extension; nothing half-written is left behind. `time` and
        `draco` as in `download`."""
        path = os.fspath(path)
        extension = os.path.splitext(path)[1]
        if extension.lower() not in _FORMATS:
            raise ValueError(f"{path!r} has no known extension: one of {', '.join(_FORMATS)}")
        body = self.download(extension[1:].lower(), timeout, time=time, draco=draco)
        part = path + ".part"
        try:
            with open(part, "wb") as file:
                file.write(body)
            os.replace(part, path)
        finally:
            if os.path.exists(part):
                os.remove(part)

    def mesh(self, timeout: float = 600.0, *, time: Union[float, str, None] = None) -> "Mesh":
        """The whole mesh as numpy arrays, once it is computed: as the session shows it, at the time of its clock, or at
        `time`, or at its "end". Not fetched again while it is the same."""
        tag, body = self._fetch("vtp", self._kept[0] if self._kept else None, timeout, time)
        if body:
            self._kept = (tag, Mesh.from_vtp(body))
        assert self._kept is not None
        return self._kept[1]

    def lines(self, which: str, count: int = 16, timeout: float = 600.0, *,
              time: Union[float, str, None] = None) -> List[Tuple[float, np.ndarray]]:
        """Lines on the surface at `count` values, evenly spaced: "timelines", or "streamlines", "pathlines" or "streaklines",
        which its kind consists of. Of each, the value (the age of its particles, or the place of their seed on the rake, 0 to
        1) and its points (n, 3); a closed line ends at its first. `time` as in `mesh`."""
        found = Mesh.from_vtp(self._fetch("vtp", None, timeout, time, lines=f"{which}:{count}")[1])
        (values,) = found.arrays.values()
        return [(float(value), found.points[line]) for value, line in zip(values, found.polygons)]

    @property
    def points(self) -> np.ndarray:
        """(n, 3) float64, as computed."""
        return self.mesh().points

    @property
    def polygons(self) -> List[np.ndarray]:
        """Vertices of each cell: 4 corners and the hanging nodes of its sides, in order."""
        return self.mesh().polygons

    def watch(self, name: str = "python", timeout: Optional[float] = 60.0) -> Iterator["Update"]:
        """Every state of the surface from now on, as it reaches the clients: first the present one, then one for each
        change, coarse before final. Yields `Update`s, not meshes; see `Update.mesh`. Joins the session as `name` while it
        runs; close the generator, or leave its loop, to end it. Error: WaitTimeout after `timeout` seconds without
        any; Unreachable."""
        for header, frames, _ in self._updates(name, timeout):
            yield Update(self, bytes=sum(map(len, frames)), **header)

    def live(self, name: str = "python", timeout: Optional[float] = 60.0) -> Iterator["Mesh"]:
        """The same as meshes: each state as it reaches the clients, on the dataset's lattice, with speed, s, t and the
        surface's fields. `Mesh.about` tells epoch, seq, phase, time and whether it is `lossless`. Needs wakesurf_frames.py
        beside this file and the library that it names, which wakesurf's build makes. Cost: some 10 us a vertex that moves.
        Error: as `watch`; ImportError or OSError without those."""
        import wakesurf_frames
        decoder, joined = None, None
        for header, frames, agreed in self._updates(name, timeout):
            if joined is not agreed:
                decoder, joined = wakesurf_frames.MeshDecoder(wakesurf_frames.Draco()), agreed
            for frame in frames:
                state = decoder.fold(frame)
            names = agreed["attributes"]
            if len(names) != len(state.codes):  # an edit has changed the fields
                names = names[:3] + self.record()["fields"]
            connectivity, offsets = state.polygons()
            arrays = {each: state.attribute(i) for i, each in enumerate(names[:len(state.codes)])}
            about = {**{each: header[each] for each in ("epoch", "seq", "phase", "time")}, "lossless": state.header.lossless}
            yield Mesh(state.points(agreed["lattice"]), connectivity, offsets, arrays, about)

    def _updates(self, name: str, timeout: Optional[float]) -> Iterator[Tuple[Json, List[bytes], Json]]:
        """Whole updates: what their header says, their frames, and what was agreed with the subscription."""
        with _Socket(self.session.client, timeout) as socket:
            socket.call("session.join", session=self.session.id, name=name)
            agreed = socket.call("surface.subscribe", surface=self.id)
            frames: List[bytes] = []
            while True:
                frame = socket.frame()
                header = _header(frame)
                if header is None or header.pop("subscription") != agreed["subscription"]:
                    continue
                frames.append(frame)
                if header.pop("last"):
                    socket.notify("frame.ack", subscription=agreed["subscription"], epoch=header["epoch"],
                                  seq=header["seq"])
                    yield header, frames, agreed
                    frames = []

    def _repr_html_(self) -> str:
        stats = self.stats()
        rows = "".join(f"<tr><th>{name}</th><td>{stats[name]}</td></tr>"
                       for name in ("kind", "complete", "quads", "vertices", "separation", "maxEdge"))
        return f"<table><caption>surface {self.id}</caption>{rows}</table>"


@dataclass(frozen=True)
class Update:
    """A state of a surface that has arrived, in `bytes` bytes. `phase` is coarse, refined, final or live; `state_sum` is the
    checksum of what clients show; `time` is the simulation time shown, NaN where the server does not tell."""

    surface: Surface = field(repr=False)
    epoch: int
    seq: int
    phase: str
    vertices: int
    cells: int
    state_sum: int
    time: float
    bytes: int

    def mesh(self) -> "Mesh":
        """The surface's newest final mesh, which may be a later one than this update's."""
        return self.surface.mesh()


@dataclass
class Mesh:
    """A surface as arrays: `points` (n, 3), and cell i's vertices `connectivity[offsets[i]:offsets[i + 1]]`. By name, as
    in `mesh["speed"]`, the arrays at the vertices: s, t, speed, velocity (n, 3), deformation, component, approximated
    and the scalar fields asked for. `about`: kind, dataset, rake, from, to, separation, version; `time` where it is not
    shown at its end."""

    points: np.ndarray
    connectivity: np.ndarray
    offsets: np.ndarray
    arrays: Dict[str, np.ndarray]
    about: Json

    def __getitem__(self, name: str) -> np.ndarray:
        return self.arrays[name]

    def __repr__(self) -> str:
        return f"Mesh({len(self.points)} points, {len(self.offsets) - 1} cells, {', '.join(self.arrays)})"

    @property
    def polygons(self) -> List[np.ndarray]:
        """Vertices of each cell: 4 corners and the hanging nodes of its sides, in order."""
        return np.split(self.connectivity, self.offsets[1:-1]) if len(self.offsets) > 1 else []

    @property
    def quads(self) -> np.ndarray:
        """(m, 4): the cells without hanging nodes."""
        return self._of_size(4)

    def _of_size(self, size: int) -> np.ndarray:
        starts = self.offsets[:-1][np.diff(self.offsets) == size]
        return self.connectivity[starts[:, None] + np.arange(size)]

    def triangles(self) -> np.ndarray:
        """(k, 3): each cell cut into a fan, round the vertex that makes the flattest triangle least flat. Neighbours
        share edges, so no gaps open at hanging nodes."""
        parts = [np.empty((0, 3), dtype=np.int64)]
        for size in np.unique(np.diff(self.offsets)):
            cells = self._of_size(int(size))
            fans = np.stack([np.stack([np.roll(cells, -first, axis=1)[:, [0, k, k + 1]]
                                       for k in range(1, size - 1)], axis=1) for first in range(size)], axis=1)
            best = self._fatness(fans).min(axis=2).argmax(axis=1)
            parts.append(fans[np.arange(len(cells)), best].reshape(-1, 3))
        return np.concatenate(parts)

    def _fatness(self, triangles: np.ndarray) -> np.ndarray:
        a, b, c = (self.points[triangles[..., i]] for i in range(3))
        area = np.linalg.norm(np.cross(b - a, c - a), axis=-1)
        sides = ((b - a) ** 2).sum(-1) + ((c - b) ** 2).sum(-1) + ((a - c) ** 2).sum(-1)
        return area / np.maximum(sides, np.finfo(float).tiny)

    @staticmethod
    def from_vtp(data: bytes) -> "Mesh":
        """Reads the .vtp files wakesurf writes (inline, compressed), also those of the command line."""
        root = xml.etree.ElementTree.fromstring(data)
        if root.get("compressor") != "vtkZLibDataCompressor" or root.get("header_type") != "UInt64":
            raise ValueError("this .vtp was not written by this version of wakesurf: read it with VTK")
        types = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8", "UInt32": "<u4", "UInt8": "u1"}
        arrays: Dict[str, np.ndarray] = {}
        about: Json = {}
        for node in root.iter("DataArray"):
            name, width = node.get("Name", ""), int(node.get("NumberOfComponents", "1"))
            if node.get("format") == "ascii":
                words = (node.text or "").split()
                if node.get("type") == "String":
                    about[name] = bytes(int(word) for word in words[:-1]).decode()
                else:
                    numbers = np.array(words, dtype=float)
                    name = "time" if name == "TimeValue" else name
                    about[name] = numbers.reshape(-1, width) if width > 1 else float(numbers[0])
                continue
            values = np.frombuffer(_inline(node.text or ""), np.dtype(types[node.get("type", "")]))
            arrays[name] = values.reshape(-1, width) if width > 1 else values
        offsets = np.concatenate([[0], arrays.pop("offsets")]).astype(np.int64)
        return Mesh(arrays.pop("Points"), arrays.pop("connectivity"), offsets, arrays, about)


def _inline(text: str) -> bytes:
    """The bytes of an array in a .vtp: how many blocks there are and how long they are, then the blocks."""
    (blocks,) = struct.unpack("<Q", base64.b64decode(text[:12])[:8])
    header_text = (8 * (3 + blocks) + 2) // 3 * 4
    sizes = struct.unpack(f"<{3 + blocks}Q", base64.b64decode(text[:header_text]))[3:]
    packed = memoryview(base64.b64decode(text[header_text:]))
    ends = list(itertools.accumulate(sizes, initial=0))
    return b"".join(zlib.decompress(packed[first:last]) for first, last in zip(ends, ends[1:]))


class _Socket:
    """One WebSocket: calls, and the frames that come meanwhile."""

    def __init__(self, client: Client, timeout: Optional[float]):
        try:
            import websocket
        except ImportError:
            raise ImportError("watch needs the package websocket-client (Debian: python3-websocket)") from None
        self._module, self._timeout = websocket, timeout
        address = client.url.replace("http", "ws", 1) + "/ws"
        headers = ["Authorization: Bearer " + client._token] if client._token else []
        try:
            self._socket = websocket.create_connection(
                address, timeout=timeout, header=headers, subprotocols=["wakesurf.v1"], suppress_origin=True,
                http_no_proxy=["127.0.0.1", "localhost"], sslopt={"context": client._tls} if client._tls else None)
        except websocket.WebSocketBadStatusException as refusal:
            kind = Unauthenticated if refusal.status_code == 401 else WakesurfError
            raise kind(f"the server refused the WebSocket with status {refusal.status_code}") from None
        except (OSError, websocket.WebSocketException) as problem:
            raise Unreachable(f"no WebSocket at {address}: {problem}") from None
        self._ids = itertools.count(1)
        self._frames: List[bytes] = []

    def __enter__(self) -> "_Socket":
        return self

    def __exit__(self, *_: object) -> None:
        self._socket.close()

    def _receive(self) -> Union[str, bytes]:
        try:
            message = self._socket.recv()
        except self._module.WebSocketTimeoutException:
            raise WaitTimeout(f"nothing has come for {self._timeout} s") from None
        except (OSError, self._module.WebSocketException) as problem:
            raise Unreachable(f"the connection broke: {problem}") from None
        if message == "" or message == b"":
            raise Unreachable("the server has closed the connection")
        return message

    def call(self, method: str, /, **parameters: Any) -> Any:
        wanted = next(self._ids)
        self._socket.send(json.dumps({"jsonrpc": "2.0", "id": wanted, "method": method, "params": parameters}))
        while True:
            message = self._receive()
            if isinstance(message, bytes):
                self._frames.append(message)
                continue
            answer = json.loads(message)
            if answer.get("id") == wanted and "method" not in answer:
                if "error" in answer:
                    raise _error(answer["error"])
                return answer["result"]

    def notify(self, method: str, /, **parameters: Any) -> None:
        self._socket.send(json.dumps({"jsonrpc": "2.0", "method": method, "params": parameters}))

    def frame(self) -> bytes:
        """The next one; text messages on the way are notifications no one here listens to."""
        if self._frames:
            return self._frames.pop(0)
        while True:
            message = self._receive()
            if isinstance(message, bytes):
                return message


def _header(frame: bytes) -> Optional[Json]:
    """What a mesh frame says about its update, see Frame in protocol/wire/FORMAT.md; None for what is none."""
    if len(frame) < 48 or frame[:2] != b"WS":
        return None
    if frame[2] != 4:
        raise WakesurfError(f"the server sends mesh frames of version {frame[2]}, this client reads version 4",
                            hint="use the wakesurf.py that came with the server")
    number, epoch, seq, index, count, phase = struct.unpack_from("<3I2HB", frame, 4)
    vertices, cells, when, state_sum = struct.unpack_from("<2IdI", frame, 24)
    return {"subscription": number, "epoch": epoch, "seq": seq,
            "phase": dict(enumerate(("coarse", "refined", "final", "live"))).get(phase, "live"), "vertices": vertices,
            "cells": cells, "state_sum": state_sum, "time": when, "last": index + 1 == count}


def _plain(value: Any, where: str = "") -> Any:
    """Arrays, records and tuples as JSON has them. Error: InvalidParameters for numbers JSON has not, saying `where`."""
    if value is _NULL:
        return None
    if isinstance(value, _Record):
        return value.id
    if isinstance(value, np.ndarray):
        if value.dtype.kind != "f" or np.isfinite(value).all():
            return value.tolist()
        value = value.tolist()
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        raise InvalidParameters(f"`{where}` is {value}, which is no number to compute with", -32602, "invalidParameters",
                                "give a finite number")
    if isinstance(value, Mapping):
        return {name: _plain(each, f"{where}.{name}") for name, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(each, f"{where}[{i}]") for i, each in enumerate(value)]
    return value


def _slices(points: Sequence[Point]) -> Iterator[Sequence[Point]]:
    """Parts that fit into one message each; one empty part of none."""
    first = size = 0
    for i, point in enumerate(points):
        more = len(json.dumps(point)) + 2
        if size + more > _PROBE_BYTES or i - first >= _PROBE_POINTS:
            yield points[first:i]
            first, size = i, 0
        size += more
    yield points[first:]


def _id(record: Union[_Record, str]) -> str:
    return record.id if isinstance(record, _Record) else record


def _one_of(**choices: Optional[Sequence[Point]]) -> Tuple[str, Any]:
    given = [(kind, points) for kind, points in choices.items() if points is not None]
    if len(given) != 1:
        raise ValueError("give one of " + ", ".join(choices))
    return given[0][0], [list(point) for point in given[0][1]]
