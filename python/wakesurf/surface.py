"""A surface of a session: beginning and changing it, waiting for it, fetching its mesh, following it live."""
from __future__ import annotations

import json
import os
import time as clock
import urllib.parse
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union, cast

from .api_base import Notification
from .connection import Connection
from .errors import InvalidParameters, WaitTimeout, WakesurfError
from .frames import MeshDecoder, header_of
from .generated.notifications import WorkProgress
from .generated.records import Statistics, SurfaceSetResult, SurfaceSubscribeResult
from .generated.surfaces import SETTABLE, SurfaceChanger
from .files import write_whole
from .mesh import Array, Mesh
from .name_mapping import error_of
from .numbers import Numbers, Times, query_of
from .plain import Json, plain
from .progress import ProgressTarget, Report
from .record import Record

if TYPE_CHECKING:
    from .session import Session

_LONGEST_WAIT_MS = 60_000
_FORMATS = (".vtp", ".glb", ".ply", ".obj", ".drc")


class Surface(SurfaceChanger, Record):
    """A surface that the server keeps up to date with its rake and its parameters. In a `with` it is deleted at the end.

    >>> with session.surface(rake, "path", dataset="tornado", to=1, separation=0.1) as surface:
    ...     surface.mesh().about["kind"]
    'path'
    """

    noun = "surface"

    def __init__(self, session: Session, id: str) -> None:
        super().__init__(session, id)
        self._fetched: Optional[Tuple[str, Mesh]] = None

    def _changed(self, changes: Json, if_rev: Optional[int]) -> SurfaceSetResult:
        changes = {name: value for name, value in changes.items() if value is not None}
        resent = set(SETTABLE)
        if changes.keys() & {"from", "to"} and self.record()["direction"] != "both":
            resent.discard("direction")
        result: SurfaceSetResult = self._change(tuple(resent), changes, if_rev)
        return result

    def stats(self) -> Statistics:
        """Returns the statistics of the newest state; `complete` says whether it is the final one."""
        return self.session.api.surface.stats(surface=self.id)

    def wait(self, timeout: Optional[float] = None, progress: Optional[ProgressTarget] = None,
             checked: bool = False) -> Statistics:
        """Returns the statistics, once the surface is complete. `progress`: a function that receives `Progress`, or a
        bar of tqdm, see progress.py. `checked`: once its error between stored times is estimated and its `twin`
        compared, too. Error: WaitTimeout after `timeout` seconds; that of computing it.

        >>> shares = []
        >>> surface.wait(progress=lambda progress: shares.append(progress.share))["complete"], shares[-1]
        (True, 1.0)
        """
        end = None if timeout is None else clock.monotonic() + timeout
        report = Report.to(progress)
        with _Waiting(self.session, report) as waiting:
            while True:
                left = waiting.slice_ms if end is None else max(0, min(waiting.slice_ms, int(1000 * (end - clock.monotonic()))))
                stats = waiting.ask(self.id, left, checked)
                if stats["complete"] and not (checked and stats.get("intervalPending")):
                    report.done("complete", stats)
                    return stats
                report.state(stats)
                if end is not None and clock.monotonic() >= end:
                    raise WaitTimeout(f"surface {self.id} is not complete after {timeout} s",
                                      hint="wait again, or ask for less: a larger separation, fewer seeds")

    def stop(self) -> bool:
        """Stops computing, for everyone; the newest state stays. Returns False if nothing was being computed."""
        return self.session.api.surface.stop(surface=self.id)["stopped"]

    def download(self, format: str = "ply", timeout: float = 600.0, *, time: Union[float, str, None] = None,
                 draco: bool = True, lines: Optional[str] = None, tessellate: int = 1) -> bytes:
        """Returns the whole mesh as the bytes of a .vtp, .glb, .ply, .obj or .drc file, once it is computed: as the
        session shows it, at the time of its clock. `time`: at another time instead, or "end". `draco=False`: a .glb
        for readers that cannot decompress, as ParaView's, some 12 times as large. `lines`, such as "timelines:8" or
        "arrows:every=0.5,width=0.1": those instead of the mesh, see `lines`; not as .drc. "points": the vertices with
        normal and radius, as .ply alone. `tessellate`: each cell cut
        into so many quads each way, on a curved patch that is as exact as the vertices."""
        return self._fetch(format, None, timeout, time, draco, lines, tessellate)[1]

    def _fetch(self, format: str, tag: Optional[str], timeout: float, time: Union[float, str, None],
               draco: bool = True, lines: Optional[str] = None, tessellate: int = 1) -> Tuple[str, bytes]:
        query = {} if time is None else {"time": time if isinstance(time, str) else repr(float(plain(time, "time")))}
        if not draco:
            query["draco"] = "false"
        if lines:
            query["lines"] = lines
        if tessellate != 1:
            query["tessellate"] = str(int(plain(tessellate, "tessellate")))
        return self._file(f"mesh.{format}", query, tag, timeout)

    def _file(self, name: str, query: Mapping[str, str], tag: Optional[str], timeout: float) -> Tuple[str, bytes]:
        path = "/api/v1/sessions/{}/surfaces/{}/{}".format(
            *(urllib.parse.quote(word, safe="") for word in (self.session.id, self.id, name)))
        if query:
            path += "?" + urllib.parse.urlencode(query)
        headers = {"If-None-Match": tag} if tag else {}
        status, reply, body = self.session.client._request(path, None, headers, timeout)
        if status not in (200, 304):
            raise error_of(json.loads(body)["error"])
        return reply.get("ETag", ""), body if status == 200 else b""

    def numbers(self, times: Optional[Times] = None, through: Optional[str] = None, timeout: float = 600.0, *,
                time: Union[float, str, None] = None, fields: Sequence[str] = ()) -> Numbers:
        """Returns area, flux and more, each with its errors, see numbers.py: as the session shows the surface, at another
        `time` or at the "end", or at `times` (first, last, every), of a stream surface `from` plus the age. `through`: a
        plane or a box of numbers.py, for ages there and what is inside. `fields`: whose means over it are wanted.

        >>> numbers = surface.numbers(through=wakesurf.numbers.box((0, 0, 0), (1, 1, 1)))
        >>> 0 < numbers["area_error"][0] < numbers["area"][0] >= numbers["inside_area"][0]
        True
        """
        return Numbers.from_csv(self._numbers_text(query_of(times, through, time, fields), timeout))

    def _numbers_text(self, query: Mapping[str, str], timeout: float) -> str:
        return self._file("numbers.csv", query, None, timeout)[1].decode()

    def export(self, path: Union[str, os.PathLike[str]], timeout: float = 600.0, *,
               time: Union[float, str, None] = None, draco: bool = True, lines: Optional[str] = None,
               tessellate: int = 1) -> None:
        """Writes the mesh to a file, in the format of its extension; nothing half-written is left behind. `time`,
        `draco`, `lines` and `tessellate` as in `download`."""
        path = os.fsdecode(path)
        extension = os.path.splitext(path)[1]
        if extension.lower() not in _FORMATS:
            raise ValueError(f"{path!r} has no known extension: one of {', '.join(_FORMATS)}")
        body = self.download(extension[1:].lower(), timeout, time=time, draco=draco, lines=lines,
                             tessellate=tessellate)
        write_whole(path, [body])

    def mesh(self, timeout: float = 600.0, *, time: Union[float, str, None] = None, tessellate: int = 1) -> Mesh:
        """Returns the whole mesh as numpy arrays, once it is computed: as the session shows it, at the time of its
        clock, or at `time`, or at its "end". `tessellate` as in `download`. Not fetched again while it is the same."""
        tag, body = self._fetch("vtp", self._fetched[0] if self._fetched else None, timeout, time, tessellate=tessellate)
        if body:
            self._fetched = (tag, Mesh.from_vtp(body))
        assert self._fetched is not None
        return self._fetched[1]

    def lines(self, which: str, count: int = 16, timeout: float = 600.0, *, every: Optional[float] = None,
              width: Optional[float] = None, time: Union[float, str, None] = None) -> List[Tuple[float, Array]]:
        """Returns lines on the surface at `count` values, evenly spaced: "timelines", or "streamlines", "pathlines"
        or "streaklines", which its kind consists of. With `every` they are so far apart on the surface instead.
        "timeribbons", "streamribbons" and so on, and "arrows", are `width` wide polygons that lie in it; arrows take
        `every`. Each line or polygon has a value (the age of its particles, or the place of their seed on the rake, 0
        to 1) and points (n, 3); a closed line ends at its first. `time` as in `mesh`."""
        measures = str(count) if every is None else f"every={every!r}"
        if width is not None:
            measures += f",width={width!r}"
        found = Mesh.from_vtp(self._fetch("vtp", None, timeout, time, lines=f"{which}:{measures}")[1])
        (values,) = found.arrays.values()
        return [(float(value), found.points[line]) for value, line in zip(values, found.polygons)]

    @property
    def points(self) -> Array:
        """Returns (n, 3) float64, as computed."""
        return self.mesh().points

    @property
    def polygons(self) -> List[Array]:
        """Returns the vertices of each cell: 4 corners and the hanging nodes of its sides, in order."""
        return self.mesh().polygons

    def watch(self, name: str = "python", timeout: Optional[float] = 60.0) -> Iterator[Update]:
        """Yields every state of the surface from now on, as it reaches the clients: first the present one, then one
        for each change, coarse before final. Yields `Update`s, not meshes; see `Update.mesh`. Joins the session as
        `name` while it runs; close the generator, or leave its loop, to end it. Error: WaitTimeout after `timeout`
        seconds without any; Unreachable."""
        for header, frames, _ in self._updates(name, timeout):
            yield Update(self, bytes=sum(map(len, frames)), **header)

    def live(self, name: str = "python", timeout: Optional[float] = 60.0) -> Iterator[Mesh]:
        """Yields states as meshes: each as it reaches the clients, on the dataset's lattice, with speed, s, t and the
        surface's fields. `Mesh.about` has epoch, seq, phase, time and whether it is `lossless`. Needs the library
        libwakesurf_frames, which wakesurf's build makes (see frames.py). Cost: some 0.25 us a vertex. Error: as
        `watch`; ImportError or OSError without those."""
        decoder = MeshDecoder()
        for header, frames, agreed in self._updates(name, timeout):
            state = [decoder.fold(frame) for frame in frames][-1]
            assert state is not None
            names = agreed["attributes"]
            if len(names) != len(state.attributes):  # an edit has changed the fields
                names = names[:3] + self.record()["fields"]
            connectivity, offsets = state.polygons()
            arrays = dict(zip(names, state.attributes))
            about = {**{name: header[name] for name in ("epoch", "seq", "phase", "time")}, "lossless": state.lossless}
            yield Mesh(state.points(agreed["lattice"]), connectivity, offsets, arrays, about)

    def _updates(self, name: str, timeout: Optional[float]) -> Iterator[Tuple[Json, List[bytes], SurfaceSubscribeResult]]:
        """Yields whole updates: the header, the frames, and the parameters of the subscription."""
        with self.session.connect(name, timeout) as connection:
            agreed = connection.api.surface.subscribe(surface=self.id)
            frames: List[bytes] = []
            while True:
                frame = connection.frame()
                header = header_of(frame)
                if header is None or header.pop("subscription") != agreed["subscription"]:
                    continue
                frames.append(frame)
                if header.pop("last"):
                    connection.notify("frame.ack", subscription=agreed["subscription"], epoch=header["epoch"],
                                      seq=header["seq"])
                    yield header, frames, agreed
                    frames = []

    # For others: the mesh as their objects.

    def to_vtk(self) -> Any:
        """Converts the mesh; see `Mesh.to_vtk`."""
        return self.mesh().to_vtk()

    def to_pyvista(self) -> Any:
        """Converts the mesh; see `Mesh.to_pyvista`."""
        return self.mesh().to_pyvista()

    def to_meshio(self) -> Any:
        """Converts the mesh; see `Mesh.to_meshio`."""
        return self.mesh().to_meshio()

    def to_dataframe(self) -> Any:
        """Converts the mesh; see `Mesh.to_dataframe`."""
        return self.mesh().to_dataframe()

    def _repr_html_(self) -> str:
        stats: Mapping[str, Any] = self.stats()
        rows = "".join(f"<tr><th>{name}</th><td>{stats[name]}</td></tr>"
                       for name in ("kind", "complete", "quads", "vertices", "separation", "maxEdge"))
        return f"<table><caption>surface {self.id}</caption>{rows}</table>"


@dataclass(frozen=True)
class Update:
    """A state of a surface that has arrived, in `bytes` bytes. `phase` is coarse, refined, final or live;
    `state_sum` is the checksum of what clients show; `time` is the simulation time shown, NaN if the server does not
    report it."""

    surface: Surface = field(repr=False)
    epoch: int
    seq: int
    phase: str
    vertices: int
    cells: int
    state_sum: int
    time: float
    bytes: int

    def mesh(self) -> Mesh:
        """Returns the surface's newest final mesh, which may be a later one than this update's."""
        return self.surface.mesh()


class _Waiting:
    """Asks for a surface until it is complete. If progress is wanted, over a WebSocket, which reports shares; if that
    fails, over HTTP once a second."""

    def __init__(self, session: Session, report: Report) -> None:
        self._session, self._report = session, report
        self._connection: Optional[Connection] = None
        self.slice_ms = 1000 if report.wanted else _LONGEST_WAIT_MS

    def __enter__(self) -> _Waiting:
        if self._report.wanted:
            try:
                self._connection = Connection(self._session.client, None)
            except ImportError:
                pass
        return self

    def __exit__(self, *_: object) -> None:
        if self._connection is not None:
            self._connection.close()

    def ask(self, surface: str, wait_ms: int, checked: bool) -> Statistics:
        """Returns the answer of `surface.wait`."""
        if self._connection is None:
            stats: Statistics = self._session.call("surface.wait", wait_ms / 1000 + self._session.client.timeout, surface=surface,
                                                   timeoutMs=wait_ms, checked=checked)
            return stats
        number = self._connection.start("surface.wait", session=self._session.id, surface=surface, timeoutMs=wait_ms,
                                        checked=checked, workDoneToken="wait")
        while True:
            answer = self._connection.answer_or_notification(number)
            if not isinstance(answer, Notification):
                return cast(Statistics, answer["result"])
            if isinstance(answer, WorkProgress) and answer.value.get("kind") == "report":
                share = answer.value.get("percentage")
                self._report.share(None if share is None else share / 100, str(answer.value.get("message", "")))


def begin(session: Session, dataset: str, setting: Json) -> Surface:
    """Makes a surface of which only the kind must be given: the server suggests the other parameters for the data. `setting`: parameters
    of surface.set by their names in Python, but `from`. Error: as Session.surface."""
    complete = setting["kind"] == "level" or {"rake", "to", "separation"} <= setting.keys()
    found: Mapping[str, Any] = {"surfaces": []} if complete else session.client.suggest(dataset)
    usual: Dict[str, Any] = dict(next((each for each in found["surfaces"] if each["kind"] == setting["kind"]), {}))
    if setting.keys() & {"from", "to", "direction"}:
        usual = {name: value for name, value in usual.items() if name not in ("from", "to")}
    if setting.keys() & {"sweep", "rake2"}:
        usual.pop("sweep", None)
    merged: Json = {**usual, **setting, "dataset": dataset}
    if "to" not in merged:
        merged["to"] = last_time(session, merged)
    merged.pop("rake", None)
    made = session.api.rake.set(**found["rake"])["rake"] if "rake" not in setting and setting["kind"] != "level" else None
    rake = setting.get("rake", made)
    try:
        return session.surface(rake, **{"from_" if name == "from" else name: value for name, value in merged.items()})
    except WakesurfError:
        if made is not None:
            session.api.rake.delete(rake=made)  # nobody asked for it alone
        raise


def last_time(session: Session, setting: Json) -> float:
    """Returns the last time of the data, or the first for a surface that goes backward. A flow of one time stands still:
    as long after it, or before it, as a suggested surface of that kind takes."""
    times = session.client.describe(setting["dataset"])["times"]
    if not times:
        raise InvalidParameters("a surface of this dataset needs `to`", -32602, "invalidParameters", "the time at which it ends")
    backward = setting.get("direction") == "backward"
    if len(times) == 1 and setting["kind"] != "level":
        found: Any = session.client.suggest(setting["dataset"])["surfaces"]
        length = next((each["to"] - each["from"] for each in found if each["kind"] == setting["kind"]), 1.0)
        return float(setting.get("from", times[0]) + (-length if backward else length))
    return float(times[0] if backward else times[-1])
