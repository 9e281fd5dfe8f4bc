"""What the tools work in: the session, found, or started with a server of its own, when the first tool needs it; and the folder for files."""
from __future__ import annotations

import os
import threading
import time as clock
from typing import TYPE_CHECKING, Any, Optional, Sequence, Set

from ..client import Client
from ..errors import InvalidParameters, NotFound, NotPermitted, WakesurfError
from ..plain import Json
from ..serve import serve
from ..surface import Surface

if TYPE_CHECKING:
    from ..session import Session
    from .tool import Call

_LONGEST_NAME = 200  # with what is added while it is written, less than file systems take
_LONGEST_PATH = 1000


class Work:
    """The session. One thread at a time uses it, except for `close`."""

    def __init__(self, datasets: Sequence[str], url: Optional[str], session: Optional[str], place: Place) -> None:
        self._datasets, self._url, self._wanted = list(datasets), url, session
        self.place = place
        self._client: Optional[Client] = None
        self._session: Optional[Session] = None
        self._newest: Optional[str] = None
        self._lock, self._closed = threading.Lock(), False

    def close(self) -> None:
        """Ends the server, if it is one of ours."""
        with self._lock:
            self._closed = True
            if self._client is not None and self._client.server is not None:
                self._client.server.stop()

    @property
    def client(self) -> Client:
        with self._lock:
            if self._closed:
                raise WakesurfError("this program is ending")
            if self._client is None:
                self._client = Client(self._url) if self._url else serve(*self._datasets, wait=False).client
        return self._client

    @property
    def session(self) -> Session:
        if self._session is None:
            self._session = self.client.session(self._wanted)
        return self._session

    def enter(self, session: str) -> None:
        """Changes to another session; "new": an empty one of its own. Error: NotFound, NotPermitted."""
        self._session = self.client.create_session("agent") if session == "new" else self.client.session(session)
        self._newest = None

    def dataset(self, named: Optional[str]) -> str:
        """Returns the dataset with the name, else the only one there is."""
        ids = [each["dataset"] for each in self.client.datasets()]
        if named is None and len(ids) == 1:
            return ids[0]
        if named in ids:
            return str(named)
        message = f"there is no dataset {named!r}" if named else f"there are {len(ids)} datasets"
        kind = NotFound if named else InvalidParameters
        raise kind(message, 0, "notFound" if named else "invalidParameters", "name one: " + ", ".join(ids))

    def ready(self, dataset: str, seconds: float, call: Call) -> Json:
        """Returns the dataset's entry, once it is imported, or as it is after so many seconds."""
        end = clock.monotonic() + seconds
        while True:
            entry: Json = next(dict(each) for each in self.client.datasets() if each["dataset"] == dataset)
            left = end - clock.monotonic()
            if entry["state"] != "importing" or left <= 0:
                return entry
            call.progress(entry.get("progress"), f"importing {entry['name']}")
            self.client.api.dataset.open(dataset=dataset, timeout_ms=int(1000 * min(0.5, left)))

    def made(self, surface: str) -> None:
        """Makes a surface the newest."""
        self._newest = surface

    def surface(self, named: Optional[str]) -> Surface:
        """Returns the surface with the id, else the one that was made last. Error: NotFound."""
        ids = [each.id for each in self.session.surfaces()]
        wanted = named or (self._newest if self._newest in ids else None) or (ids[-1] if ids else None)
        if wanted in ids:
            return Surface(self.session, str(wanted))
        if not ids:
            raise NotFound("the session has no surface", 0, "notFound", "make one with the tool `surface`")
        raise NotFound(f"there is no surface {named!r}", 0, "notFound", "there are " + ", ".join(ids))


def short(value: Any) -> Any:
    """Rounds each number to six digits: more would say nothing."""
    if isinstance(value, float):
        return float(f"{value:.6g}")
    if isinstance(value, dict):
        return {name: short(each) for name, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [short(each) for each in value]
    return value


class Place:
    """The folder that files are written to: none is written outside of it, nor over a file of others. Links are followed before it is decided whether a path lies in it."""

    def __init__(self, folder: str) -> None:
        self.folder = os.path.realpath(folder)
        self._made: Set[str] = set()

    def take(self, path: str, extensions: Sequence[str], overwrite: bool = False) -> str:
        """Returns the path to write to; folders on the way are made. From now on it may be written again, also if
        this time fails. An extension of "" allows a folder. Error: NotPermitted, InvalidParameters."""
        if not path.strip() or not path.isprintable():  # nothing that acts on a terminal, or cannot be seen
            raise _wrong(f"{path!r} is not a file name", "give a path below the folder, of visible characters")
        if any(len(os.fsencode(part)) > _LONGEST_NAME for part in path.split("/")) or len(os.fsencode(path)) > _LONGEST_PATH:
            raise _wrong("`path` is too long", f"names have at most {_LONGEST_NAME} bytes, a path {_LONGEST_PATH}")
        ending = os.path.splitext(path)[1].lower()
        if ending not in extensions:
            raise _wrong(f"`path` ends in {ending or 'nothing'}", "one of " + ", ".join(each or "a folder" for each in extensions))
        full = os.path.realpath(os.path.join(self.folder, path))
        if os.path.commonpath([self.folder, full]) != self.folder or full == self.folder:
            raise NotPermitted(f"{path!r} is not below the folder for files", 0, "notPermitted",
                               "give a path relative to it; the folder is chosen by --folder where this program is started")
        there = os.listdir(full) if os.path.isdir(full) and ending == "" else os.path.lexists(full)
        if there and full not in self._made and not overwrite:
            raise NotPermitted(f"{self.shown(full)} is there already, and not from here", 0, "notPermitted",
                               "give another name, or overwrite=true if its owner agrees")
        os.makedirs(os.path.dirname(full), exist_ok=True)
        self._made.add(full)
        return full

    def shown(self, full: str) -> str:
        """Returns the path below the folder, as people would write it."""
        return os.path.relpath(full, self.folder)


def _wrong(message: str, hint: str) -> InvalidParameters:
    return InvalidParameters(message, -32602, "invalidParameters", hint)
