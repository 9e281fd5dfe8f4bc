"""The progress of work, for a function or for a bar of tqdm.

A function is called with `Progress`. A bar, which is anything with `n`, `total` and `refresh()`, is moved: with a total of its
own in shares of that, else over 100.

    from tqdm import tqdm
    surface.wait(progress=tqdm(total=100))
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Protocol, Union, cast

from .generated.notifications import WorkProgress
from .generated.records import Statistics
from .notification import Notification

if TYPE_CHECKING:
    from .connection import Connection
    from .session import Session

_LONGEST_WAIT_MS = 60_000


@dataclass(frozen=True)
class Progress:
    """Holds `share` from 0 to 1, or None if unknown; `message` for people; `state`: the newest statistics of a
    surface, if there are any."""

    share: Optional[float]
    message: str = ""
    state: Optional[Mapping[str, Any]] = None


class Bar(Protocol):
    """Describes tqdm's bar."""

    n: Any
    total: Any

    def refresh(self) -> Any: ...


Told = Union[Callable[[Progress], Any], Bar]


class Report:
    """Reports progress to the function or bar, if there is one."""

    def __init__(self, tell: Optional[Callable[[Progress], Any]]) -> None:
        self._tell = tell
        self._share: Optional[float] = None

    @staticmethod
    def to(told: Optional[Told]) -> Report:
        if told is None:
            return Report(None)
        if hasattr(told, "refresh") and hasattr(told, "n"):
            bar = cast(Bar, told)
            return Report(lambda progress: _move(bar, progress))
        return Report(told)

    @property
    def wanted(self) -> bool:
        return self._tell is not None

    def share(self, share: Optional[float], message: str = "", state: Optional[Mapping[str, Any]] = None) -> None:
        if share is not None:
            self._share = share
        if self._tell is not None:
            self._tell(Progress(self._share, message, state))

    def state(self, state: Statistics) -> None:
        self.share(None, "", cast(Mapping[str, Any], state))

    def done(self, message: str, state: Optional[Statistics] = None) -> None:
        self.share(1.0, message, cast(Optional[Mapping[str, Any]], state))


def _move(bar: Bar, progress: Progress) -> None:
    if bar.total is None:
        bar.total = 100
    if progress.share is not None:
        bar.n = round(progress.share * bar.total, 1)
    if progress.message and hasattr(bar, "set_postfix_str"):
        bar.set_postfix_str(progress.message, refresh=False)
    bar.refresh()


class Waiting:
    """Asks for a surface until it is complete. If progress is wanted, over a WebSocket, which reports shares; if that
    fails, over HTTP once a second."""

    def __init__(self, session: Session, report: Report) -> None:
        self._session, self._report = session, report
        self._connection: Optional[Connection] = None
        self.slice_ms = 1000 if report.wanted else _LONGEST_WAIT_MS

    def __enter__(self) -> Waiting:
        if self._report.wanted:
            from .connection import Connection
            try:
                self._connection = Connection(self._session.client, None)
            except ImportError:
                pass
        return self

    def __exit__(self, *_: object) -> None:
        if self._connection is not None:
            self._connection.close()

    def ask(self, surface: str, wait_ms: int) -> Statistics:
        """Returns the answer of `surface.wait`."""
        if self._connection is None:
            stats: Statistics = self._session.call("surface.wait", wait_ms / 1000 + self._session.client.timeout, surface=surface,
                                                   timeoutMs=wait_ms)
            return stats
        number = self._connection.start("surface.wait", session=self._session.id, surface=surface, timeoutMs=wait_ms,
                                        workDoneToken="wait")
        while True:
            answer = self._connection.answer_or_told(number)
            if not isinstance(answer, Notification):
                return cast(Statistics, answer["result"])
            if isinstance(answer, WorkProgress) and answer.value.get("kind") == "report":
                share = answer.value.get("percentage")
                self._report.share(None if share is None else share / 100, str(answer.value.get("message", "")))
