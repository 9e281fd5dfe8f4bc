"""A surface of a session in another program: the program's rake moves the session's, and gets the session's surface.

The plugin for ParaView is made of it (python/paraview); nothing here knows ParaView.
"""
from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Tuple

from .client import Client
from .errors import InvalidParameters
from .mesh import Mesh
from .plain import Json
from .session import Kind
from .surface import Surface

Place = Tuple[float, float, float]
Line = Tuple[Place, Place]


class Link:
    """Links one surface of the session in `url`, and its rake: the one with the id `surface`, or a new one, as the
    server suggests it. A request is not repeated, so that changes by others in the session stay.

    >>> link = wakesurf.link.Link(url, kind="path")
    >>> link.move(((0.4, 0.4, 0.1), (0.6, 0.6, 0.1)))
    >>> link.change({"from_": 0.0, "to": 2.0, "separation": 0.1})
    >>> link.mesh(1.0).about["time"]
    1.0
    """

    def __init__(self, url: str = "", session: str = "", surface: str = "", dataset: str = "", kind: Kind = "streak") -> None:
        self.session = Client(url or None).session(session or None)
        self.surface = Surface(self.session, surface) if surface else self.session.suggested(kind, dataset or None)
        rake = self.surface.record().get("rake")  # Error: NotFound
        if rake is None:
            raise InvalidParameters(f"surface {self.surface.id} has no rake to move", -32602, "invalidParameters", "link one that particles form")
        self.rake = next(each for each in self.session.rakes() if each.id == rake)
        self._sent: Dict[str, Any] = {}
        self._seen: Optional[Tuple[Any, ...]] = None

    def line(self) -> Line:
        """Returns the rake's first and last point, as the session has them now."""
        points: List[List[float]] = self.rake.points.tolist()
        first, last = points[0], points[-1]
        return (first[0], first[1], first[2]), (last[0], last[1], last[2])

    def move(self, line: Line) -> None:
        """Moves the rake of the session, for everyone. Error: InvalidParameters, OutsideDomain, ..."""
        if self._sent.get("line") == line:
            return
        if line[0] == line[1]:
            raise InvalidParameters("both ends of the rake are at one place", -32602, "invalidParameters", "pull them apart")
        self.rake.set(line=line)
        self._sent["line"] = line

    def change(self, parameters: Mapping[str, Any]) -> None:
        """Changes parameters of `Surface.set`, for everyone. Error: as `Surface.set`."""
        new = {name: value for name, value in parameters.items() if name not in self._sent or self._sent[name] != value}
        if new:
            self.surface.set(**new)
            self._sent.update(new)

    def steps(self) -> List[float]:
        """Returns the times to ask for: those of the data while there is a surface, its first and its last. None if
        it is the same at all times, like a stream surface."""
        record = self.surface.record()
        if record["kind"] == "stream":
            return []
        first, last = _span(record)
        times = self.session.client.describe(record["dataset"])["times"]
        return sorted({first, last, *(time for time in times if first <= time <= last)})

    def mesh(self, time: Optional[float] = None) -> Mesh:
        """Returns the complete surface: at a time, or the nearest one at which there is one; left out, at its end.
        The session's clock is not changed. Error: that of computing the surface."""
        record = self._observe()
        if time is None or record["kind"] == "stream":
            return self.surface.mesh(time="end")
        first, last = _span(record)
        return self.surface.mesh(time=min(max(time, first), last))

    def changed(self) -> bool:
        """Whether any client, this link included, has changed the surface or its rake since `mesh` was called."""
        before = self._seen
        self._observe()
        after, self._seen = self._seen, before
        return before is not None and before != after

    def _observe(self) -> Json:
        record = self.surface.record()
        self._seen = (record["rev"], record.get("rake"), self.rake.record()["rev"])
        return record


def _span(record: Json) -> Tuple[float, float]:
    first, last = sorted((record["from"], record["to"]))
    return first, last
