"""The server's notifications, as `Session.watch` returns them: `wakesurf.notifications.SessionPatched`."""
from .generated.notifications import (CachePatched, DatasetPatched, PresencePatched, ServerNotice, SessionPatched,
                                      SurfaceDone, SurfaceProgress, WorkProgress)
from .notification import Notification, UnknownNotification

__all__ = ["CachePatched", "DatasetPatched", "Notification", "PresencePatched", "ServerNotice", "SessionPatched", "SurfaceDone",
           "SurfaceProgress", "UnknownNotification", "WorkProgress"]
