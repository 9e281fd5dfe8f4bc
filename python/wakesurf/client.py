"""A server, over HTTP with the standard library."""
from __future__ import annotations

import http.client
import itertools
import json
import os
import ssl
import time as clock
import urllib.error
import urllib.parse
import urllib.request
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Tuple, Union, cast

import numpy as np

from .errors import InvalidParameters, ServerFault, Unreachable
from .generated.methods import Methods
from .generated.records import CacheStatus, Dataset, DatasetEntry, DatasetSuggestResult, ServerInfoResult
from .mesh import Array
from .names import Helpful, named
from .name_mapping import error_of
from .plain import Json, Point, Points, given, plain, point_text, slices
from .series import Series, columns_of, fields_of, points_along
from .session import Session
from .slice import Slice
from .streamlines import Streamlines

if TYPE_CHECKING:
    from .serve import Server


class Client(Helpful):
    """A server. `url` is its address, with or without `#token=...` behind it; left out, `$WAKESURF_URL` or
    http://127.0.0.1:8080. The token: `token`, else the one in `url`, else `$WAKESURF_TOKEN`.

    `timeout`: seconds without an answer after which a call fails with `Unreachable`. `tls`: an `ssl.SSLContext` for a
    certificate that the system does not know. `api` has every method of the server, with its parameters.

    >>> client = wakesurf.Client(url)
    >>> client.info()["name"]
    'wakesurf'
    >>> client.api.dataset.describe(dataset="tornado")["steady"]
    False
    """

    def __init__(self, url: Optional[str] = None, token: Optional[str] = None, timeout: float = 60.0,
                 tls: Optional[ssl.SSLContext] = None) -> None:
        url = url or os.environ.get("WAKESURF_URL") or "http://127.0.0.1:8080"
        if "://" not in url:
            url = "http://" + url
        parts = urllib.parse.urlsplit(url)
        words = urllib.parse.parse_qs(parts.fragment)
        self.url = urllib.parse.urlunsplit((parts.scheme, parts.netloc, parts.path.rstrip("/"), "", ""))
        self.timeout = timeout
        self._token = (token or words.get("token", [""])[0] or os.environ.get("WAKESURF_TOKEN", "")).strip()
        if not all("!" <= letter <= "~" for letter in self._token):
            raise ValueError("the token has a space or another character that no token has: is the address whole?")
        self._session = words.get("session", ["main"])[0]
        self._tls = tls
        handlers: List[urllib.request.BaseHandler] = [urllib.request.HTTPSHandler(context=tls)] if tls else []
        if parts.hostname in ("127.0.0.1", "localhost", "::1"):
            handlers.append(urllib.request.ProxyHandler({}))
        self._opener = urllib.request.build_opener(*handlers)
        self._ids = itertools.count(1)
        self._velocities: Dict[str, str] = {}
        self.api = Methods(self.call)
        self.server: Optional[Server] = None  # the one that `serve` started for it

    def __enter__(self) -> Client:
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
                return reply.status, dict(reply.headers), reply.read()
        except urllib.error.HTTPError as refusal:
            with refusal:
                return refusal.code, dict(refusal.headers), refusal.read()
        except (OSError, http.client.HTTPException) as problem:
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
            raise error_of(answer["error"])
        return answer

    def call(self, method: str, _timeout: Optional[float] = None, /, **parameters: Any) -> Any:
        """Calls any method of the server, by its name; parameters that are None are left out. Waits and tries again,
        up to five times, if the server says that calls come too fast."""
        request = {"jsonrpc": "2.0", "id": next(self._ids), "method": method,
                   "params": given(parameters)}
        for attempt in range(6):
            answer = self._rpc(request, _timeout)
            if "error" not in answer:
                return answer["result"]
            problem = error_of(answer["error"])
            if attempt == 5 or "retryAfterMs" not in problem.data:
                raise problem
            clock.sleep(min(problem.data["retryAfterMs"], 5000) / 1000)
        raise AssertionError("the last attempt returns or raises")

    def batch(self, calls: Iterable[Tuple[str, Json]]) -> List[Any]:
        """Sends several calls in one message. Returns results in order; a call that failed has its error as a value."""
        requests = [{"jsonrpc": "2.0", "id": next(self._ids), "method": method,
                     "params": {name: plain(value, name) for name, value in parameters.items()}}
                    for method, parameters in calls]
        if not requests:
            return []
        answers = self._rpc(requests)
        if isinstance(answers, dict):
            raise error_of(answers["error"])
        by_id = {answer["id"]: answer for answer in answers}
        return [by_id[each["id"]]["result"] if "result" in by_id[each["id"]] else error_of(by_id[each["id"]]["error"])
                for each in requests]

    def info(self) -> ServerInfoResult:
        """Returns name, version, capabilities and limits of the server."""
        return self.api.server.info()

    def datasets(self) -> List[DatasetEntry]:
        """Returns the datasets of the server: {dataset, name, state, ...} each.

        >>> [each["dataset"] for each in client.datasets()]
        ['tornado']
        """
        return self.api.dataset.list()["datasets"]

    @property
    def dataset(self) -> str:
        """Returns the id of the dataset, if the server has only one. Error: InvalidParameters if it has several, or
        none.

        >>> client.dataset
        'tornado'
        """
        ids = [each["dataset"] for each in self.datasets()]
        if len(ids) != 1:
            raise InvalidParameters(f"the server has {len(ids)} datasets", -32602, "invalidParameters",
                                    "name one of " + ", ".join(ids) if ids else "give one to the server")
        return ids[0]

    def describe(self, dataset: str) -> Dataset:
        """Returns grid, bounds, times and fields of a dataset."""
        return self.api.dataset.describe(dataset=dataset)

    def suggest(self, dataset: str) -> DatasetSuggestResult:
        """Returns a rake and the parameters of surfaces to begin with in a dataset, and why they were chosen."""
        return self.api.dataset.suggest(dataset=dataset)

    def cache(self, dataset: str) -> CacheStatus:
        """Returns which of its time-steps are in the server's memory."""
        return self.api.cache.status(dataset=dataset)

    @named
    def probe(self, dataset: str, points: Points, time: float, fields: Optional[Sequence[str]] = None) -> Dict[str, Array]:
        """Returns fields at points, (n,) or (n, 3) each, NaN outside of the fluid; `inside` says which points are in
        it. Many points are sent in several calls, as a message has at most 64 KiB: some 1,000 points each.

        >>> found = client.probe("tornado", [(0.5, 0.5, 0.5), (9, 9, 9)], time=0)
        >>> found["inside"], found["velocity"].shape
        (array([ True, False]), (2, 3))
        """
        parts = [self._probe(dataset, part, time, fields) for part in slices(plain(list(points), "points"))]
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def _probe(self, dataset: str, points: Sequence[Sequence[float]], time: float,
               fields: Optional[Sequence[str]]) -> Dict[str, Array]:
        answer = self.api.probe.sample(dataset=dataset, points=points, time=time, fields=fields)
        out: Dict[str, Array] = {}
        for name, values in cast(Mapping[str, Any], answer["values"]).items():
            vector = any(isinstance(value, list) for value in values) or (
                all(value is None for value in values) and name == self._velocity(dataset))
            missing: Any = [np.nan] * 3 if vector else np.nan
            found = np.array([missing if value is None else value for value in values], dtype=float)
            out[name] = found.reshape(-1, 3) if vector else found
        out["inside"] = np.array(answer["inside"], dtype=bool)
        return out

    def slice(self, dataset: str, point: Sequence[float], normal: Sequence[float], *, field: Optional[str] = None,
              time: Optional[float] = None, samples: int = 256, minus: Optional[str] = None,
              minus_time: Optional[float] = None) -> Slice:
        """Returns a field on the part of a plane that is in the dataset's bounds: `samples` (1 to 2048) along the longer side.
        `field`: a stored scalar, or what surfaces can carry of the velocity, "vorticity", "q_criterion", "velocity_x" and so on, or
        "velocity_normal", across the plane; left out, the speed. `time`: left out of a flow that stands still. `minus`: the dataset whose field is subtracted, and
        `minus_time`: at which time, left out: the same; one without the other is of this time or this dataset. Error: NotFound, InvalidParameters, OutsideTimeRange,
        OutsideDomain where the plane misses the bounds.

        >>> found = client.slice("tornado", (0.5, 0.5, 0.5), (0, 0, 1), field="vorticity", time=0, samples=64)
        >>> found.values.shape, found.points.shape
        ((64, 64), (64, 64, 3))
        """
        field = field or self._velocity(dataset)
        query = {"plane": f"{point_text(point, 'point')}:{point_text(normal, 'normal')}", "samples": str(int(plain(samples, "samples")))}
        if minus is not None:
            query["minus"] = minus
        if minus_time is not None:
            query["minusTime"] = repr(float(plain(minus_time, "minus_time")))
        return Slice.from_bytes(self._field_file(dataset, "slice.bin", query, field, time), field)

    def streamlines(self, dataset: str, *, line: Optional[Points] = None, plane: Optional[Points] = None,
                    sphere: Optional[Tuple[Point, float]] = None, walls: Optional[float] = None, along_walls: bool = False,
                    patches: Union[str, Sequence[str]] = (), seeds: int = 50, direction: str = "both", duration: float = 0,
                    length: float = 0, field: Optional[str] = None, time: Optional[float] = None) -> Streamlines:
        """Returns streamlines of the flow at a time, from seeds on a `line` (its two ends), in a `plane` (a corner and the two
        beside it), on a `sphere` (its centre and radius), so far off the `walls`, or with `along_walls` lines that lie on the walls and
        follow the flow just beside them: exactly one of these. `patches`: names of those that walls mean (`patches` of `describe`),
        also an inlet; left out, all walls of bodies. `seeds`: 1 to 4096. `direction`: "forward", "backward" or "both". `duration`: the
        time of flight, and `length`: the length each way, after which a line ends; 0: at the domain's border, at the latest after
        twice its diagonal. `field`: along the lines, as of slice. Error: NotFound, InvalidParameters, OutsideTimeRange, OutsideDomain
        where all seeds lie beside the domain.

        >>> lines = client.streamlines("tornado", line=((0.3, 0.5, 0.1), (0.7, 0.5, 0.1)), seeds=5, time=0)
        >>> len(lines), lines.points.shape[1]
        (5, 3)
        """
        given_seeds = [
            *(["line:" + ":".join(point_text(each, "line") for each in line)] if line is not None else []),
            *(["plane:" + ":".join(point_text(each, "plane") for each in plane)] if plane is not None else []),
            *([f"sphere:{point_text(sphere[0], 'sphere')}:{float(plain(sphere[1], 'sphere'))!r}"] if sphere is not None else []),
            *([f"walls:{float(plain(walls, 'walls'))!r}"] if walls is not None else []), *(["along"] if along_walls else [])]
        if len(given_seeds) != 1:
            raise InvalidParameters("streamlines need one of `line`, `plane`, `sphere`, `walls` and `along_walls`", -32602,
                                    "invalidParameters", "as in line=((0, 0, 0), (1, 0, 0))")
        field = field or self._velocity(dataset)
        names = [patches] if isinstance(patches, str) else list(patches)
        query = {"from": given_seeds[0], **({"patch": "\n".join(names)} if names else {}),
                 "seeds": str(int(plain(seeds, "seeds"))), "direction": direction,
                 "duration": repr(float(plain(duration, "duration"))), "length": repr(float(plain(length, "length")))}
        return Streamlines.from_bytes(self._field_file(dataset, "lines.bin", query, field, time), field)

    @named
    def body(self, dataset: str, *, patch: Optional[str] = None, all_patches: bool = False, field: Optional[str] = None,
             time: Optional[float] = None) -> bytes:
        """Returns the walls of a dataset's bodies as the bytes of a .vtp file, or one `patch` of the boundary by its name (`patches` of
        `describe`), or `all_patches`. `field`: a value beside the wall for each point, at `time`; left out, the last. Error: NotFound
        where there is none, InvalidParameters, OutsideTimeRange.

        >>> with wakesurf.serve("flow:sphere") as own:
        ...     own.client.body("sphere", field="velocity")[:21]
        b'<?xml version="1.0"?>'
        """
        query = {**({"patch": patch} if patch is not None else {}), **({"patches": "all"} if all_patches else {})}
        if field is None:
            return self._dataset_file(dataset, "body.vtp", query)
        return self._field_file(dataset, "body.vtp", query, field, self.describe(dataset)["times"][-1] if time is None else time)

    def _field_file(self, dataset: str, name: str, query: Dict[str, str], field: str, time: Optional[float]) -> bytes:
        query = {**query, "field": field}
        if time is not None:
            query["time"] = repr(float(plain(time, "time")))
        return self._dataset_file(dataset, name, query)

    def _dataset_file(self, dataset: str, name: str, query: Dict[str, str]) -> bytes:
        status, _, body = self._request(f"/api/v1/datasets/{urllib.parse.quote(dataset, safe='')}/{name}?{urllib.parse.urlencode(query)}")
        if status != 200:
            raise error_of(json.loads(body)["error"])
        return body

    @named
    def profile(self, dataset: str, line: Points, fields: Sequence[str] = ("speed",), time: Optional[float] = None, *,
                samples: int = 401) -> Series:
        """Returns values at `samples` places evenly along a line, given by its ends or more points, or by a rake's `points`.
        `fields`: "speed", "velocity_x" and so on, the velocity by its name, stored scalars, "vorticity_z" and the like.
        `time`: left out, the first. Error: as `probe`.

        >>> along = client.profile("tornado", [(0.2, 0.5, 0.5), (0.8, 0.5, 0.5)], ["speed"], samples=3)
        >>> list(along.columns), along["distance"].round(6)
        (['distance', 'x', 'y', 'z', 'time', 'speed'], array([0. , 0.3, 0.6]))
        """
        about = self.describe(dataset)
        at = float((about["times"] or [0.0])[0] if time is None else time)
        points, distances = points_along(plain(list(line), "line"), samples)
        places = {"distance": distances, **dict(zip("xyz", points.T)), "time": np.full(samples, at)}
        return self._series(about, places, fields, self.probe(dataset, points, at, fields_of(about, fields)))

    @named
    def history(self, dataset: str, point: Sequence[float], fields: Sequence[str] = ("speed",),
                times: Optional[Sequence[float]] = None) -> Series:
        """Returns values at a point over time: at each stored time, or at `times`. `fields` as in `profile`. One call is made for
        each time. Error: as `probe`; ValueError without a time.

        >>> over_time = client.history("tornado", (0.5, 0.5, 0.5), ["speed", "velocity_z"], times=[0, 1, 2])
        >>> list(over_time.columns), len(over_time)
        (['time', 'x', 'y', 'z', 'speed', 'velocity_z'], 3)
        """
        about = self.describe(dataset)
        at = np.asarray(about["times"] if times is None else plain(list(times), "times"), dtype=float)
        place = np.asarray(plain(list(point), "point"), dtype=float)
        asked = fields_of(about, fields)
        if len(at) == 0:
            raise ValueError("there is no time: give at least one in `times`")
        moments = [self.probe(dataset, [place], float(time), asked) for time in at]
        found = {name: np.concatenate([each[name] for each in moments]) for name in moments[0]}
        return self._series(about, {"time": at, **{name: np.full(len(at), x) for name, x in zip("xyz", place)}}, fields, found)

    def _series(self, about: Dataset, places: Dict[str, Array], fields: Sequence[str], found: Dict[str, Array]) -> Series:
        columns, units = columns_of(about, fields, found)
        lengths = {name: about.get("lengthUnit", "") for name in ("distance", "x", "y", "z")}
        known = {**lengths, "time": about.get("timeUnit", ""), **units}
        return Series({**places, **columns}, {name: unit for name, unit in known.items() if unit and name in {**places, **columns}})

    def _velocity(self, dataset: str) -> str:
        """Tells vectors by the dataset: the values of a part that lies outside as a whole do not show it."""
        if dataset not in self._velocities:
            self._velocities[dataset] = self.describe(dataset)["velocity"]
        return self._velocities[dataset]

    def sessions(self, trash: bool = False) -> List[Session]:
        """Returns the sessions that this token may enter, or those in the trash. `Session.about` of each has its
        name, its participants, the time of its last use and its content."""
        return [Session(self, each["session"], each)
                for each in self.call("session.list", trash=trash or None)["sessions"]]

    def session(self, session: Optional[str] = None) -> Session:
        """Returns the session with this id; left out, the one in the address, else `main`. Error: NotFound."""
        found = Session(self, session or self._session)
        found.state()
        return found

    def create_session(self, name: str = "") -> Session:
        """Makes an empty session; `Session.about["remaining"]` says how many more there may be. Give it a name: the
        server may delete one that has no name and is never edited. Error: OverLimit."""
        made = self.call("session.create", name=name)
        return Session(self, made["session"], made)

    def import_session(self, path: Union[str, os.PathLike[str]], name: str = "") -> Session:
        """Makes a session of a file that `Session.export` wrote, here or on another server. `Session.about["notes"]`
        are sentences about datasets that are missing, or are different ones. Error: InvalidParameters, OverLimit."""
        with open(path, "rb") as file:
            body = file.read()
        status, _, answer = self._request("/api/v1/sessions", body)
        made = json.loads(answer)
        if status != 200:
            raise error_of(made["error"])
        session = Session(self, made["session"], made)
        if name:
            session.rename(name)
        return session

    @contextmanager
    def scratch(self, name: str = "scratch") -> Iterator[Session]:
        """Makes a session for as long as the block runs; then it is deleted for good, with everything made in it.

        >>> with client.scratch() as session:
        ...     rake = session.rake(line=[(0.4, 0.4, 0.1), (0.6, 0.6, 0.1)], seeds=8)
        >>> client.session(session.id)
        Traceback (most recent call last):
        wakesurf.errors.NotFound: ...
        """
        session = self.create_session(name)
        try:
            yield session
        finally:
            session.discard()
