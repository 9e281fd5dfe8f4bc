"""One task of a study: a surface on a rake in a case, made by whichever worker gets it, and its files, which say what they are of.

A task leaves PLACE.csv with its numbers, as `wakesurf surface -o NAME.csv` writes them, the files asked for, and last PLACE.json, which has the
fingerprint of what was asked. Only a task with that is done. All files are renamed into their place, and depend on nothing but the task.
"""
from __future__ import annotations

import hashlib
import json
import os
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from typing import Dict, Iterator, Optional, Tuple

from .client import Client
from .errors import BrowserMissing, ServerMissing, WakesurfError
from .files import write_whole
from .generated.version import VERSION
from .kept_server import kept_server, lost
from .plain import Json
from .surface import Surface, begin

FATAL = (ServerMissing, BrowserMissing, ImportError)  # each task would fail with them
_LONGEST = 600.0  # seconds for a file


@dataclass(frozen=True)
class Work:
    """What all tasks of a study have in common. `values`: checksums of the datasets of `url`, by their ids. `query`: of the numbers.
    `study`: another one each time that a study is begun."""

    folder: str
    url: Optional[str]
    values: Dict[str, str]
    options: Json
    files: Tuple[str, ...]
    query: Dict[str, str]
    picture: Json
    timeout: Optional[float]
    study: str


@dataclass(frozen=True)
class Task:
    """One combination. `place`: of its files below the folder, without an extension. `data`: what tells the file of the case from others at its
    path, as the study was begun; empty where it is none."""

    names: Dict[str, str]
    place: str
    case: str
    rake: Optional[Json]
    setting: Json
    data: str = ""


@dataclass(frozen=True)
class Answer:
    """What came out: facts and the text of the numbers, or the error in words."""

    facts: Json = field(default_factory=dict)
    numbers: str = ""
    error: str = ""


def fingerprint(work: Work, task: Task) -> str:
    """Returns a checksum of all that the files depend on; where, and how fast, they are made is no part of it."""
    asked: Json = {"version": VERSION, "case": task.case, "data": task.data, "values": work.values.get(task.case, ""), "rake": task.rake, "setting": task.setting,
                   "options": list(work.options["options"]), "files": work.files, "query": work.query,
                   "picture": work.picture if "png" in work.files else {}}
    return hashlib.sha256(json.dumps(asked, sort_keys=True).encode()).hexdigest()


def kept(work: Work, task: Task) -> Optional[Answer]:
    """Returns what is there already of the very same task; None if it is not done, or a file is missing."""
    try:
        with open(_path(work, task, "json"), encoding="utf-8") as file:
            record = json.load(file)
        if record["fingerprint"] != fingerprint(work, task) or any(os.path.getsize(_path(work, task, extension)) != size
                                                                   for extension, size in record["files"].items()):
            return None
        with open(_path(work, task, "csv"), encoding="utf-8", newline="") as file:
            return Answer(record["facts"], file.read())
    except (OSError, ValueError, LookupError, TypeError, AttributeError):
        return None


def done(work: Work, task: Task) -> Answer:
    """Does a task, in any process and thread, and writes its files. Error: those that are not the task's own, such as Unreachable where the server
    has died: it may be done again. What is wrong with the task itself is in the answer."""
    try:
        with _client(work, task) as client, client.scratch("study") as session:
            setting = dict(task.setting)
            clipped = False
            if task.rake is not None:
                made = session.api.rake.set(**task.rake)
                setting["rake"], clipped = made["rake"], made["clipped"]
            surface = begin(session, client.dataset if work.url is None else task.case, setting)
            return _written(work, task, surface, clipped)
    except FATAL:
        raise
    except (WakesurfError, OSError, ValueError) as problem:
        if lost(problem):
            raise
        return Answer(error=str(problem) or type(problem).__name__)


@contextmanager
def _client(work: Work, task: Task) -> Iterator[Client]:
    if work.url is not None:
        yield Client(work.url)
    else:
        with kept_server(task.case, task.data, work.options, work.study) as client:
            yield client


def _written(work: Work, task: Task, surface: Surface, clipped: bool) -> Answer:
    stats = surface.wait(work.timeout, checked=True)
    numbers = surface._numbers_text(work.query, _LONGEST)
    facts = {"clipped": clipped, "quads": stats["quads"], "separation": stats["separation"], "coarsened": stats["coarsened"]}
    bodies = {"csv": numbers.encode(), **{each: _body(work, surface, each) for each in work.files}}
    os.makedirs(os.path.dirname(_path(work, task, "csv")), exist_ok=True)
    with suppress(FileNotFoundError):
        os.remove(_path(work, task, "json"))  # of something else, whose files these replace one by one
    for extension, body in bodies.items():
        write_whole(_path(work, task, extension), [body])
    record = {"fingerprint": fingerprint(work, task), "names": task.names, "task": {"case": task.case, "rake": task.rake, "setting": task.setting},
              "facts": facts, "files": {extension: len(body) for extension, body in bodies.items()}}
    write_whole(_path(work, task, "json"), [json.dumps(record, indent=1).encode()])
    return Answer(facts, numbers)


def _body(work: Work, surface: Surface, extension: str) -> bytes:
    if extension == "png":
        return surface.session.picture(**work.picture).data
    return surface.download(extension, _LONGEST, time="end")


def _path(work: Work, task: Task, extension: str) -> str:
    return os.path.join(work.folder, f"{task.place}.{extension}")
