"""The errors, as exceptions. Each has `code`, `kind`, `hint` and `data` as the server gave them."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

__all__ = ["WakesurfError", "InvalidRequest", "InvalidParameters", "InvalidPoints", "UnknownParameter", "MissingParameter", "MethodNotFound",
           "Unauthenticated", "NotPermitted", "NotFound", "NoSuchArray", "Stale", "Leased", "Cancelled", "OutsideDomain", "OutsideTimeRange", "OverLimit",
           "DatasetError", "ServerFault", "Unreachable", "WaitTimeout", "ServerMissing", "ServerFailed", "BrowserMissing",
           "PictureFailed", "WorkersLost"]


class WakesurfError(Exception):
    """The server refused the request, or could not be reached."""

    def __init__(self, message: str, code: int = 0, kind: str = "", hint: str = "", data: Optional[Dict[str, Any]] = None):
        super().__init__(message + (f" ({hint})" if hint else ""))
        self.message, self.code, self.kind, self.hint = message, code, kind, hint
        self.data: Dict[str, Any] = data or {}
        self.original: Optional[Tuple[str, str]] = None  # message and hint as the server sent them, with the names of its API


class InvalidRequest(WakesurfError):
    """The request is no call, too long, or needs a WebSocket."""


class InvalidParameters(WakesurfError):
    """A parameter is missing, unknown, malformed or out of range; the message names it."""


class UnknownParameter(InvalidParameters, TypeError):
    """There is no parameter of this name; the hint says which one may be meant."""


class MissingParameter(InvalidParameters, TypeError):
    """A parameter that has no default is left out; the hint says what it is."""


class MethodNotFound(WakesurfError):
    """This server has no such method: it may be older than this client."""


class Unauthenticated(WakesurfError):
    """The token is missing or invalid."""


class NotPermitted(WakesurfError):
    """The role of the token does not allow it."""


class NotFound(WakesurfError):
    """There is no such session, record or dataset."""


class Stale(WakesurfError):
    """`if_rev` is not the record's revision; `current` is the record."""

    @property
    def current(self) -> Dict[str, Any]:
        return dict(self.data.get("current", {}))


class Leased(WakesurfError):
    """Another client is dragging the rake: `by` whom, `until` when."""

    @property
    def by(self) -> str:
        return str(self.data.get("by", ""))

    @property
    def until(self) -> str:
        return str(self.data.get("until", ""))


class Cancelled(WakesurfError):
    """The work was replaced by a newer edit."""


class OutsideDomain(WakesurfError):
    """A point is outside of the domain; the message says by how much."""


class OutsideTimeRange(WakesurfError):
    """The time is not within the dataset's times."""


class InvalidPoints(InvalidParameters, TypeError, ValueError):
    """The points are invalid: too few, not three numbers each, or not numbers."""


class NoSuchArray(WakesurfError, KeyError):
    """A mesh has no array of this name; the message lists those it has and says how to ask for others."""

    __str__ = WakesurfError.__str__  # that of a KeyError is in quotes


class OverLimit(WakesurfError):
    """The request is for more than the server grants."""


class DatasetError(WakesurfError):
    """The data are unreadable or damaged."""


class ServerFault(WakesurfError):
    """The server has a fault; its log has the details."""


class Unreachable(WakesurfError, ConnectionError):
    """The address does not answer, or the connection broke."""


class WaitTimeout(WakesurfError, TimeoutError):
    """The result was not there in time; a surface is still being computed."""


class ServerMissing(WakesurfError, FileNotFoundError):
    """`serve` finds no program wakesurf on this machine; the message says how to get it."""


class ServerFailed(WakesurfError):
    """The server that `serve` started has ended; the message is its last output, `code` its status: negative for a signal, 0 if it did
    not start in time."""


class BrowserMissing(WakesurfError, FileNotFoundError):
    """Pictures need Chromium, which is not on this machine."""


class PictureFailed(WakesurfError):
    """The page could not draw it; the message says why."""


class WorkersLost(WakesurfError):
    """The executor of a study has lost its workers and takes no more tasks; a new study in the same folder does the rest."""
