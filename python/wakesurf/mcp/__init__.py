"""Tools for programs that are driven by a language model: a server of the Model Context Protocol over standard input and output.

An optional part: only `wakesurf mcp`, `wakesurf-mcp` and `python -m wakesurf.mcp` load it. README.md says how to start it and what is where;
here is the command: its options, its streams, and its end.
"""
from __future__ import annotations

import argparse
import os
import signal
import sys
import threading
from typing import Optional, Sequence

from .server import Server
from .wire import Out
from .work import Place, Work

_PATIENCE = 5.0  # s, for the call that runs at the end
_POLL_SECONDS = 0.2  # whether a signal has been noticed


def _options(arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="wakesurf-mcp", description="Tools for AI agents, over the Model Context Protocol on standard "
                                     "input and output.")
    parser.add_argument("datasets", metavar="DATASET", nargs="*", help="what to start a server for: files or folders of simulation results, "
                        "stores, flow:NAME (default: $WAKESURF_URL, or else the bundled simulation)")
    parser.add_argument("--url", help="address of a running server, with its token; $WAKESURF_URL keeps it from the eyes of others on this "
                        "machine, who can read command lines")
    parser.add_argument("--session", help="session to work in (default: the one in the address, or else main)")
    parser.add_argument("--folder", default=".", help="files are written below this folder only (default: the current one)")
    given = parser.parse_args(arguments)
    if given.url and given.datasets:
        parser.error("give --url or datasets, not both")
    if not os.path.isdir(given.folder):
        parser.error(f"--folder: there is no folder {given.folder}")
    return given


def _end_on_signals() -> None:
    """Python acts on a signal between two of its own steps. One that comes just before a read of the input, or to another
    thread, is noticed after that read only, which may be never: the main thread is sent it again."""
    ended = threading.Event()

    def end(*_: object) -> None:
        if not ended.is_set():  # the end itself is not interrupted
            ended.set()
            sys.exit(0)

    def send_again() -> None:
        while not ended.is_set():
            number = os.read(signalled, 1)[0]
            if number in ending and not ended.wait(_POLL_SECONDS):
                signal.pthread_kill(threading.main_thread().ident or 0, number)

    # The second where there is one: the server has a session of its own, and would go on.
    ending = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    for each in ending:
        signal.signal(each, end)
    if hasattr(signal, "pthread_kill"):
        signalled, wakeup = os.pipe()
        os.set_blocking(wakeup, False)
        signal.set_wakeup_fd(wakeup, warn_on_full_buffer=False)
        threading.Thread(target=send_again, name="wakesurf-mcp-signals", daemon=True).start()


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command and returns its exit status."""
    given = _options(arguments)
    out = Out(sys.stdout.buffer)
    sys.stdout = sys.stderr  # what a library prints must not come between the messages
    _end_on_signals()
    work = Work(given.datasets, given.url or (None if given.datasets else os.environ.get("WAKESURF_URL")), given.session,
                Place(given.folder))
    server = Server(work, sys.stdin.buffer, out)
    try:
        server.run()
    except KeyboardInterrupt:
        pass
    finally:
        work.close()
        server.join(_PATIENCE)
    return 0
