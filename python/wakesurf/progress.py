"""The progress of work, for a function or for a bar of tqdm.

A function is called with `Progress`. A bar, which is anything with `n`, `total` and `refresh()`, is moved: with a total of its
own in shares of that, else over 100.

    from tqdm import tqdm
    surface.wait(progress=tqdm(total=100))
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Mapping, Optional, Protocol, Union, cast

from .generated.records import Statistics


@dataclass(frozen=True)
class Progress:
    """`share` from 0 to 1, or None if unknown; `message` for people; `state`: the newest statistics of a
    surface, if there are any."""

    share: Optional[float]
    message: str = ""
    state: Optional[Mapping[str, Any]] = None


class Bar(Protocol):
    """The members of tqdm's bar that are used."""

    n: Any
    total: Any

    def refresh(self) -> Any: ...


ProgressTarget = Union[Callable[[Progress], Any], Bar]


class Report:
    """Reports progress to the function or bar, if there is one."""

    def __init__(self, function: Optional[Callable[[Progress], Any]]) -> None:
        self._function = function
        self._share: Optional[float] = None

    @staticmethod
    def to(target: Optional[ProgressTarget]) -> Report:
        if target is None:
            return Report(None)
        if hasattr(target, "refresh") and hasattr(target, "n"):
            bar = cast(Bar, target)
            return Report(lambda progress: _move(bar, progress))
        return Report(target)

    @property
    def wanted(self) -> bool:
        return self._function is not None

    def share(self, share: Optional[float], message: str = "", state: Optional[Mapping[str, Any]] = None) -> None:
        if share is not None:
            self._share = share
        if self._function is not None:
            self._function(Progress(self._share, message, state))

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
