"""Time-steps in memory: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from ...api_call import Noun
from ...names import named
from ..records import CacheStatus


class CacheMethods(Noun):
    """Time-steps in memory."""

    @named
    def status(self, *, dataset: str) -> CacheStatus:
        """Reports which time-steps of a dataset are in memory.

        `dataset`: an id from dataset.list.

        Error: NotFound, DatasetError.

        For example:

            api.cache.status(dataset='lamb-oseen')
        """
        answer: CacheStatus = self._call("cache.status", {"dataset": dataset})
        return answer
