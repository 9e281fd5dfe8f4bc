"""The server's notifications, as `Session.watch` returns them: `wakesurf.notifications.SessionPatched`."""
import dataclasses
from typing import Any, Mapping

from .api_base import Notification, UnknownNotification
from .generated.notifications import (BY_METHOD, CachePatched, DatasetPatched, PresencePatched, ServerNotice, SessionPatched,
                                      SurfaceDone, SurfaceProgress, WorkProgress)
from .names import snake

__all__ = ["CachePatched", "DatasetPatched", "Notification", "PresencePatched", "ServerNotice", "SessionPatched", "SurfaceDone",
           "SurfaceProgress", "UnknownNotification", "WorkProgress"]


def notification_of(method: str, params: Mapping[str, Any]) -> Notification:
    """Returns the object for a message; members that this client does not know are left out."""
    kind = BY_METHOD.get(method)
    values = {snake(name): value for name, value in params.items()}
    if kind is not None:
        fields = dataclasses.fields(kind)
        if all(each.name in values for each in fields if each.default is dataclasses.MISSING):
            return kind(**{each.name: values[each.name] for each in fields if each.name in values})
    return UnknownNotification(method, dict(params))
