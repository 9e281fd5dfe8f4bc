"""Presence: what the server answers. Members that may be missing are not there then.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
from __future__ import annotations

from typing import List, Literal, Optional, TypedDict


class Camera(TypedDict, total=False):
    """Where someone looks from."""

    position: List[float]  # position of the eye (the dataset's unit of length)
    target: List[float]  # the point in the middle of the picture (the dataset's unit of length)
    up: List[float]  # direction that points up in the picture (the dataset's unit of length)
    fov: float  # field of view from top to bottom; if left out, the view is orthographic or unknown (degrees); may ...


class DraggedRake(TypedDict, total=False):
    """A rake while it is dragged."""

    rake: str  # id of the rake
    points: List[List[float]]  # where the rake is now; may be missing


class Presence(TypedDict, total=False):
    """What someone is doing at the moment."""

    pointer: Optional[List[float]]  # the point they point at (the dataset's unit of length); may be missing
    camera: Optional[Camera]  # where they look from; may be missing
    dragging: Optional[DraggedRake]  # the rake they drag; may be missing
    selected: Optional[str]  # id of the record they have selected; may be missing


class Participant(TypedDict, total=False):
    """Someone in a session."""

    participant: str  # id of the participant
    name: str  # display name; two people in a session never have the same one
    colour: str  # their colour, #rrggbb
    role: Literal["viewer", "editor", "host"]  # what someone may do; each role includes the ones before it
    connected: bool  # false: the connection was lost less than 10 s ago
    pointer: Optional[List[float]]  # the point they point at (the dataset's unit of length); may be missing
    camera: Optional[Camera]  # where they look from; may be missing
    dragging: Optional[DraggedRake]  # the rake they drag; may be missing
    selected: Optional[str]  # id of the record they have selected; may be missing
