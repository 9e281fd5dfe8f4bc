"""What can go wrong, as exceptions. Each has `code`, `kind`, `hint` and `data` as the server gave them."""
from __future__ import annotations

from typing import Any, Mapping, Optional, Tuple

from .own_words import in_python
from .plain import Json

__all__ = ["WakesurfError", "InvalidRequest", "InvalidParameters", "InvalidPoints", "UnknownParameter", "MissingParameter", "MethodNotFound",
           "Unauthenticated", "NotPermitted", "NotFound", "NoSuchArray", "Stale", "Leased", "Cancelled", "OutsideDomain", "OutsideTimeRange", "OverLimit",
           "DatasetError", "ServerFault", "Unreachable", "WaitTimeout", "ServerMissing", "ServerFailed", "BrowserMissing",
           "PictureFailed", "error_of"]


class WakesurfError(Exception):
    """What the server refused, or why it could not be asked."""

    def __init__(self, message: str, code: int = 0, kind: str = "", hint: str = "", data: Optional[Json] = None):
        super().__init__(message + (f" ({hint})" if hint else ""))
        self.message, self.code, self.kind, self.hint = message, code, kind, hint
        self.data: Json = data or {}
        self.told: Optional[Tuple[str, str]] = None  # message and hint as the server has them, with the names of its API


class InvalidRequest(WakesurfError):
    """Not a call, too long, or a method that needs a WebSocket."""


class InvalidParameters(WakesurfError):
    """A parameter is missing, unknown, malformed or out of range; the message names it."""


class UnknownParameter(InvalidParameters, TypeError):
    """There is no parameter of this name; the hint says which one may be meant."""


class MissingParameter(InvalidParameters, TypeError):
    """A parameter that has no default is left out; the hint says what it is."""


class MethodNotFound(WakesurfError):
    """This server has no such method: it may be older than this client."""


class Unauthenticated(WakesurfError):
    """No token, or not a valid one."""


class NotPermitted(WakesurfError):
    """The role of the token does not allow it."""


class NotFound(WakesurfError):
    """There is no such session, record or dataset."""


class Stale(WakesurfError):
    """`if_rev` is not the record's revision; `current` is the record."""

    @property
    def current(self) -> Json:
        return dict(self.data.get("current", {}))


class Leased(WakesurfError):
    """Someone else is dragging the rake: `by` whom, `until` when."""

    @property
    def by(self) -> str:
        return str(self.data.get("by", ""))

    @property
    def until(self) -> str:
        return str(self.data.get("until", ""))


class Cancelled(WakesurfError):
    """The work was replaced by a newer edit."""


class OutsideDomain(WakesurfError):
    """The message says by how much."""


class OutsideTimeRange(WakesurfError):
    """Not within the dataset's times."""


class InvalidPoints(InvalidParameters, TypeError, ValueError):
    """What was given for points is none: too few, not three numbers each, or not numbers."""


class NoSuchArray(WakesurfError, KeyError):
    """A mesh has no array of this name; the message says which there are and how to ask for others."""

    __str__ = WakesurfError.__str__  # that of a KeyError is in quotes


class OverLimit(WakesurfError):
    """More than the server grants."""


class DatasetError(WakesurfError):
    """The data are unreadable or damaged."""


class ServerFault(WakesurfError):
    """A fault of the server; its log has the details."""


class Unreachable(WakesurfError, ConnectionError):
    """No one answers at the address, or the connection broke."""


class WaitTimeout(WakesurfError, TimeoutError):
    """It was not there in time; a surface is still being computed."""


class ServerMissing(WakesurfError, FileNotFoundError):
    """`serve` finds no program wakesurf on this machine; the message says how to get it."""


class ServerFailed(WakesurfError):
    """The server that `serve` started has ended; the message is what it said."""


class BrowserMissing(WakesurfError, FileNotFoundError):
    """Pictures need Chromium, which is not on this machine."""


class PictureFailed(WakesurfError):
    """The page could not draw it; the message says why."""


def error_of(fault: Mapping[str, Any]) -> WakesurfError:
    """The exception for the `error` of an answer."""
    from .generated.error_codes import BY_CODE  # which needs the classes above
    data = dict(fault.get("data") or {})
    kind = BY_CODE.get(fault.get("code", 0), WakesurfError)
    told = str(fault.get("message", "")), str(data.pop("hint", ""))
    problem = kind(in_python(told[0]), fault.get("code", 0), data.pop("kind", ""), in_python(told[1]), data)
    problem.told = told
    return problem
