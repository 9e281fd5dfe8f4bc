"""Families of stream surfaces: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, Literal, TypedDict


class FamilyStep(TypedDict, total=False):
    """What came of a family at one time-step."""

    index: int  # index of the time-step
    time: float  # its time (the dataset's unit of time)
    nodes: int  # number of nodes
    reached: int  # nodes whose way leads to the source: only these have a value
    atRest: int  # nodes that are at rest, or come to rest
    obstacle: int  # nodes in an obstacle, or whose way ends at one
    lost: int  # nodes that were followed for `length` without an end, as where the flow turns in circles
    outside: int  # nodes whose way leaves the domain beside the source, and nodes without a velocity
    range: List[float]  # smallest and largest value


Family = TypedDict("Family", {  # A family of stream surfaces of a dataset, with what it was made from.
    "name": "str",  # name of the field: letters, digits, and _ - .
    "from": 'Literal["inflow", "plane", "curve"]',  # where the scalar is given; inflow: on the boundary through ...
    "scalar": "str",  # of inflow and plane: x, y, z or the field that was taken there; may be missing
    "point": "List[float]",  # of a plane: a point of it (the dataset's unit of length); may be missing
    "normal": "List[float]",  # of a plane: its normal (the dataset's unit of length); may be missing
    "rakeKind": 'Literal["line", "polyline", "circle", "points"]',  # of a curve: what the points are, as of a rake: ...
    "points": "List[List[float]]",  # of a curve: its points; the ends of a line or a polyline are continued ...
    "accuracy": 'Literal["fast", "balanced", "exact"]',  # how accurately particles are traced and vertices inserted
    "length": "float",  # how far nodes were followed at most (the dataset's unit of length)
    "version": "str",  # version of the program that made it
    "steps": "List[FamilyStep]",  # the time-steps it was made for; at others it has no value
}, total=False)
