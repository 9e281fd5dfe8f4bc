"""Surfaces: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, Literal, TypedDict


SurfaceRecord = TypedDict("SurfaceRecord", {  # A surface as the session keeps it: its parameters, not its mesh.
    "surface": "str",  # id of the surface
    "rev": "int",  # counts the edits of a record
    "epoch": "int",  # counts the surfaces that have been built for the record; it never decreases
    "rake": "str",  # an id from rake.list; the particles start from this rake. A level surface takes no more of it ...
    "rake2": "str",  # the patch lies between the rake and this second rake; may be missing
    "dataset": "str",  # an id from dataset.list
    "kind": 'Literal["stream", "path", "streak", "time", "level"]',  # stream: streamlines of the field frozen at ...
    "accuracy": 'Literal["fast", "balanced", "exact"]',  # how accurately particles are traced and vertices inserted
    "interpolation": 'Literal["linear", "smooth"]',  # of stored velocity. linear: between the nodes of a cell and ...
    "refine": 'Literal["on", "off"]',  # whether quads are cut, joined and reconnected, and torn at obstacles. off: ...
    "to": "float",  # where the surface ends: before `from`, time runs backward. A stream surface is followed for ...
    "releaseUntil": "float",  # time at which the release stops; if left out, `to` (the dataset's unit of time); may ...
    "life": "float",  # longest age of a particle: it ends so long after its release; if left out, it lives as long ...
    "sweep": "List[float]",  # the patch is the rake swept along this vector (the dataset's unit of length); may be ...
    "field": "str",  # scalar field of the dataset, or derived from its velocity, of which the surface is a level ...
    "level": "float",  # value that the field has on the surface (the field's unit); may be missing
    "merge": "float",  # quads smaller than this are joined; 0: never (part of the separation)
    "angle": "float",  # neighbouring quads at a larger angle are refined, as far as the separation and `maxQuads` ...
    "stagnationSpeed": "float",  # a slower particle counts as at rest and ends; 0: only a particle that does not ...
    "maxQuads": "int",  # maximum number of quads
    "from": "float",  # where the surface starts: the (first) release; for stream surfaces, the time at which the ...
    "direction": 'Literal["forward", "backward", "both"]',  # which way particles are followed in time
    "separation": "float",  # longest edge allowed (the dataset's unit of length)
    "fields": "List[str]",  # additional attributes of the vertices, in frames and exports: scalar fields of the ...
}, total=False)


class SurfaceSetResult(TypedDict, total=False):
    """What surface.set returns."""

    surface: str  # id of the surface
    rev: int  # counts the edits of a record
    epoch: int  # counts the surfaces that have been built for the record; it never decreases
    seq: int  # `seq` of the session after the edit


class SurfaceStopResult(TypedDict, total=False):
    """What surface.stop answers."""

    epoch: int  # counts the surfaces that have been built for the record; it never decreases
    stopped: bool  # false: nothing was being computed


class SurfaceListResult(TypedDict, total=False):
    """What surface.list answers."""

    surfaces: List[SurfaceRecord]  # all surfaces
