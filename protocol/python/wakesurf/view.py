"""How a picture shows a session: from where, and in which colours. The page reads the same from its address."""
from __future__ import annotations

import base64
import json
from typing import Any, Dict, List, Mapping, Optional, Sequence, TypedDict

from .errors import UnknownParameter
from .names import meant
from .plain import plain


class Camera(TypedDict, total=False):
    """Where a picture is taken from."""

    position: Sequence[float]  # of the eye (the dataset's unit of length)
    target: Sequence[float]  # the point in the middle of the picture
    orthographic: bool


class SurfaceLook(TypedDict, total=False):
    """How a surface looks; what is left out is as on the page."""

    colour_by: str  # speed, age, s, constant, vorticity, q_criterion, deformation, error, or field:NAME
    colour: str  # #rrggbb, where `colour_by` is constant
    map: str  # viridis, cividis, inferno, plasma, coolToWarm, grey, turbo
    invert: bool
    log: bool
    range: Sequence[float]  # values of the first and the last colour; left out: those of the surface
    range_of: str  # surface or data: whose range is taken
    centre: float  # the colours are symmetric round this value
    back_side: str  # shaded, same, tinted
    opacity: float  # 0 to 1
    angle_opacity: bool  # thicker where it is seen edge-on
    smoke: float  # 0 to 1: thinner the more it has been stretched and the older it is
    silhouettes: bool
    lines: str  # none, timelines, streamlines, grid, checker
    density: float  # of the lines
    texture: bool


class Look(TypedDict, total=False):
    """What a picture shows: `camera`, and the look of all surfaces, or of each by its id."""

    camera: Camera
    look: SurfaceLook
    looks: Mapping[str, SurfaceLook]


_NAMES = {"colour_by": "colourBy", "range_of": "rangeOf", "back_side": "backSide", "angle_opacity": "angleOpacity"}


def page_state(view: Optional[Look], surfaces: Sequence[str]) -> str:
    """The `state` of the page's address. Error: UnknownParameter for names that there are not."""
    view = view or {}
    _check(view, Look, "view")
    _check(view.get("camera", {}), Camera, "camera")
    common = view.get("look", {})
    of_each: Mapping[str, SurfaceLook] = view.get("looks", {})
    looks = {surface: _encoded({**common, **of_each.get(surface, {})}) for surface in surfaces}
    page: Dict[str, Any] = {"looks": looks}
    if "camera" in view:
        page["camera"] = {"orthographic": False, **view["camera"]}
    if surfaces:
        page["surface"] = surfaces[-1]
    text = json.dumps(plain({"v": page, "r": [], "s": []}, "view"))
    return base64.urlsafe_b64encode(text.encode()).decode().rstrip("=")


def _encoded(look: Mapping[str, Any]) -> Dict[str, Any]:
    _check(look, SurfaceLook, "look")
    return {_NAMES.get(name, name): value for name, value in look.items()}


def _check(given: Mapping[str, Any], kind: Any, where: str) -> None:
    known: List[str] = list(kind.__annotations__)
    for name in given:
        if name not in known:
            right = meant(name, known)
            raise UnknownParameter(f"`{where}` has no `{name}`", -32602, "invalidParameters",
                                   f"did you mean `{right}`?" if right else "there are " + ", ".join(known))
