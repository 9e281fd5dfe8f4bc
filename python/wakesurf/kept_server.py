"""The server that a process keeps for its tasks: started by the first, shared by all its threads, ended when it has long had nothing to do.

Each is held by a thread of its own, which starts it and lives as long: a tied server (`serve`) ends with that thread, so also with a process that
a signal kills, and not with the thread of an executor that happened to need it first.
"""
from __future__ import annotations

import os
import subprocess
import threading
import time as clock
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from multiprocessing import util
from typing import Any, Dict, Iterator, Mapping

from .client import Client
from .errors import ServerFailed, Unreachable
from .serve import Server, serve

_IDLE = 60.0  # seconds without a task after which a server ends
_ENDING = 20.0  # seconds that one may take to end
_LOOK = 1.0  # seconds from one look at it to the next
_MOST = 2  # servers of a process: that of its case, and that of the case before
_AT_ONCE = 8  # tasks that have it at a time, which is how many downloads it has for one person


class _Kept:
    """A server and who uses it. A start that failed is kept as well, so that not each task of a case that cannot be read reads it again."""

    def __init__(self, case: str, options: Mapping[str, Any]) -> None:
        self.users, self.used = 0, clock.monotonic()
        self.turns, self.unwanted = threading.Semaphore(_AT_ONCE), threading.Event()
        self.begun: Future[Server] = Future()
        threading.Thread(target=self._hold, args=(case, options), daemon=True, name="wakesurf-server").start()

    @property
    def usable(self) -> bool:
        """Whether it runs, or is about to, or never will."""
        return not self.begun.done() or self.begun.exception() is not None or self.begun.result().running

    def _hold(self, case: str, options: Mapping[str, Any]) -> None:
        server = None
        try:
            server = serve(case, **options, tied=True)
            util.Finalize(server, server.stop, exitpriority=10)  # processes of a pool end without what atexit knows
            self.begun.set_result(server)
        except BaseException as problem:
            if isinstance(problem, ServerFailed):
                self.unwanted.set()
            self.begun.set_exception(problem)
        while not self.unwanted.wait(_LOOK) and self.usable and not self._idle():
            pass
        with _lock:
            _drop(self)
        if server is not None:
            server.stop()

    def _idle(self) -> bool:
        with _lock:
            idle = not self.users and clock.monotonic() - self.used > _IDLE
            if idle:
                _drop(self)  # with the lock still held: no one begins to use it
            return idle


_lock = threading.Lock()
_kept: Dict[str, _Kept] = {}


def _drop(kept: _Kept) -> None:
    for key in [key for key, each in _kept.items() if each is kept]:
        del _kept[key]


def _forget() -> None:
    """A forked process has none of the threads, and starts servers of its own."""
    global _lock
    _lock = threading.Lock()
    _kept.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)


@contextmanager
def kept_server(case: str, options: Mapping[str, Any]) -> Iterator[Client]:
    """Yields a client of this process's server for a case, which is started with `options` of `serve` if there is none. Threads may call it at
    once; eight of them have the server at a time, the others wait. Error: as `serve`."""
    key = repr((case, sorted(options.items())))
    with _lock:
        kept = _kept.get(key)
        if kept is None or not kept.usable:
            kept = _kept[key] = _Kept(case, options)
            free = sorted((each for each in _kept.values() if not each.users and each is not kept), key=lambda each: each.used)
            for each in free[:max(0, len(_kept) - _MOST)]:
                _drop(each)
                each.unwanted.set()
        kept.users += 1
    try:
        with kept.turns:
            yield Client(kept.begun.result().url)
    except Unreachable:
        with suppress(subprocess.TimeoutExpired):  # or the next task takes one that is still ending, which may take its memory seconds
            kept.begun.result().process.wait(_ENDING)
        raise
    finally:
        with _lock:
            kept.users -= 1
            kept.used = clock.monotonic()
