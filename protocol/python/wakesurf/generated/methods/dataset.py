"""Datasets: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional, Union

from ...api_call import Noun
from ...names import named
from ..records import Dataset, DatasetEntry, DatasetListResult, DatasetSuggestResult


class DatasetMethods(Noun):
    """Datasets."""

    @named
    def list(self) -> DatasetListResult:
        """Lists the datasets that this server serves.

        For example:

            api.dataset.list()
        """
        answer: DatasetListResult = self._call("dataset.list", {})
        return answer

    @named
    def describe(self, *, dataset: str) -> Dataset:
        """Returns the grid, times, fields and lattice of one dataset, in the shape of `wakesurf info --json`, and
        the names that `fields` of surface.set accepts.

        `dataset`: an id from dataset.list.

        Error: NotFound, DatasetError.

        For example:

            api.dataset.describe(dataset='lamb-oseen')
        """
        answer: Dataset = self._call("dataset.describe", {"dataset": dataset})
        return answer

    @named
    def open(self, *, dataset: str, timeout_ms: Optional[int] = None, velocity: Optional[str] = None,
             work_done_token: Optional[Union[str, int]] = None) -> DatasetEntry:
        """Returns once a dataset is imported. An import that was stopped goes on where it ended. $/cancelRequest
        ends the waiting, and the import with it if no one else waits for it. A lost connection does not end an
        import. The state is `importing` if `timeoutMs` ran out, and `incomplete` if the import ended before the last
        time-step.

        `dataset`: an id from dataset.list.
        `timeout_ms`: how long to wait, at most; 0: do not wait (ms); 0 to 600,000; default 600,000.
        `velocity`: velocity of files in which it is not clear, by name: a vector, three scalars `u,v,w`, or a momentum
            and its density; empty: by the names of the fields. For editors; it is kept beside the imported data.
            `velocities` of a dataset that failed lists what could be meant.
        `work_done_token`: on a WebSocket: $/progress reports the progress of the work with this token.

        Error: NotFound, OverLimit, DatasetError.

        For example:

            api.dataset.open(dataset='lamb-oseen', timeout_ms=60000)
        """
        answer: DatasetEntry = self._call("dataset.open", {"dataset": dataset, "timeoutMs": timeout_ms,
                                                           "velocity": velocity, "workDoneToken": work_done_token})
        return answer

    @named
    def suggest(self, *, dataset: str) -> DatasetSuggestResult:
        """Returns a rake and the parameters of a surface of each kind to begin with, found in the data: the rake
        stands ahead of a body that the flow meets, else where the flow turns, else where it enters. All surfaces are
        shown at the same time. Reads one or two time-steps.

        `dataset`: an id from dataset.list.

        Error: NotFound, OverLimit, DatasetError.

        For example:

            api.dataset.suggest(dataset='sphere')
        """
        answer: DatasetSuggestResult = self._call("dataset.suggest", {"dataset": dataset})
        return answer
