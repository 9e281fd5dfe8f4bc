"""The server that a process keeps for its tasks: started by the first, shared by all its threads, ended when it has long had nothing to do.

Each is held by a thread of its own, which starts it and lives as long: a tied server (`serve`) ends with that thread, so also with a process that
a signal kills (on Linux only), and not with the thread of an executor that happened to need it first.
"""
from __future__ import annotations

import os
import subprocess
import threading
import time as clock
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from multiprocessing import util
from typing import Any, Dict, Iterator, Mapping, Tuple

from .client import Client
from .errors import OverLimit, ServerFailed, ServerFault, ServerMissing, Unreachable, WakesurfError
from .serve import Server, serve

_IDLE = 60.0  # seconds without a task after which a server ends
_ENDING = 20.0  # seconds that one may take to end
_LOOK = 1.0  # seconds from one look at it to the next
_MOST = 2  # servers of a process: that of its case, and that of the case before
_MOST_FAILED = 1000  # starts that are remembered
_AT_ONCE = 8  # tasks that have it at a time, which is how many downloads it has for one person


def lost(problem: BaseException) -> bool:
    """Returns whether an error is of a server or its load, so that another try may go well. A server that ended by itself has said what is wrong."""
    if isinstance(problem, ServerFailed):
        return problem.code <= 0
    return isinstance(problem, (Unreachable, ServerFault, OverLimit))


class _Kept:
    """A server and who uses it."""

    def __init__(self, case: str, options: Mapping[str, Any], failed: Tuple[str, str]) -> None:
        self.users, self.used = 0, clock.monotonic()
        self.turns, self.unwanted = threading.Semaphore(_AT_ONCE), threading.Event()
        self.begun: Future[Server] = Future()
        threading.Thread(target=self._hold, args=(case, options, failed), daemon=True, name="wakesurf-server").start()

    @property
    def usable(self) -> bool:
        """Whether it runs, or is about to."""
        return not self.begun.done() or self.begun.exception() is None and self.begun.result().running

    def _hold(self, case: str, options: Mapping[str, Any], failed: Tuple[str, str]) -> None:
        try:
            server = serve(case, **options, tied=True)
        except BaseException as problem:
            with _changed:
                if isinstance(problem, WakesurfError) and not isinstance(problem, ServerMissing) and not lost(problem):
                    _failed[failed] = problem
                    for oldest in list(_failed)[:-_MOST_FAILED]:
                        del _failed[oldest]
                _drop(self)
            self.begun.set_exception(problem)
            return
        end = util.Finalize(server, server.stop, exitpriority=10)  # processes of a pool end without what atexit knows
        self.begun.set_result(server)
        while not self.unwanted.wait(_LOOK) and self.usable and not self._idle():
            pass
        with _changed:
            _drop(self)
        end()

    def _idle(self) -> bool:
        with _changed:
            idle = not self.users and clock.monotonic() - self.used > _IDLE
            if idle:
                _drop(self)  # with the lock still held: no one begins to use it
            return idle


_changed = threading.Condition()  # who uses which of these
_kept: Dict[str, _Kept] = {}
_failed: Dict[Tuple[str, str], WakesurfError] = {}  # by server and study: in one study, not each task of a case that cannot be read reads it again


def _drop(kept: _Kept) -> None:
    _changed.notify_all()
    for key in [key for key, each in _kept.items() if each is kept]:
        del _kept[key]


def _forget() -> None:
    """A forked process has none of the threads, and starts servers of its own."""
    global _changed
    _changed = threading.Condition()
    _kept.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)


@contextmanager
def kept_server(case: str, data: str, options: Mapping[str, Any], study: str) -> Iterator[Client]:
    """Yields a client of this process's server for a case and its `data`, whatever tells them from others at the same path. It is started with
    `options` of `serve` if there is none, once two at most are in use. Threads may call it at once; eight of them have a server at a time, the
    others wait. Error: as `serve`; again, without another start, to all of a `study` whose case cannot be served."""
    key = repr((case, data, sorted(options.items())))
    kept = _use(key, case, options, study)
    try:
        with kept.turns:
            yield Client(kept.begun.result().url)
    except Unreachable:
        if kept.begun.exception() is None:
            with suppress(subprocess.TimeoutExpired):  # or the next task takes one that is still ending, which may take its memory seconds
                kept.begun.result().process.wait(_ENDING)
        raise
    finally:
        with _changed:
            kept.users -= 1
            kept.used = clock.monotonic()
            _changed.notify_all()


def _use(key: str, case: str, options: Mapping[str, Any], study: str) -> _Kept:
    with _changed:
        while True:
            if (key, study) in _failed:
                raise _failed[key, study].with_traceback(None)  # or it grows by each task that is told
            kept = _kept.get(key)
            if kept is not None and kept.usable:
                break
            others = {name: each for name, each in _kept.items() if name != key}
            free = sorted((name for name, each in others.items() if not each.users), key=lambda name: others[name].used)
            if len(others) - len(free) < _MOST:
                for name in free[:max(0, len(others) + 1 - _MOST)]:
                    _kept.pop(name).unwanted.set()
                kept = _kept[key] = _Kept(case, options, (key, study))
                break
            _changed.wait()
        kept.users += 1
        return kept
