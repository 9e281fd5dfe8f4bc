"""Rakes: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, Literal, TypedDict


class RakeRecord(TypedDict, total=False):
    """A rake as the session keeps it."""

    rake: str  # id of the rake
    rev: int  # counts the edits of a record
    kind: Literal["line", "polyline", "circle", "points"]  # what the points are; line: 2 points; polyline and ...
    points: List[List[float]]  # where the rake lies; parts outside the domain are cut off, and a circle releases ...
    seeds: int  # number of seeds on the rake
    name: str  # display name
    colour: str  # #rrggbb
    author: str  # name of the one who made it
    clipped: bool  # true: a part was outside the domain and was cut off; a circle's points stay
    dragging: bool  # true: someone holds the lease at the moment
    leasedBy: str  # id of the participant who holds the lease; only present while someone does; may be missing


class SurfaceEpoch(TypedDict, total=False):
    """A surface that is being built again."""

    surface: str  # id of the surface
    epoch: int  # counts the surfaces that have been built for the record; it never decreases


class RakeSetResult(TypedDict, total=False):
    """What rake.set answers."""

    rake: str  # id of the rake
    rev: int  # counts the edits of a record
    seq: int  # `seq` of the session after the edit
    clipped: bool  # true: a part was outside the domain and was cut off; a circle's points stay
    points: List[List[float]]  # the points, clipped to the domain
    surfaces: List[SurfaceEpoch]  # surfaces of the rake that are being built again


class RakeListResult(TypedDict, total=False):
    """What rake.list answers."""

    rakes: List[RakeRecord]  # all rakes
