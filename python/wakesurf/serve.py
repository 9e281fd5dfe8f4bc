"""Starting a server from a script: the installed program, on a free port, until the block ends."""
from __future__ import annotations

import atexit
import os
import selectors
import shutil
import signal
import subprocess
import sys
import tempfile
import time as clock
from typing import IO, Callable, List, Optional, Sequence, Union

from .client import Client
from .errors import ServerFailed, ServerMissing
from .frame_origin import notebook_origins
from .name_mapping import error_of
from .progress import ProgressTarget, Report
from .session import Session

HOW = ("install the Debian package wakesurf, or compile it (./run in a clone); then put `wakesurf` into PATH, name it in $WAKESURF, or "
       "give binary=. To a server that runs elsewhere, in a container as well: wakesurf.Client(address)")
_LAST_WORDS = 2000  # characters of the log in an error
_PR_SET_PDEATHSIG = 1

Path = Union[str, "os.PathLike[str]"]


def find_server(binary: Optional[Path] = None) -> str:
    """Returns the program: `binary`, else $WAKESURF, else the one in PATH. Error: ServerMissing, which says how to
    get it."""
    named = os.fspath(binary) if binary else os.environ.get("WAKESURF", "")
    found = shutil.which(named or "wakesurf")
    if found is None:
        where = f"{named!r} is not a program" if named else "there is no program `wakesurf` on this machine"
        raise ServerMissing(where, kind="serverMissing", hint=HOW)
    return found


class Server:
    """A server that runs until `stop`, or until Python ends. `url` is its address with the token; `session` is its session `main`.
    In a `with` it gives that session and stops at the end."""

    def __init__(self, command: Sequence[str], timeout: float, tied: bool = False) -> None:
        self._log: IO[bytes] = tempfile.TemporaryFile()
        environment = {name: value for name, value in os.environ.items() if name not in ("WAKESURF_LISTEN", "WAKESURF_TOKEN_FILE")}
        self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=self._log,
                                        env=environment, start_new_session=True, preexec_fn=_end_with_starter() if tied else None)
        atexit.register(self.stop)
        try:
            self.url = self._address(timeout)
            self.client = Client(self.url)
            self.client.server = self
            self.session = self.client.session()
        except BaseException:
            self.stop()
            raise

    def __enter__(self) -> Session:
        return self.session

    def __exit__(self, *_: object) -> None:
        self.stop()

    def __repr__(self) -> str:
        return f"Server({self.url.split('#')[0]!r})"

    @property
    def running(self) -> bool:
        return self.process.poll() is None

    def stop(self, timeout: float = 20.0) -> None:
        """Ends the server; does nothing if it has ended."""
        atexit.unregister(self.stop)
        if self.running:
            self.process.terminate()
            try:
                self.process.wait(timeout)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        if self.process.stdout:
            self.process.stdout.close()
        self._log.close()

    def log(self) -> str:
        """Returns its output so far."""
        self._log.seek(0)
        return self._log.read().decode(errors="replace")

    def _address(self, timeout: float) -> str:
        """Reads the address from the first line of output, which comes when the server answers."""
        assert self.process.stdout is not None
        end, text = clock.monotonic() + timeout, b""
        with selectors.DefaultSelector() as selector:
            selector.register(self.process.stdout, selectors.EVENT_READ)
            while b"\n" not in text:
                if not selector.select(max(0.0, end - clock.monotonic())):
                    raise ServerFailed(f"the server has not started within {timeout:g} s: {self._last_words()}")
                part = os.read(self.process.stdout.fileno(), 4096)
                if not part:
                    self.process.wait()
                    status = self.process.returncode
                    raise ServerFailed(f"the server has ended with status {status}: {self._last_words()}", status)
                text += part
        return next(word for word in text.decode().split() if "://" in word)

    def _last_words(self) -> str:
        return self.log().strip()[-_LAST_WORDS:] or "it printed nothing"


def serve(*datasets: Path, binary: Optional[Path] = None, store: Optional[Path] = None, state: Optional[Path] = None,
          memory: Optional[str] = None, threads: Optional[int] = None, frame_origins: Optional[Sequence[str]] = None,
          options: Sequence[str] = (), wait: bool = True, progress: Optional[ProgressTarget] = None, timeout: float = 60.0,
          tied: bool = False) -> Server:
    """Starts a server for these datasets: files or folders of simulation results, stores, or built-in flows as "flow:tornado"; none:
    the bundled simulation.

    `binary`: the program; left out, $WAKESURF or the one in PATH. `store`: folder for imported data. `state`: folder for sessions;
    left out, they end with the server. `memory`, `threads`: what it may use. `frame_origins`: whose pages may show its page in a
    frame; left out, those of the notebook that this runs in. `options`: more of `wakesurf serve --help`. `wait`: until all data
    are imported; `progress` is told how far that is. `timeout`: seconds until it has to answer. `tied`: on Linux it ends with the
    thread that calls this, also where a signal kills that; elsewhere, as without, only with a Python that ends by itself.

    >>> with wakesurf.serve("flow:tornado") as session:
    ...     print(session.suggested("stream").wait()["complete"])
    True

    Error: ServerMissing, where there is no program; ServerFailed, with what it said; DatasetError.
    """
    command: List[str] = [find_server(binary), "serve", *(os.fspath(each) for each in datasets), "--listen", "127.0.0.1:0"]
    for name, value in (("--store", store), ("--state", state), ("--memory", memory), ("--threads", threads)):
        if value is not None:
            command += [name, os.fspath(value) if isinstance(value, os.PathLike) else str(value)]
    for origin in notebook_origins() if frame_origins is None else frame_origins:
        command += ["--frame-origin", origin]
    server = Server([*command, *options], timeout, tied)
    if wait:
        try:
            _wait_for_data(server.client, Report.to(progress))
        except BaseException:
            server.stop()
            raise
    return server


def _end_with_starter() -> Optional[Callable[[], None]]:
    """Returns what a new process does first to get SIGTERM when the thread that started it ends; None where there is no such call."""
    if not sys.platform.startswith("linux"):
        return None
    import ctypes
    prctl, parent = ctypes.CDLL(None).prctl, os.getpid()  # loaded here: between fork and exec nothing should be

    def tie() -> None:
        if prctl(_PR_SET_PDEATHSIG, signal.SIGTERM) != 0 or os.getppid() != parent:
            os._exit(1)

    return tie


def _wait_for_data(client: Client, report: Report) -> None:
    datasets = client.datasets()
    for i, entry in enumerate(datasets):
        while entry["state"] == "importing":
            share = (i + entry.get("progress", 0.0)) / len(datasets)
            report.share(share, f"importing {entry['name']}")
            entry = client.api.dataset.open(dataset=entry["dataset"], timeout_ms=500 if report.wanted else 30_000)
        if entry["state"] == "failed":
            problem = entry.get("error", {})
            raise error_of({"code": problem.get("code", 0), "message": f"{entry['name']} cannot be read: {problem.get('message', '')}",
                            "data": {"kind": problem.get("kind", ""), "hint": problem.get("hint", "")}})
    report.done("imported")
