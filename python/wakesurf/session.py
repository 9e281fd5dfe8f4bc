"""A session: rakes and surfaces that several people and scripts edit together; and parameter studies, each in a session of its own."""
from __future__ import annotations

import functools
import html
import itertools
import json
import os
import urllib.parse
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, AsyncIterator, Dict, Generator, Iterator, List, Literal, Mapping, Optional, Sequence, Tuple, Union

from .api_base import LEFT_OUT, LeftOut, Notification
from .connection import Connection, watch, watch_async
from .errors import InvalidParameters, NotFound, UnknownParameter
from .generated.methods import Methods
from .generated.records import ClockAnswer, HistoryRedoResult, HistoryUndoResult, SessionStateResult, Statistics
from .generated.surfaces import SurfaceMaker
from .mesh import Mesh
from .names import Helpful, named
from .name_mapping import error_of
from .numbers import Share, shares
from .plain import HasId, Json, Points
from .progress import ProgressTarget, Report
from .record import Rake, one_of, warn_of_cut
from .surface import Surface

if TYPE_CHECKING:
    from .client import Client
    from .notebook import Shown
    from .picture import Painter, Picture
    from .view import Look

Role = Literal["viewer", "editor", "host"]
Kind = Literal["stream", "path", "streak", "time"]
Background = Literal["shown", "white", "clear"]
_OF_RAKE = ("line", "polyline", "circle", "points", "seeds")


class Session(SurfaceMaker[Surface], HasId, Helpful):
    """A session: rakes and surfaces that several people and scripts edit together. All see edits at once. `api` has
    every method of the server, in this session.

    >>> session.api.bookmark.set(name="here", view={})["bookmark"]
    'b1'
    >>> session.set_tme(1)
    Traceback (most recent call last):
    AttributeError: Session has no `set_tme`: did you mean `set_time`?
    """

    def __init__(self, client: Client, id: str, about: Optional[Mapping[str, Any]] = None) -> None:
        self.client, self.id = client, id
        self.about: Json = dict(about or {})  # what the call answered that gave this object: see session.list
        self.api = Methods(client.call, id)

    def __repr__(self) -> str:
        return f"Session({self.id!r})"

    def call(self, method: str, _timeout: Optional[float] = None, /, **parameters: Any) -> Any:
        """Calls any method on this session's records."""
        return self.client.call(method, _timeout, **{"session": self.id, **parameters})

    @property
    def dataset(self) -> str:
        """Returns the id of the dataset, if the server has only one, as after `serve("case.foam")`."""
        return self.client.dataset

    def state(self) -> SessionStateResult:
        """Returns every record, and the participants."""
        return self.api.session.state()

    def rename(self, name: str) -> None:
        """Renames the session, for everyone."""
        self.about.update(self.api.session.rename(name=name))

    def delete(self, forever: bool = False) -> None:
        """Moves the session to the trash, where it can be restored for 30 days (`about["deletedUntil"]`); `forever`:
        deletes it from the trash for good. `main` cannot be deleted. Error: NotFound, NotPermitted."""
        self.about.update(self.api.session.delete(forever=forever or None))

    def discard(self) -> None:
        """Deletes the session for good, past the trash. Does nothing if it is gone already. The maker of a copy by a
        share link can delete it so, as long as it has not been edited by others."""
        for forever in (False, True):
            try:
                if "deletedUntil" not in self.api.session.delete(session=self.id, forever=forever or None):
                    return
            except NotFound:
                pass

    def restore(self) -> None:
        """Restores the session from the trash. Error: NotFound, OverLimit."""
        self.about.update(self.api.session.restore())

    def export(self, path: Union[str, os.PathLike[str]]) -> str:
        """Writes the session as one file: records, notes, views, and the names and fingerprints of its datasets.
        `Client.import_session` makes a session of it again. Returns the path."""
        status, _, body = self.client._request(f"/api/v1/sessions/{urllib.parse.quote(self.id, safe='')}/session.json")
        if status != 200:
            raise error_of(json.loads(body)["error"])
        with open(path, "wb") as file:
            file.write(body)
        return os.fspath(path)

    def thumbnail(self) -> Optional[bytes]:
        """Returns the picture (PNG, JPEG or WebP) that a page sent of it; None without one."""
        status, _, body = self.client._request(f"/api/v1/sessions/{urllib.parse.quote(self.id, safe='')}/thumbnail")
        if status == 200:
            return body
        problem = error_of(json.loads(body)["error"])
        if isinstance(problem, NotFound) and self.state():
            return None
        raise problem

    def fork(self, name: str = "") -> Session:
        """Makes a new session with copies of the records. A client that came by a share link, of any role, is an
        editor in it."""
        made = self.api.session.fork(name=name)
        key = made.get("key")
        client = self.client if key is None else type(self.client)(self.client.url, key, self.client.timeout, self.client._tls)
        return Session(client, made["session"])

    @named
    def share(self, role: Role = "viewer", expires_in: Union[int, None, LeftOut] = LEFT_OUT) -> str:
        """Returns the address that lets others into this session, as viewer, editor or host, for `expires_in`
        seconds; None: until it is revoked; left out: a week, or as long as the link you came by. Anyone who has it is
        in: treat it as a password."""
        return self.client.url + "/" + self.api.session.share(role=role, expires_in=expires_in)["link"]

    @named
    def rake(self, line: Optional[Points] = None, polyline: Optional[Points] = None, circle: Optional[Points] = None,
             points: Optional[Points] = None, seeds: int = 32, name: str = "", colour: Optional[str] = None) -> Rake:
        """Makes a rake; give one of `line` (2 points), `polyline` (2 or more), `circle` (centre and two points of the
        rim) and `points`. The part outside of the domain is cut away, with a warning; see `Rake.clipped`. `colour` is "#rrggbb";
        without, it gets one that few others have.

        >>> rake = session.rake(line=[(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)], seeds=24)
        >>> rake.points.shape, rake.clipped
        ((2, 3), False)
        """
        kind, where = one_of(line=line, polyline=polyline, circle=circle, points=points)
        made = self.api.rake.set(kind=kind, points=where, seeds=seeds, name=name, colour=colour)
        warn_of_cut(kind, where, made)
        return Rake(self, made["rake"])

    def rakes(self) -> List[Rake]:
        """Returns all rakes."""
        return [Rake(self, each["rake"]) for each in self.api.rake.list()["rakes"]]

    def _made(self, given: Json) -> Surface:
        return Surface(self, self.call("surface.set", **given)["surface"])

    @named
    def suggested(self, kind: Optional[Kind] = None, dataset: Optional[str] = None) -> Surface:
        """Makes a surface to begin with, on a rake of its own, as the server suggests them for this dataset.

        >>> session.suggested("streak").wait()["kind"]
        'streak'
        """
        dataset = dataset or self.dataset
        found = self.client.suggest(dataset)
        kinds = {each["kind"]: each for each in found["surfaces"]}
        if not kinds or kind is not None and kind not in kinds:
            raise InvalidParameters(f"the server suggests no {kind or ''} surface here", -32602, "invalidParameters", found["why"])
        setting = dict(kinds[kind] if kind is not None else found["surfaces"][0])
        rake = self.api.rake.set(**found["rake"])["rake"]
        return self._made({"rake": rake, "dataset": dataset, **setting})

    def isosurface(self, field: str, level: float, dataset: Optional[str] = None, **more: Any) -> Surface:
        """Makes a surface where `field` has the value `level`, at the time that is shown; no rake is needed. `more`: as
        `surface` takes it, such as `fields`. Data only, not flows that are formulas. Error: Unsupported, NotFound."""
        from .surface import begin
        given = {"from" if name == "from_" else name: value for name, value in more.items()}
        return begin(self, dataset or self.dataset, {"kind": "level", "field": field, "level": level, **given})

    def surfaces(self) -> List[Surface]:
        """Returns all surfaces."""
        return [Surface(self, each["surface"]) for each in self.api.surface.list()["surfaces"]]

    def shares(self, surfaces: Sequence[Surface], through: str, by: str = "inside_area", *,
               time: Union[float, str, None] = None, timeout: float = 600.0) -> Dict[str, Share]:
        """Returns by id what share each of several surfaces has of what is in a box, or comes through a plane: by
        "inside_area", by "section_flux" of closed tubes, or another of the numbers. `through` and `time` as in
        `Surface.numbers`. Error: ValueError where a number is not known; it says why."""
        return shares({each.id: each.numbers(through=through, time=time, timeout=timeout) for each in surfaces}, by)

    def undo(self) -> HistoryUndoResult:
        """Undoes the newest edit made with this token outside of any WebSocket: {undone, skipped, undo, redo}."""
        return self.api.history.undo()

    def redo(self) -> HistoryRedoResult:
        """Redoes the edit that was undone last."""
        return self.api.history.redo()

    def set_time(self, time: Optional[float]) -> ClockAnswer:
        """Sets the clock that everyone in the session shares; None: no time, surfaces are shown at their end. Error:
        OutsideTimeRange if the data of its surfaces do not reach so far.

        >>> session.set_time(0.5)["clock"]["time"]
        0.5
        """
        return self.api.time.set(time=time)

    @named
    def play(self, speed: Optional[float] = None, loop: Optional[bool] = None, from_: Optional[float] = None,
             to: Optional[float] = None) -> ClockAnswer:
        """Lets the clock run, as `time.play` does. Error: OutsideTimeRange."""
        return self.api.time.play(speed=speed, loop=loop, from_=from_, to=to)

    def pause(self) -> ClockAnswer:
        """Stops the clock."""
        return self.api.time.pause()

    # Listening.

    def connect(self, name: str = "python", timeout: Optional[float] = 60.0) -> Connection:
        """Returns a WebSocket that has joined the session as `name`, for the methods that need one: `connection.api`."""
        connection = Connection(self.client, timeout)
        connection.join(self.id, name)
        return connection

    def watch(self, name: str = "python", timeout: Optional[float] = None) -> Generator[Notification, None, None]:
        """Yields all notifications of this session, of its participants, of datasets and of the server: objects of
        `wakesurf.notifications`. Joins the session as `name` at once; close the generator to end it. Error:
        WaitTimeout after `timeout` seconds without any; Unreachable.

        >>> notifications = session.watch(timeout=30)
        >>> rake = session.rake(line=[(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)])
        >>> patched = next(each for each in notifications if isinstance(each, wakesurf.notifications.SessionPatched))
        >>> patched.patches[0]["type"], patched.patches[0]["id"] == rake.id
        ('rake', True)
        >>> notifications.close()
        """
        return watch(self.connect(name, timeout))

    def watch_async(self, name: str = "python") -> AsyncIterator[Notification]:
        """Yields the same with asyncio: `async for notification in session.watch_async(): ...`. Joins when the loop begins."""
        return watch_async(functools.partial(self.connect, name, None))

    # Pictures, see picture.py and notebook.py, which are imported only here.

    @named
    def picture(self, path: Union[str, os.PathLike[str], None] = None, size: Tuple[int, int] = (1600, 1000), *,
                time: Optional[float] = None, view: Optional[Look] = None, background: Background = "shown",
                bar: bool = True, axes: bool = True, rakes: bool = False, caption: Optional[str] = None,
                timeout: float = 120.0) -> Picture:
        """Draws a picture of the session, by its own page in a Chromium without a window, once all surfaces are
        complete.
        `path`: where to write it as PNG. `time`: shown as it is then; for others nothing changes. `view`: where from,
        and how surfaces look. Wrong parameters are refused before anything is begun. Error: InvalidParameters,
        OutsideTimeRange, BrowserMissing, PictureFailed, WaitTimeout."""
        from .picture import Painter
        with Painter(self, size, timeout=timeout, own_time=time is not None, view=view) as painter:
            return painter.picture(path, size, time=time, background=background, bar=bar, axes=axes, rakes=rakes, caption=caption)

    @named
    def film(self, path: Union[str, os.PathLike[str]], times: Sequence[float], size: Tuple[int, int] = (1280, 720), *,
             fps: float = 25, view: Optional[Look] = None, background: Background = "shown", bar: bool = True,
             axes: bool = True, rakes: bool = False, caption: Optional[str] = "t = {time:g}", progress: Optional[ProgressTarget] = None,
             timeout: float = 120.0) -> List[str]:
        """Draws a picture for each of `times`: a folder of PNG files, or an .mp4 or .webm if `path` says so and
        ffmpeg is installed. `caption` may use {time} and {frame}. It is drawn from a copy of the session, so that the
        clock of the session stays. Returns the files."""
        from .picture import film
        return film(self, path, times, size, fps=fps, view=view, background=background, bar=bar, axes=axes, rakes=rakes,
                    caption=caption, progress=progress, timeout=timeout)

    def painter(self, size: Tuple[int, int] = (1600, 1000), *, view: Optional[Look] = None, timeout: float = 120.0) -> Painter:
        """Returns a painter of several pictures: `with session.painter() as painter: painter.picture(...)` starts the
        browser once."""
        from .picture import Painter
        return Painter(self, size, timeout=timeout, own_time=False, view=view)

    def show(self, width: Union[int, str] = "100%", height: int = 600, *, proxy: Optional[bool] = None,
             static: Optional[bool] = None) -> Shown:
        """Shows the live page in a notebook, or a picture of it if the page cannot be shown; see notebook.py."""
        from .notebook import show
        return show(self, width, height, proxy=proxy, static=static)

    def _repr_html_(self) -> str:
        state: Mapping[str, Any] = self.state()
        rows = "".join(f"<tr><th>{name}</th><td>{len(state.get(name, []))}</td></tr>"
                       for name in ("rakes", "surfaces", "bookmarks", "annotations"))
        return f"<table><caption>session {html.escape(self.id)}: session.show() has its page</caption>{rows}</table>"

    # Studies.

    def study(self, rake: Mapping[str, Any], vary: Mapping[str, Sequence[Any]], *, progress: Optional[ProgressTarget] = None,
              timeout: Optional[float] = None, **surface: Any) -> Iterator[Case]:
        """Makes a surface for each combination of what `vary` lists, one after the other, in a session of its own
        that is deleted at the end. `rake`: as `Session.rake` takes it; `surface`: what all of them share, as
        `Session.surface` takes it. Many of them, on all cores or machines: `wakesurf.study`.

        >>> line = {"line": [(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)], "seeds": 12}
        >>> for case in session.study(line, {"separation": [0.1, 0.05]}, kind="stream", dataset="tornado", to=2):
        ...     print(case.parameters, case.statistics["quads"] > 50)
        {'separation': 0.1} True
        {'separation': 0.05} True
        """
        return _study(self, rake, vary, surface, progress, timeout)


@dataclass(frozen=True)
class Case:
    """One case of a study: its parameters, its result, and the surface itself until the loop's next case."""

    parameters: Dict[str, Any]
    statistics: Statistics
    surface: Surface

    def mesh(self) -> Mesh:
        """Returns the mesh, as `Surface.mesh`."""
        return self.surface.mesh()

    def row(self) -> Dict[str, Any]:
        """Returns parameters and numbers of the statistics, for a table. `separation` is that of the mesh,
        `requestedSeparation` what was asked for."""
        numbers = {name: value for name, value in self.statistics.items() if isinstance(value, (int, float, str))}
        return {**self.parameters, **numbers, "seconds": self.statistics["seconds"]["total"]}


def _study(session: Session, rake: Mapping[str, Any], vary: Mapping[str, Sequence[Any]], surface: Mapping[str, Any],
           progress: Optional[ProgressTarget], timeout: Optional[float]) -> Iterator[Case]:
    """Makes a study; see `Session.study`. Parameters of the rake can be varied as well: seeds, line, ..."""
    if not vary or not all(len(values) for values in vary.values()):
        raise InvalidParameters("nothing is varied", -32602, "invalidParameters", "give vary={\"separation\": [0.1, 0.05]}")
    twice = [name for name in vary if name in surface]
    if twice:
        raise UnknownParameter(f"`{twice[0]}` is varied and given", -32602, "invalidParameters", "give it once")
    for name in set(surface) & set(_OF_RAKE):
        raise UnknownParameter(f"`{name}` belongs to the rake", -32602, "invalidParameters", f"put it into rake={{\"{name}\": ...}}")
    report = Report.to(progress)
    cases = [dict(zip(vary, values)) for values in itertools.product(*vary.values())]
    with session.client.scratch("study") as scratch:
        for i, case in enumerate(cases):
            report.share(i / len(cases), ", ".join(f"{name}={value}" for name, value in case.items()))
            of_rake = {name: value for name, value in case.items() if name in _OF_RAKE}
            of_surface: Dict[str, Any] = {name: value for name, value in case.items() if name not in _OF_RAKE}
            with scratch.rake(**{**rake, **of_rake}) as where:
                made = scratch.surface(where, **{**surface, **of_surface})
                yield Case(case, made.wait(timeout), made)
        report.done("complete")
