"""The clock: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional, TypedDict


ClockRecord = TypedDict("ClockRecord", {  # The clock of a session.
    "time": "Optional[float]",  # simulation time; null: it was never set, and surfaces are shown at their end (the ...
    "playing": "bool",  # true: the clock runs
    "speed": "float",  # how fast the clock runs (simulation time a second)
    "loop": "bool",  # true: the clock goes on at `from` when it reaches `to`
    "from": "Optional[float]",  # time at which playing starts; null before the clock was first played (the ...
    "to": "Optional[float]",  # time at which playing ends; null before the clock was first played (the dataset's ...
}, total=False)


class ClockAnswer(TypedDict, total=False):
    """The clock after the call."""

    clock: ClockRecord  # the clock as it is now
