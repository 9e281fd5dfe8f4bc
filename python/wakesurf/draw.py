"""`wakesurf surface DATA -o a.png`: draws the surface of a command line, by a server that runs meanwhile."""
from __future__ import annotations

import io
import json
import signal
import sys
import warnings
from typing import Any, Optional, Sequence

from .chrome import find_browser
from .errors import PictureFailed, WakesurfError
from .names import snake
from .name_mapping import in_options
from .plain import Json
from .progress import Progress
from .serve import serve
from .surface import begin, last_time


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Reads arguments as server/app/surface_command.cpp writes them: the work, the dataset, the file, and options of
    the server. Returns the exit status."""
    job, dataset, output, *options = sys.argv[1:] if arguments is None else arguments
    for stream in (sys.stdout, sys.stderr):  # names of files are bytes, and go out as they came
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="surrogateescape")
    for each in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(each, signal.default_int_handler)
    try:
        draw(json.loads(job), dataset, output, options)
    except WakesurfError as problem:
        print("wakesurf: " + in_options(*(problem.original or (problem.message, problem.hint))), file=sys.stderr)
        return 1
    except OSError as problem:
        print(f"wakesurf: {problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("wakesurf: stopped, nothing was written", file=sys.stderr)
        return 1
    return 0


def draw(job: Json, dataset: str, output: str, options: Sequence[str]) -> None:
    """Draws the surface. Error: WakesurfError, OSError."""
    find_browser()  # before anything is computed
    width, _, height = job["size"].partition("x")
    with serve(dataset, options=options, progress=_line) as session:
        if session.client._request("/")[0] != 200:
            raise PictureFailed("the page was not found next to this program", hint="install all of it, or build it: npm --prefix web-client run build")
        setting = {snake(name): value for name, value in job["surface"].items()}
        if "rake" in job:
            setting["rake"] = session.api.rake.set(**job["rake"])["rake"]
            setting.setdefault("to", last_time(session, {"dataset": session.dataset, **setting}))
        elif setting["kind"] != "level":
            found = session.client.suggest(session.dataset)
            setting["rake"] = session.api.rake.set(**{**found["rake"], "seeds": job["seeds"]})["rake"]
            ends = " ".join(",".join(f"{each:g}" for each in point) for point in found["rake"]["points"])
            print(f"wakesurf: without --rake: {found['why']} It is --rake \"{ends}\"", file=sys.stderr)
        if "rake2" in job:
            setting["rake2"] = session.api.rake.set(**job["rake2"])["rake"]
        stats: Any = begin(session, session.dataset, setting).wait(progress=_line)
        if "empty" in stats:
            raise PictureFailed("the surface is empty: " + stats["empty"]["message"], hint=stats["empty"]["hint"])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            drawn = session.picture(output, (int(width), int(height)), view={"look": {"points": job["points"]}})
        print(f"{output}: {width} x {height} pixels of {stats['quads']} quads, separation {stats['separation']:.4g}"
              + (", too small for the scalar bar" if drawn.bar_left_out else ""))


def _line(progress: Progress) -> None:
    if sys.stderr.isatty():
        share = "" if progress.share is None else f"{100 * progress.share:3.0f} % "
        print(f"\r{share}{progress.message:60.60}", end="\r" if progress.share != 1.0 else "\r\033[K", file=sys.stderr)
