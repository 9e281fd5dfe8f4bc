"""The clock: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional

from ...api_call import Noun
from ...names import named
from ...plain import NULL
from ..records import ClockAnswer


class TimeMethods(Noun):
    """The clock."""

    @named
    def set(self, *, time: Optional[float], session: Optional[str] = None) -> ClockAnswer:
        """Jumps to a time of the data. Path, streak and time surfaces are shown as they are at this time, within
        their own `from` and `to`. A time that neither the data of the session's surfaces nor a surface has is
        refused; any will do where a surface is of a flow that is steady or a formula.

        `time`: simulation time; null: no time, and surfaces are shown at their end (the dataset's unit of time); -1e+30
            or more.

        Error: NotFound, OutsideTimeRange. For editors.

        For example:

            api.time.set(session='main', time=1)
        """
        answer: ClockAnswer = self._call("time.set", {"session": session, "time": NULL if time is None else time})
        return answer

    @named
    def play(self, *, speed: Optional[float] = None, loop: Optional[bool] = None, from_: Optional[float] = None,
             to: Optional[float] = None, session: Optional[str] = None) -> ClockAnswer:
        """Starts the clock, from where it stands or from the beginning. `from` and `to` are times of the data, as in
        `time.set`.

        `speed`: how fast the clock runs; if left out, as before, at first 1 (simulation time a second); 1e-09 to
            1,000,000.
        `loop`: true: go on at `from_` when the clock reaches `to`; if left out, as before, at first false.
        `from_`: time at which playing starts; if left out, as before, at first where the first surface begins (the
            dataset's unit of time); -1e+30 or more.
        `to`: time at which playing ends; if left out, as before, at first where the last surface ends (the dataset's
            unit of time); -1e+30 or more.

        Error: NotFound, OutsideTimeRange. For editors.

        For example:

            api.time.play(session='main', speed=2, loop=True, from_=0, to=2)
        """
        answer: ClockAnswer = self._call("time.play", {"session": session, "speed": speed, "loop": loop, "from": from_,
                                                       "to": to})
        return answer

    @named
    def pause(self, *, session: Optional[str] = None) -> ClockAnswer:
        """Stops the clock where it is.

        Error: NotFound. For editors.

        For example:

            api.time.pause(session='main')
        """
        answer: ClockAnswer = self._call("time.pause", {"session": session})
        return answer
