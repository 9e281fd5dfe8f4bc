"""The server: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from ...api_call import Noun
from ...names import named
from ...plain import Json
from ..records import ServerInfoResult, ServerStatsResult


class ServerMethods(Noun):
    """The server."""

    @named
    def info(self) -> ServerInfoResult:
        """Reports what this server is, what it offers, and what its limits are.

        For example:

            api.server.info()
        """
        answer: ServerInfoResult = self._call("server.info", {})
        return answer

    @named
    def ping(self) -> Json:
        """Returns at once. Clients use it as their heartbeat.

        For example:

            api.server.ping()
        """
        answer: Json = self._call("server.ping", {})
        return answer

    @named
    def stats(self) -> ServerStatsResult:
        """Reports how long each stage from an edit to the socket took in the last minute, and how the server is
        doing. With a share link it returns only participants, surfaces, stages and firstFrame, where participants
        and surfaces are those of the link's session.

        Error: NotFound.

        For example:

            api.server.stats()
        """
        answer: ServerStatsResult = self._call("server.stats", {})
        return answer
