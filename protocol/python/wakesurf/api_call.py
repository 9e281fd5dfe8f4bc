"""What the methods in generated/methods call."""
from __future__ import annotations

import enum
from typing import Any, Optional, Protocol

from .names import Helpful
from .plain import Json


class LeftOut(enum.Enum):
    """A parameter that is left out, where None means something."""

    LEFT_OUT = "left out"


LEFT_OUT = LeftOut.LEFT_OUT


class ApiCall(Protocol):
    """Client.call and Connection.call: what is None is left out, what is NULL is null."""

    def __call__(self, method: str, _timeout: Optional[float] = None, /, **parameters: Any) -> Any: ...


class Noun(Helpful):
    """Methods of one noun, in a session or in none."""

    def __init__(self, call: ApiCall, session: Optional[str]) -> None:
        self.__call, self.__session = call, session

    def _call(self, method: str, parameters: Json) -> Any:
        given = {name: value for name, value in parameters.items() if value is not None and value is not LEFT_OUT}
        if "session" in parameters and "session" not in given and self.__session is not None:
            given["session"] = self.__session
        return self.__call(method, None, **given)
