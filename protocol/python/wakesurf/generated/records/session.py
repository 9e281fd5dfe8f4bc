"""Sessions: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Any, List, Literal, TYPE_CHECKING, TypedDict

from ...plain import Json

if TYPE_CHECKING:
    from .presence import Participant
    from .rake import RakeRecord
    from .surface import SurfaceRecord
    from .bookmark import BookmarkRecord
    from .annotation import AnnotationRecord
    from .time import ClockRecord


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

    wakesurfSession: Literal[1]  # version of the format
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

    op: Literal["put", "delete"]  # what happened to the record
    type: Literal["rake", "surface", "bookmark", "annotation", "clock", "session"]  # kind of record
    id: str  # id of the record
    record: Any  # for put: the record as it is now; may be missing


class Joined(TypedDict, total=False):
    """What session.join returns: either `snapshot` or `patches`."""

    you: str  # your id as a participant
    role: Literal["viewer", "editor", "host"]  # your role in the session
    resumeToken: str  # token with which you can come back; if it differs from the one you sent, nothing from before ...
    seq: int  # `seq` of the session now
    participants: List[Participant]  # all participants
    created: str  # when the session was made, in UTC, as in session.list; may be missing
    copyOf: SessionName  # for a session that session.fork has made: the one it is a copy of, with the name it had ...
    resumed: bool  # true: `patches` is present; false: `snapshot` is present
    snapshot: Snapshot  # all records of the session; may be missing
    patches: List[Patch]  # what changed after `lastSeq`; for each record only the newest change; may be missing


class SessionForkResult(TypedDict, total=False):
    """What session.fork answers."""

    session: str  # id of the session
    name: str  # display name
    remaining: int  # how many more sessions can be made
    key: str  # with a share link: secret key of a link into the copy; it is returned only this once; may be missing
    link: str  # with a share link: what to append to the address of the page; may be missing


class SessionListResult(TypedDict, total=False):
    """What session.list answers."""

    sessions: List[SessionEntry]  # all sessions
    limit: int  # how many sessions the server keeps
    trashLimit: int  # how many deleted sessions the server keeps


class SessionStateResult(TypedDict, total=False):
    """What session.state answers."""

    session: str  # id of the session
    name: str  # display name
    units: Units  # left out if no one has typed any; may be missing
    rakes: List[RakeRecord]  # all rakes
    surfaces: List[SurfaceRecord]  # all surfaces
    bookmarks: List[BookmarkRecord]  # all bookmarks
    annotations: List[AnnotationRecord]  # all annotations
    clock: ClockRecord  # the session's clock
    keptAside: KeptAside  # records that are kept aside, if there are any; may be missing
    seq: int  # `seq` of the session now
    participants: List[Participant]  # all participants


class SessionDeleteResult(TypedDict, total=False):
    """What session.delete answers."""

    session: str  # id of the session
    deletedUntil: str  # until when the session can be restored, in UTC; may be missing


class SessionExportResult(TypedDict, total=False):
    """What session.export answers."""

    file: SessionFile  # the session as a document


class SessionImportResult(TypedDict, total=False):
    """What session.import answers."""

    session: str  # id of the session
    name: str  # display name
    remaining: int  # how many more sessions can be made
    notes: List[str]  # for people: which datasets this server does not have, or which differ here
