"""What the server tells those who listen, as `Session.watch` gives it. Members that are missing are None.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Dict, List, Literal, Optional, TYPE_CHECKING, Type, Union

from ..plain import Json
from ..notification import Notification

if TYPE_CHECKING:
    from .records.shared import Problem
    from .records.dataset import Steps
    from .records.session import Patch
    from .records.presence import Participant
    from .records.subscription import PassSeconds, Statistics, ValueRange


@dataclass(frozen=True)
class ServerNotice(Notification):
    """Something has happened to this connection, its session or the server. Kinds: catchingUp, caughtUp (stale
    updates of a surface are left out until a keyframe comes), notDurable, durableAgain, recordsKeptAside,
    carefulStart (the server died several times in a row shortly after it had started, so surfaces from before are
    not computed by themselves), dataReplaced (the values of a dataset are others now, so its surfaces are computed
    again), sessionDeleted, displaced, removed, linkEnded, loggedOut.
    """

    method: ClassVar[str] = "server.notice"
    kind: str  # a word for programs
    level: Optional[str] = None  # info or warning; may be missing
    text: Optional[str] = None  # a sentence for people; may be missing
    surface: Optional[str] = None  # for catchingUp and caughtUp: id of the surface; may be missing
    subscription: Optional[int] = None  # for catchingUp and caughtUp: number of the subscription; may be missing


@dataclass(frozen=True)
class WorkProgress(Notification):
    """Reports the progress of a call with a `workDoneToken`: begin, at most ten reports a second, and end just
    before the call returns.
    """

    method: ClassVar[str] = "$/progress"
    token: Union[str, int]  # the token of the call
    value: Json  # for a surface it also has phase, epoch, quads and vertices of its newest state


@dataclass(frozen=True)
class DatasetPatched(Notification):
    """A dataset is being imported, or its import has ended. Sent to all clients."""

    method: ClassVar[str] = "dataset.patched"
    dataset: str  # id of the dataset
    name: str  # display name
    state: Literal["ready", "importing", "failed", "stopped", "incomplete"]  # state of the import
    steps: Steps  # numbers of time-steps
    progress: Optional[float] = None  # progress of the import; may be missing
    remaining: Optional[float] = None  # time that the import still needs (s); may be missing
    values: Optional[str] = None  # what the values that are stored are told from others by; left out for a built-in ...
    velocities: Optional[List[str]] = None  # of a dataset that failed because it is not clear which field is the ...
    families: Optional[List[str]] = None  # names of the families of stream surfaces that are kept with its data; ...
    error: Optional[Problem] = None  # why the import failed or ended early; may be missing


@dataclass(frozen=True)
class CachePatched(Notification):
    """Time-steps, or parts of them, have been read into memory or removed from it."""

    method: ClassVar[str] = "cache.patched"
    dataset: str  # id of the dataset
    changes: List[Any]  # the time-steps that changed, each as [index, state]
    held: List[Any]  # the time-steps of which another part is in memory or being read, each as [index, resident, ...
    bytes: int  # memory that the time-steps take (bytes)
    budget: int  # memory that the time-steps may take (bytes)


@dataclass(frozen=True)
class SessionPatched(Notification):
    """Records have changed. Sent to the author of the change as well."""

    method: ClassVar[str] = "session.patched"
    session: str  # id of the session
    seq: int  # `seq` of the session after the change
    patches: List[Patch]  # the changes, in the order in which they can be applied


@dataclass(frozen=True)
class PresencePatched(Notification):
    """Participants have changed. About the recipient it has only a role that a host has set. Sent at most every 50
    ms; with many participants less often, and about some of them at a time.
    """

    method: ClassVar[str] = "presence.patched"
    session: str  # id of the session
    participants: List[Participant]  # the id of each participant and what has changed
    left: List[str]  # ids of participants who have left


@dataclass(frozen=True)
class SurfaceProgress(Notification):
    """A state of a surface is on its way to the subscribers. Not sent while the surface plays."""

    method: ClassVar[str] = "surface.progress"
    surface: str  # id of the surface
    epoch: int  # counts the surfaces that have been built for the record; it never decreases
    phase: Literal["coarse", "refined", "final", "live"]  # coarse, refined, final: the quality of the pass; live: a ...
    seconds: Optional[PassSeconds] = None  # how long it took to make the state; may be missing


@dataclass(frozen=True)
class SurfaceRanges(Notification):
    """The values of a surface range further than before, or it has become another. Sent before the state that does
    so, also while the surface plays.
    """

    method: ClassVar[str] = "surface.ranges"
    surface: str  # id of the surface
    epoch: int  # counts the surfaces that have been built for the record; it never decreases
    ranges: List[ValueRange]  # what the values range over, of all states since the surface began to play: moving ...


@dataclass(frozen=True)
class SurfaceDone(Notification):
    """A surface is complete, or cannot be completed."""

    method: ClassVar[str] = "surface.done"
    surface: str  # id of the surface
    epoch: int  # counts the surfaces that have been built for the record; it never decreases
    stats: Optional[Statistics] = None  # its statistics; present if there is no error; may be missing
    error: Optional[Problem] = None  # why the surface is not complete; may be missing


BY_METHOD: Dict[str, Type[Notification]] = {"server.notice": ServerNotice, "$/progress": WorkProgress,
                                            "dataset.patched": DatasetPatched, "cache.patched": CachePatched,
                                            "session.patched": SessionPatched, "presence.patched": PresencePatched,
                                            "surface.progress": SurfaceProgress, "surface.ranges": SurfaceRanges,
                                            "surface.done": SurfaceDone}

__all__ = ["BY_METHOD", "ServerNotice", "WorkProgress", "DatasetPatched", "CachePatched", "SessionPatched",
           "PresencePatched", "SurfaceProgress", "SurfaceRanges", "SurfaceDone"]
