"""Many surfaces on many machines: each rake in each case with each setting, as tasks of an executor that people run already.

    line = lambda y: [(-1.5, y, 0.5), (-1.5, y, 5.5)]
    found = wakesurf.study({f"y={y:g}": line(y) for y in np.linspace(-1, 1, 200)}, "wing.foam", {"kind": "streak"}, "results",
                           files=["vtp"], executor=dask.distributed.Client(...).get_executor())
    print(found)
    table = found.frame()
"""
from __future__ import annotations

import contextlib
import csv
import functools
import glob
import inspect
import io
import itertools
import math
import os
import secrets
import warnings
from concurrent.futures import Executor
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple, Union

from .client import Client
from .errors import InvalidParameters, WakesurfError
from .executing import answers
from .files import write_whole
from .names import check_names, named
from .numbers import Numbers, Times, query_of
from .plain import Json, Points, plain
from .progress import ProgressTarget, Report
from .record import one_of
from .safe_names import safe_names
from .session import Session
from .study_task import Answer, Task, Work, done, kept

_TABLE = "study.csv"
_FORMATS = ("vtp", "glb", "ply", "obj", "drc", "png")
_RAKE = ("line", "polyline", "circle", "points", "seeds")
_SETTING = [name for name in inspect.signature(Session.surface).parameters if name not in ("self", "rake", "dataset", "rake2", "twin", "from_")]
_PICTURE = [name for name in inspect.signature(Session.picture).parameters if name not in ("self", "path")]

Path = Union[str, "os.PathLike[str]"]
AnyRake = Union[Mapping[str, Any], Points, None]
Setting = Mapping[str, Any]


@dataclass(frozen=True)
class Study:
    """What a study has found. `rows`: a dictionary for each surface, and for each time of it if there are several, in the order of cases, settings
    and rakes: their names, numbers (NaN where they are not known) with `notes`, paths of files below `folder`, and `error`, in words, or empty.
    All have the same keys."""

    folder: str
    rows: List[Dict[str, Any]] = field(repr=False)
    units: Dict[str, str]  # of the numbers that have the same one in all rows
    surfaces: int
    kept: int  # surfaces that were there already
    failed: int

    def __str__(self) -> str:
        made = self.surfaces - self.kept - self.failed
        return f"{self.surfaces} surfaces: {made} made, {self.kept} there already, {self.failed} failed; {self.csv}"

    @property
    def csv(self) -> str:
        """Returns the path of the table: all rows, with units in the first line."""
        return os.path.join(self.folder, _TABLE)

    @property
    def failures(self) -> List[Dict[str, Any]]:
        """Returns the rows that have an error."""
        return [row for row in self.rows if row["error"]]

    def frame(self) -> Any:
        """Converts the rows to a pandas DataFrame. Error: ImportError without pandas."""
        try:
            import pandas
        except ImportError:
            raise ImportError("a data frame needs pandas (Debian: python3-pandas); `rows` and study.csv have the same") from None
        return pandas.DataFrame(self.rows)


@named
def study(rakes: Union[Mapping[str, AnyRake], Sequence[AnyRake]], cases: Union[Mapping[str, Path], Sequence[Path], Path],
          settings: Union[Mapping[str, Setting], Sequence[Setting], Setting], folder: Path = "study", *,
          executor: Union[Executor, Callable[[], Executor], None] = None, files: Sequence[str] = (), times: Optional[Times] = None,
          through: Optional[str] = None, fields: Sequence[str] = (), picture: Optional[Mapping[str, Any]] = None, url: Optional[str] = None,
          store: Optional[Path] = None, binary: Optional[Path] = None, memory: Optional[str] = None, threads: Optional[int] = None,
          options: Sequence[str] = (), timeout: Optional[float] = None, tries: int = 3, ahead: Optional[int] = None,
          progress: Optional[ProgressTarget] = None) -> Study:
    """Makes a surface on each rake in each case with each setting, and returns their numbers. Each is a task of `executor`. What is in `folder`
    already, of the very same task, is not made again: a study that was interrupted goes on where it was. Results are the same to the byte, whoever
    makes them and in whatever order.

    `rakes`: by name, or a list: points, which are a line or a polyline, or what `Session.rake` takes, such as {"circle": ..., "seeds": 32}, or
        None: the one that the server suggests. A dictionary whose keys are all among line, polyline, circle, points and seeds is one rake.
    `cases`: by name, a list, or one: files, folders, stores and flows as `serve` takes them; with `url`, ids of datasets. Those of a list are
        named by their files or folders.
    `settings`: by name, a list, or one: what `Session.surface` takes. Only `kind` must be given; the server suggests the rest. Those of a list
        are named by their kinds.
    `folder`: where results go, CASE/SETTING/RAKE.csv and more; all workers must see it at the same path.
    `executor`: of concurrent.futures or like one: threads, processes, Dask's `Client.get_executor()`, mpi4py's MPIPoolExecutor; or a function
        that makes one, which is called again where workers die and take it with them. Left out: threads, as many as there are cores; Ctrl-C
        then waits for the surfaces that they have begun.
    `files`: of each surface at its end: "vtp", "glb", "ply", "obj", "drc", and "png", a picture, with `picture` as `Session.picture` takes it.
    `times`, `through`, `fields`: of the numbers, as `Surface.numbers` takes them; left out, those at the end.
    `url`: a server that all use; left out, each process of workers starts one for a case, keeps it for its next tasks, and ends it a minute after
        the last; it uses two at a time at most, each for eight tasks at most. `store`, `binary`, `memory`, `threads` and `options` as of `serve`:
        give each server its share of a machine.
    `timeout`: seconds for each surface. `tries`: how often a task is begun whose server dies, has a fault or is overloaded, or for which the
        executor raises, as where a worker dies; the last time alone. `ahead`: how many tasks the executor has at a time; left out, twice its
        workers, or 1000 where they are not known.
    `progress`: told how much is done, with `done`, `total`, `kept` and `failed` as its state.

    A task that fails, as on a rake outside of the domain, is a row with its error; it is tried again by the next study. All surfaces of a case
    are made again when the file that names it has another time or size than before; data that change otherwise below the same path, as in a
    folder, are not noticed. Some 2 kB of memory a row. Several threads may call it at once, for different folders.
    Error: InvalidParameters, before anything is begun; WorkersLost, where the executor can do no more; ServerMissing, BrowserMissing.

    >>> lines = {f"{x:g}": [(x, 0.4, 0.1), (x, 0.6, 0.1)] for x in (0.4, 0.5, 9)}
    >>> found = wakesurf.study(lines, "flow:tornado", {"kind": "stream", "to": 2, "separation": 0.1}, "swirl")
    >>> [row["area"] > 0.01 for row in found.rows], found.failures[0]["error"]
    ([True, True, False], 'the rake lies outside the domain by 8 ...
    """
    work = _work(folder, files, times, through, fields, picture, url, store, binary, memory, threads, options, timeout)
    tasks = _Tasks(work, rakes, cases, settings)
    total = len(tasks)
    if tries < 1 or ahead is not None and ahead < 1:
        raise _refused("`tries` and `ahead` are at least 1", "leave them out")
    report, rows, counts = Report.to(progress), _Rows(), {"done": 0, "total": total, "kept": 0, "failed": 0}
    made: Optional[Task] = None

    def take(number: int, task: Task, answer: Answer) -> None:
        rows.add(number, task, answer, work.files)
        counts["done"] += 1
        counts["failed"] += bool(answer.error)
        failed = f", {counts['failed']} failed" if counts["failed"] else ""
        report.share(counts["done"] / total, f"{counts['done']} of {total} surfaces{failed}", dict(counts))

    def fresh() -> Iterator[Tuple[int, Task]]:
        for number, task in enumerate(tasks):
            answer = kept(work, task)
            if answer is None:
                yield number, task
            else:
                counts["kept"] += 1
                take(number, task, answer)

    os.makedirs(work.folder, exist_ok=True)
    with contextlib.closing(answers(fresh(), functools.partial(done, work), executor, tries, ahead)) as found_by_workers:
        for number, task, answer in found_by_workers:
            take(number, task, answer)
            made = task if not answer.error else made
    tasks.remove_parts()
    ordered, units = rows.all()
    found = Study(work.folder, ordered, units, total, counts["kept"], counts["failed"])
    write_whole(found.csv, _csv(found))
    if made is not None and not os.path.exists(os.path.join(work.folder, made.place + ".json")):
        warnings.warn(f"{work.folder} has numbers, but not the files, of what other machines have made: do all see it at this path?", stacklevel=3)
    report.share(1.0, str(found), dict(counts))
    return found


def _work(folder: Path, files: Sequence[str], times: Optional[Times], through: Optional[str], fields: Sequence[str],
          picture: Optional[Mapping[str, Any]], url: Optional[str], store: Optional[Path], binary: Optional[Path], memory: Optional[str],
          threads: Optional[int], options: Sequence[str], timeout: Optional[float]) -> Work:
    wanted = tuple(dict.fromkeys(each.lower().lstrip(".") for each in ([files] if isinstance(files, str) else files)))
    for each in wanted:
        if each not in _FORMATS:
            raise _refused(f"`files` has {each!r}", "one or more of " + ", ".join(_FORMATS))
    check_names(picture or {}, _PICTURE, "`picture`")
    names = [fields] if isinstance(fields, str) else list(fields)
    given = {"store": None if store is None else os.path.abspath(store), "binary": None if binary is None else os.fspath(binary), "memory": memory,
             "threads": threads, "options": list(options)}
    values = {} if url is None else {each["dataset"]: str(each.get("values", "")) for each in Client(url).datasets()}
    return Work(os.path.abspath(folder), url, values, given, wanted, query_of(times, through, "end" if times is None else None, names),
                plain(dict(picture or {}), "picture"), timeout, secrets.token_hex(8))


class _Named(NamedTuple):
    name: str
    safe: str  # as the name of a file or folder
    value: Any


class _Tasks:
    """All combinations, made one at a time: there may be millions."""

    def __init__(self, work: Work, rakes: Any, cases: Any, settings: Any) -> None:
        self._folder = work.folder
        one_case = isinstance(cases, (str, os.PathLike))
        stem = functools.partial(_stem, work)
        self._cases = [each._replace(value=_case(work, each.value)) for each in _named("case", [cases] if one_case else cases, stem)]
        one_setting = isinstance(settings, Mapping) and not all(isinstance(each, Mapping) for each in settings.values())
        self._settings = [each._replace(value=_setting(each.name, each.value))
                          for each in _named("setting", [settings] if one_setting else settings, _kind)]
        one_rake = isinstance(rakes, Mapping) and bool(rakes) and set(rakes) <= set(_RAKE)
        self._rakes = [each._replace(value=_rake(each.name, each.value))
                       for each in _named("rake", [rakes] if one_rake else rakes, lambda i, _: str(i))]

    def remove_parts(self) -> None:
        """Removes what workers that were killed had begun to write."""
        for case, setting in itertools.product(self._cases, self._settings):
            for part in glob.glob(os.path.join(glob.escape(os.path.join(self._folder, case.safe, setting.safe)), "*.part")):
                with contextlib.suppress(OSError):
                    os.remove(part)

    def __len__(self) -> int:
        return len(self._cases) * len(self._settings) * len(self._rakes)

    def __iter__(self) -> Iterator[Task]:
        for case, setting, rake in itertools.product(self._cases, self._settings, self._rakes):
            yield Task({"case": case.name, "setting": setting.name, "rake": rake.name}, os.path.join(case.safe, setting.safe, rake.safe),
                       case.value[0], rake.value, setting.value, case.value[1])


def _named(what: str, given: Any, name_of: Callable[[int, Any], str]) -> List[_Named]:
    """Returns names and values. Error: InvalidParameters for none, and for two of one name."""
    if isinstance(given, Mapping):
        pairs = [(str(name), value) for name, value in given.items()]
        if len({name for name, _ in pairs}) < len(pairs):
            raise _refused(f"two {what}s have the same name", "names are texts: 1 and '1' are the same")
    else:
        pairs = []
        taken: Set[str] = set()
        for i, value in enumerate(given):
            plain_name = name_of(i, value)
            name = next(each for each in itertools.chain([plain_name], (f"{plain_name}-{n}" for n in itertools.count(2))) if each not in taken)
            taken.add(name)
            pairs.append((name, value))
    if not pairs:
        raise _refused(f"there is no {what}", "give at least one")
    return [_Named(name, safe, value) for (name, value), safe in zip(pairs, safe_names([name for name, _ in pairs], [_TABLE]))]


def _is_path(work: Work, case: str) -> bool:
    return work.url is None and not case.startswith(("flow:", "http://", "https://"))


def _stem(work: Work, _: int, case: Any) -> str:
    text: str = os.fspath(case)
    name = os.path.basename(os.path.normpath(text))
    if name.startswith("flow:"):
        return name[len("flow:"):]
    return os.path.splitext(name)[0] if _is_path(work, text) and not os.path.isdir(text) else name


def _kind(_: int, setting: Any) -> str:
    return str(setting.get("kind", "")) if isinstance(setting, Mapping) else ""


def _case(work: Work, case: Any) -> Tuple[str, str]:
    """Returns the case as all workers find it, and what tells its file from others at the same path: also an older one that replaces it."""
    text: str = os.fspath(case)
    if not _is_path(work, text):
        return text, ""
    found = os.stat(text) if os.path.isfile(text) else None
    return os.path.abspath(text), f"{found.st_mtime_ns} {found.st_size}" if found else ""


def _setting(name: str, given: Any) -> Json:
    if not isinstance(given, Mapping):
        raise _refused(f"setting {name!r} is no dictionary", "as in {\"kind\": \"stream\", \"to\": 2}")
    setting = {"from" if each == "from_" else each: value for each, value in given.items()}
    check_names(setting, [*_SETTING, "from"], f"setting {name!r}")
    if "kind" not in setting:
        raise _refused(f"setting {name!r} has no kind", "stream, path, streak, time or level")
    return {each: plain(value, each) for each, value in setting.items() if value is not None}


def _rake(name: str, given: Any) -> Optional[Json]:
    """Checks what can be checked without the data; whether it is inside of them is the task's."""
    if given is None:
        return None
    try:
        if isinstance(given, Mapping):
            check_names(given, _RAKE, "a rake")
            kind, points = one_of(**{each: given[each] for each in _RAKE[:-1] if each in given} or {each: None for each in _RAKE[:-1]})
            return {"kind": kind, "points": points, "seeds": int(given.get("seeds", 32))}
        kind, points = one_of(**{"line" if len(given) == 2 else "polyline": given})
        return {"kind": kind, "points": points, "seeds": 32}
    except (WakesurfError, TypeError, ValueError) as problem:
        raise _refused(f"rake {name!r}: {problem}", "") from None


def _refused(what: str, hint: str) -> InvalidParameters:
    return InvalidParameters(what, -32602, "invalidParameters", hint)


class _Rows:
    """The rows of answers, which come in any order."""

    def __init__(self) -> None:
        self._rows: Dict[int, List[Dict[str, Any]]] = {}
        self._units: Dict[str, set[str]] = {}

    def add(self, number: int, task: Task, answer: Answer, files: Sequence[str]) -> None:
        if answer.error:
            self._rows[number] = [{**task.names, "error": answer.error}]
            return
        numbers = Numbers.from_csv(answer.numbers)
        for name in numbers.columns:
            self._units.setdefault(name, set()).add(numbers.units.get(name, ""))
        paths = {each: f"{task.place}.{each}" for each in files}
        self._rows[number] = [{**task.names, **answer.facts, **numbers.row(i), "notes": numbers.notes[i], **paths, "error": ""}
                              for i in range(len(numbers))]

    def all(self) -> Tuple[List[Dict[str, Any]], Dict[str, str]]:
        rows = [row for number in sorted(self._rows) for row in self._rows[number]]
        columns = dict.fromkeys(itertools.chain.from_iterable(rows))
        columns["error"] = columns.pop("error", None)  # the last
        blank = {name: math.nan if name in self._units else None for name in columns}
        return ([{**blank, **row} for row in rows],
                {name: next(iter(units)) for name, units in self._units.items() if len(units) == 1 and "" not in units})


def _csv(found: Study) -> Iterator[bytes]:
    """Writes rows as spreadsheets read them; what is not known is empty."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([f"{name} [{found.units[name]}]" if name in found.units else name for name in found.rows[0]])
    for row in found.rows:
        writer.writerow(["" if isinstance(value, float) and math.isnan(value) else value for value in row.values()])
        yield text.getvalue().encode(errors="backslashreplace")
        text.seek(0)
        text.truncate()
