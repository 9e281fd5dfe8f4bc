"""Every method of the server, by noun.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional

from ...api_call import ApiCall
from .annotation import AnnotationMethods
from .bookmark import BookmarkMethods
from .cache import CacheMethods
from .dataset import DatasetMethods
from .family import FamilyMethods
from .frame import FrameMethods
from .history import HistoryMethods
from .presence import PresenceMethods
from .probe import ProbeMethods
from .rake import RakeMethods
from .rpc import RpcMethods
from .server import ServerMethods
from .session import SessionMethods
from .surface import SurfaceMethods
from .time import TimeMethods


class Methods:
    """Every method of the server: `api.rake.set(...)` is `rake.set`. With a session, those that need one take it."""

    def __init__(self, call: ApiCall, session: Optional[str] = None) -> None:
        self.rpc = RpcMethods(call, session)
        self.server = ServerMethods(call, session)
        self.dataset = DatasetMethods(call, session)
        self.cache = CacheMethods(call, session)
        self.probe = ProbeMethods(call, session)
        self.family = FamilyMethods(call, session)
        self.session = SessionMethods(call, session)
        self.presence = PresenceMethods(call, session)
        self.rake = RakeMethods(call, session)
        self.surface = SurfaceMethods(call, session)
        self.frame = FrameMethods(call, session)
        self.bookmark = BookmarkMethods(call, session)
        self.annotation = AnnotationMethods(call, session)
        self.history = HistoryMethods(call, session)
        self.time = TimeMethods(call, session)
