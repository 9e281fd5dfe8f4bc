"""The view of a picture: its camera, and the colours of surfaces. The page reads the same from its address."""
from __future__ import annotations

import base64
import json
from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, TypedDict, cast

from .names import check_names
from .plain import plain
from .view_values import check_camera, check_look


class Camera(TypedDict, total=False):
    """The camera of a picture."""

    position: Sequence[float]  # of the eye (the dataset's unit of length)
    target: Sequence[float]  # the point in the middle of the picture
    orthographic: bool


class SurfaceLook(TypedDict, total=False):
    """The look of a surface; parameters that are left out are as on the page."""

    colour_by: str  # speed, age, s, constant, vorticity, q_criterion, deformation, error, or field:NAME
    colour: str  # #rrggbb, where `colour_by` is constant
    map: Literal["viridis", "cividis", "inferno", "plasma", "coolToWarm", "grey", "turbo"]
    invert: bool
    log: bool
    range: Sequence[float]  # values of the first and the last colour; left out: those of the surface
    range_of: Literal["surface", "data"]  # whose range is taken
    centre: float  # the colours are symmetric round this value
    back_side: Literal["shaded", "same", "tinted"]
    opacity: float  # 0 to 1
    angle_opacity: bool  # thicker where it is seen edge-on
    smoke: float  # 0 to 1: thinner the more it has been stretched and the older it is
    silhouettes: bool
    points: bool  # discs at the vertices instead of cells
    lines: Literal["none", "timelines", "streamlines", "grid", "checker"]
    density: float  # of the lines, 0.125 to 8
    texture: bool


class Look(TypedDict, total=False):
    """The look of a picture: `camera`, and the look of all surfaces, or of each by its id."""

    camera: Camera
    look: SurfaceLook
    looks: Mapping[str, SurfaceLook]


_NAMES = {"colour_by": "colourBy", "range_of": "rangeOf", "back_side": "backSide", "angle_opacity": "angleOpacity"}


def looks_of(view: Optional[Look], surfaces: Sequence[str]) -> Dict[str, SurfaceLook]:
    """Returns the look of each surface, checked as far as possible without data. Error: InvalidParameters,
    UnknownParameter."""
    view = view or {}
    check_names(view, Look.__annotations__, "`view`")
    if "camera" in view:
        check_names(view["camera"], Camera.__annotations__, "`camera`")
        check_camera(view["camera"])
    of_each: Mapping[str, SurfaceLook] = view.get("looks", {})
    check_names(of_each, surfaces, "`looks`")
    for look in (view.get("look", {}), *of_each.values()):
        check_names(look, SurfaceLook.__annotations__, "`look`")
        check_look(look, SurfaceLook)
    common: Mapping[str, Any] = view.get("look", {})
    return {surface: cast(SurfaceLook, {**common, **of_each.get(surface, {})}) for surface in surfaces}


def page_state(view: Optional[Look], surfaces: Sequence[str]) -> str:
    """Returns the `state` of the page's address. Error: as `looks_of`."""
    looks: Mapping[str, Mapping[str, Any]] = looks_of(view, surfaces)
    page: Dict[str, Any] = {"looks": {surface: {_NAMES.get(name, name): value for name, value in look.items()}
                                      for surface, look in looks.items()}}
    if view and "camera" in view:
        page["camera"] = {"orthographic": False, **view["camera"]}
    if surfaces:
        page["surface"] = surfaces[-1]
    text = json.dumps(plain({"v": page, "r": [], "s": []}, "view"))
    return base64.urlsafe_b64encode(text.encode()).decode().rstrip("=")


def fields_for(look: SurfaceLook) -> List[str]:
    """Returns the fields that the server has to send with a surface for this look."""
    by = look.get("colour_by", "speed")
    found = [] if by in ("speed", "age", "s", "constant") else [by[len("field:"):] if by.startswith("field:") else by]
    if look.get("texture"):
        found += ["velocity_x", "velocity_y", "velocity_z"]
    return found
