"""What the generated modules build on: the calls of methods, and notifications."""
from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import Any, ClassVar, Optional, Protocol

from .names import Helpful
from .plain import Json


class LeftOut(enum.Enum):
    """The default of a parameter for which None is a value."""

    LEFT_OUT = "left out"


LEFT_OUT = LeftOut.LEFT_OUT


class ApiCall(Protocol):
    """The type of Client.call and Connection.call: a parameter that is None is left out, one that is NULL is null."""

    def __call__(self, method: str, _timeout: Optional[float] = None, /, **parameters: Any) -> Any: ...


class Noun(Helpful):
    """The methods of one noun, in a session or in none."""

    def __init__(self, call: ApiCall, session: Optional[str]) -> None:
        self.__call, self.__session = call, session

    def _call(self, method: str, parameters: Json) -> Any:
        given = {name: value for name, value in parameters.items() if value is not None and value is not LEFT_OUT}
        if "session" in parameters and "session" not in given and self.__session is not None:
            given["session"] = self.__session
        return self.__call(method, None, **given)


@dataclass(frozen=True)
class Notification:
    """A notification of the server. `method` is its name, as session.patched."""

    method: ClassVar[str] = ""


@dataclass(frozen=True)
class UnknownNotification(Notification):
    """A notification that this client does not know, from a newer server."""

    name: str
    params: Json
