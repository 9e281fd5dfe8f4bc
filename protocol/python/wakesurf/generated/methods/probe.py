"""Values at points: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Optional, Sequence

from ...api_call import Noun
from ...names import named
from ...plain import Points
from ..records import ProbeSampleResult


class ProbeMethods(Noun):
    """Values at points."""

    @named
    def sample(self, *, dataset: str, points: Points, time: float,
               fields: Optional[Sequence[str]] = None) -> ProbeSampleResult:
        """Returns the values of fields at points and one time, interpolated as at the vertices of surfaces.

        `dataset`: an id from dataset.list.
        `points`: points to sample (the dataset's unit of length).
        `time`: simulation time, in the dataset's range (the dataset's unit of time).
        `fields`: name of the velocity, or names of scalar fields; if left out, the velocity.

        Error: NotFound, OutsideDomain, OutsideTimeRange, OverLimit, DatasetError.

        For example:

            api.probe.sample(dataset='lamb-oseen', points=[[0, 0, 0], [50, 0, 0]], time=0)
        """
        answer: ProbeSampleResult = self._call("probe.sample", {"dataset": dataset, "points": points, "time": time,
                                                                "fields": fields})
        return answer
