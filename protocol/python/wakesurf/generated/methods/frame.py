"""Mesh frames: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional

from ...api_call import Noun
from ...names import named
from ...plain import Json


class FrameMethods(Noun):
    """Mesh frames."""

    @named
    def ack(self, *, subscription: int, seq: int, epoch: Optional[int] = None) -> Json:
        """Reports the last update of a subscription that the client has applied. The server then sends at most eight
        updates beyond the reported one. Best sent as a notification.

        `subscription`: number of the subscription; 0 or more.
        `seq`: number of the update in its epoch; 0 or more.
        `epoch`: epoch of the update; if left out, the surface's current one; 0 or more.

        Error: NotFound. Only on a `Connection`.

        For example:

            api.frame.ack(subscription=1, epoch=1, seq=0)
        """
        answer: Json = self._call("frame.ack", {"subscription": subscription, "seq": seq, "epoch": epoch})
        return answer
