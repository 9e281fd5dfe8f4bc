"""What the server tells by itself, as `Session.watch` gives it: `wakesurf.notifications.SessionPatched`."""
from .generated.notifications import (CachePatched, DatasetPatched, PresencePatched, ServerNotice, SessionPatched,
                                      SurfaceDone, SurfaceProgress, WorkProgress)
from .notification import Notification, UnknownNotification

__all__ = ["CachePatched", "DatasetPatched", "Notification", "PresencePatched", "ServerNotice", "SessionPatched", "SurfaceDone",
           "SurfaceProgress", "UnknownNotification", "WorkProgress"]
