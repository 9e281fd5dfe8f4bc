"""The command: its options, its streams, and its end."""
from __future__ import annotations

import argparse
import os
import signal
import sys
from typing import Optional, Sequence

from .place import Place
from .server import Server
from .wire import Out
from .work import Work

_PATIENCE = 5.0  # s, for the call that runs at the end


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


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command and returns its exit status."""
    given = _options(arguments)
    out = Out(sys.stdout.buffer)
    sys.stdout = sys.stderr  # what a library prints must not come between the messages
    for name in ("SIGTERM", "SIGHUP"):  # the second where there is one: the server has a session of its own, and would go on
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), lambda *_: sys.exit(0))
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
