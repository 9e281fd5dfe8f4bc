"""Families of stream surfaces: methods of the server.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import Literal, Optional, Union

from ...api_call import Noun
from ...names import named
from ...plain import Json, Point, Points
from ..records import Family


class FamilyMethods(Noun):
    """Families of stream surfaces."""

    @named
    def make(self, *, dataset: str, name: str, from_: Literal["inflow", "plane", "curve"], scalar: Optional[str] = None,
             point: Optional[Point] = None, normal: Optional[Point] = None,
             rake_kind: Optional[Literal["line", "polyline", "circle", "points"]] = None,
             points: Optional[Points] = None, time: Optional[float] = None,
             accuracy: Optional[Literal["fast", "balanced", "exact"]] = None, length: Optional[float] = None,
             work_done_token: Optional[Union[str, int]] = None) -> Family:
        """Carries a scalar along the streamlines of one time-step to all nodes of a dataset, and keeps it there as a
        scalar field: surfaces are coloured by it, files and probes have it. Answers once it is kept.
        $/cancelRequest, or a lost connection, ends the work, and nothing is kept.

        `dataset`: an id from dataset.list.
        `name`: name of the field, which no other field may have: letters, digits, and _ - .
        `from_`: where the scalar is given; inflow: on the boundary through which the flow enters; plane: on a plane;
            curve: it is the distance from a curve, in the plane of the curve, so that the level 0 is the stream surface
            through the curve.
        `scalar`: of inflow and plane: x, y or z, or a scalar field of the dataset; empty: y.
        `point`: of a plane: a point of it (the dataset's unit of length).
        `normal`: of a plane: its normal, of any length; the plane counts where the flow passes it the way that most of
            it does (the dataset's unit of length).
        `rake_kind`: of a curve: what the points are, as of a rake: a line, a polyline in one plane, or a circle.
        `points`: of a curve: its points; the ends of a line or a polyline are continued straight.
        `time`: the nearest time-step is taken; if left out, the first one (the dataset's unit of time).
        `accuracy`: how accurately particles are traced and vertices inserted; default balanced.
        `length`: how far a node is followed at most; if left out, ten diagonals of the domain (the dataset's unit of
            length); above 0, at most 1e+30.
        `work_done_token`: on a WebSocket: $/progress reports the progress of the work with this token.

        Error: NotFound, OutsideDomain, OutsideTimeRange, OverLimit, DatasetError. For editors.

        For example:

            api.family.make(dataset='sqcyl', name='psi', from_='curve', rake_kind='line',
                            points=[[-2, 0.1, 1], [-2, 0.1, 2]])
        """
        answer: Family = self._call("family.make", {"dataset": dataset, "name": name, "from": from_, "scalar": scalar,
                                                    "point": point, "normal": normal, "rakeKind": rake_kind,
                                                    "points": points, "time": time, "accuracy": accuracy,
                                                    "length": length, "workDoneToken": work_done_token})
        return answer

    @named
    def remove(self, *, dataset: str, name: str) -> Json:
        """Removes a family, and its files. Surfaces that show it are shown without it.

        `dataset`: an id from dataset.list.
        `name`: name of the field: letters, digits, and _ - .

        Error: NotFound, DatasetError. For editors.

        For example:

            api.family.remove(dataset='sqcyl', name='psi')
        """
        answer: Json = self._call("family.remove", {"dataset": dataset, "name": name})
        return answer
