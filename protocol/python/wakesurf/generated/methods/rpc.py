"""About calls: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Union

from ...api_call import Noun
from ...names import named
from ...plain import Json
from ..records import RpcDiscoverResult


class RpcMethods(Noun):
    """About calls."""

    @named
    def discover(self) -> RpcDiscoverResult:
        """Returns this description as an OpenRPC document: every method with its parameters. The example shows only
        a part of the document.

        For example:

            api.rpc.discover()
        """
        answer: RpcDiscoverResult = self._call("rpc.discover", {})
        return answer

    @named
    def cancel_request(self, *, id: Union[str, int]) -> Json:
        """A notification. The open call of this WebSocket with this id fails at once with the error -32800, and its
        work stops. What an edit has changed stays changed.

        `id`: id of the call.

        Only on a `Connection`.

        For example:

            api.rpc.cancel_request(id=12345)
        """
        answer: Json = self._call("$/cancelRequest", {"id": id})
        return answer
