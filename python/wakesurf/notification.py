"""The notifications of a server."""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any, ClassVar, Mapping

from .names import snake
from .plain import Json


@dataclass(frozen=True)
class Notification:
    """Holds one message. `method` is its name, as session.patched."""

    method: ClassVar[str] = ""


@dataclass(frozen=True)
class UnknownNotification(Notification):
    """Holds a message that this client does not know, from a newer server."""

    name: str
    params: Json


def notification_of(method: str, params: Mapping[str, Any]) -> Notification:
    """Returns an object of `wakesurf.notifications`; members that this client does not know are left out."""
    from .generated.notifications import BY_METHOD  # which needs the classes above
    kind = BY_METHOD.get(method)
    values = {snake(name): value for name, value in params.items()}
    if kind is not None:
        fields = dataclasses.fields(kind)
        if all(each.name in values for each in fields if each.default is dataclasses.MISSING):
            return kind(**{each.name: values[each.name] for each in fields if each.name in values})
    return UnknownNotification(method, dict(params))
