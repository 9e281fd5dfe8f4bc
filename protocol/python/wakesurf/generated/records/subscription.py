"""Looking at surfaces: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, Literal, TYPE_CHECKING, TypedDict

if TYPE_CHECKING:
    from .shared import Lattice, Problem


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

    reason: Literal["inBody", "outsideCells", "atRest", "notFinite", "sameRakes", "noArea", "nothingYet", "allLeft", "tooCoarse", "outsideRange"]
    message: str  # the reason, for people
    hint: str  # what to do about it


Statistics = TypedDict("Statistics", {  # Statistics of the newest state of a surface, in the shape of `wakesurf surface --stats`.
    "surface": "str",  # id of the surface
    "epoch": "int",  # counts the surfaces that have been built for the record; it never decreases
    "complete": "bool",  # true: this is the final surface of its epoch
    "kind": 'Literal["stream", "path", "streak", "time", "level"]',  # stream: streamlines of the field frozen at ...
    "quads": "int",  # number of quads
    "vertices": "int",  # number of vertices
    "steps": "int",  # number of steps of the surface, in time or along its curves
    "vertexSteps": "int",  # number of steps of the integrator, for all particles together
    "approximated": "int",  # number of vertices that were interpolated, not traced from the rake
    "error99": "float",  # 99 % of the vertices that are not `uncertain` are estimated to be no farther than this ...
    "uncertain": "int",  # number of vertices that may be farther than the separation from the surface as it truly ...
    "terminated": "Terminations",  # numbers of particles from the rake's seeds, by what ended them; of streak and ...
    "torn": "int",  # number of cells that have been deleted amid living particles, which went apart or came ...
    "maxEdge": "float",  # length of the longest edge (the dataset's unit of length)
    "separation": "float",  # longest edge allowed in the end (the dataset's unit of length)
    "requestedSeparation": "float",  # longest edge that was asked for (the dataset's unit of length)
    "coarsened": "bool",  # true: within `maxQuads` the separation asked for is not possible, so `separation` is ...
    "seconds": "BuildSeconds",  # how long it took to build the surface
    "pass": "PassSeconds",  # how long it took to make this state; may be missing
    "peakBytes": "int",  # the most memory that the process has held, for everything that it does (bytes)
    "dataEnd": "float",  # first time of the data, where it cuts the backward side of a path surface of both ...
    "fieldRange": "List[float]",  # of a level surface: what its field ranges over at the time that is shown; may be ...
    "stopped": "str",  # why the surface ends early; may be missing
    "empty": "Emptiness",  # why there is nothing to see; left out where there is something; may be missing
    "stateSum": "int",  # checksum of what clients show, as in the frames (protocol/wire/FORMAT.md, State sum)
    "error": "Problem",  # why the surface is not complete; may be missing
}, total=False)


class ValueRange(TypedDict, total=False):
    """What the values of an attribute range over, for colours."""

    attribute: str  # name of the attribute, as in the frames; `t` stands for the age: of a streak surface the time ...
    low: float  # lower end, without the last per cent of the surface's area where there are values below zero and ...
    high: float  # upper end, without the last per cent of the surface's area where it would take more than a fifth ...
    least: float  # the least of all values
    greatest: float  # the greatest of all values


class SurfaceSubscribeResult(TypedDict, total=False):
    """What surface.subscribe answers."""

    subscription: int  # number of the subscription, as in the frames' headers
    lattice: Lattice  # lattice of the frames
    attributes: List[str]  # names of the vertices' attributes, in the frames' order
    epoch: int  # counts the surfaces that have been built for the record; it never decreases
    resumed: bool  # true: the updates after `from` follow, and no keyframe
    ranges: List[ValueRange]  # what the values range over, of all states since the surface began to play: moving ...
