"""The view of a picture: its camera, and the look of surfaces. The page reads the same from its address, and takes the usual for an invalid
value; a script gets an error, before a browser starts."""
from __future__ import annotations

import base64
import json
import re
import typing
from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, Tuple, TypedDict, cast

import numpy as np

from .errors import InvalidParameters
from .names import check_names, meant
from .plain import plain

ALWAYS = ("speed", "age", "s", "constant")
DERIVED = ("vorticity", "vorticity_x", "vorticity_y", "vorticity_z", "q_criterion", "deformation", "approximated", "error", "interval_error")
_PARTS: Dict[str, Tuple[float, float]] = {"opacity": (0, 1), "smoke": (0, 1), "density": (0.125, 8)}


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
    root: bool  # colours follow the root of the values
    bands: int  # of one colour each, 2 to 32; 0: none
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
    found = [] if by in ALWAYS else [by[len("field:"):] if by.startswith("field:") else by]
    if look.get("texture"):
        found += ["velocity_x", "velocity_y", "velocity_z"]
    return found


def wrong(message: str, hint: str) -> InvalidParameters:
    """Returns the error for an invalid value, with the valid ones."""
    return InvalidParameters(message, -32602, "invalidParameters", hint)


def check_choice(value: Any, choices: Sequence[str], where: str) -> None:
    """Raises InvalidParameters, with the choices, for any other value."""
    if value not in choices:
        right = meant(value, choices) if isinstance(value, str) else None
        raise wrong(f"`{where}` is {value!r}", (f"did you mean {right}? " if right else "") + "there are " + ", ".join(choices))


def check_camera(camera: Mapping[str, Any]) -> None:
    """Raises InvalidParameters for an invalid camera."""
    for name in ("position", "target"):
        if name not in camera or not _numbers(camera[name], 3):
            raise wrong(f"a camera needs `{name}`", "three numbers")
    if not isinstance(camera.get("orthographic", False), bool):
        raise wrong("`orthographic` of a camera is neither True nor False", "give one of them")
    if list(camera["position"]) == list(camera["target"]):
        raise wrong("`position` and `target` of a camera are the same point", "it looks from one to the other")


def check_look(look: Mapping[str, Any], kind: Any) -> None:
    """Checks that its values are of their types and within their limits; `kind` says the types. Error:
    InvalidParameters."""
    hints = typing.get_type_hints(kind)
    for name, value in look.items():
        hint = hints[name]
        if typing.get_origin(hint) is Literal:
            check_choice(value, typing.get_args(hint), name)
        elif hint is bool and not isinstance(value, (bool, np.bool_)):
            raise wrong(f"`{name}` is {value!r}", "there are True and False")
        elif hint is float:
            low, high = _PARTS.get(name, (-np.inf, np.inf))
            if not _numbers([value], 1) or not low <= value <= high:
                raise wrong(f"`{name}` is {value!r}", f"a number from {low:g} to {high:g}" if name in _PARTS else "a number")
        elif name == "range" and not (_numbers(value, 2) and value[0] <= value[1]):
            raise wrong(f"`range` is {value!r}", "two numbers, the lower one first")
        elif name == "colour" and not (isinstance(value, str) and re.fullmatch(r"#[0-9a-fA-F]{6}", value)):
            raise wrong(f"`colour` is {value!r}", "#rrggbb")


def check_colour_by(value: Any, dataset: Mapping[str, Any]) -> None:
    """Checks that a surface of this dataset, as `Client.describe` returns it, can be coloured by it. Error:
    InvalidParameters."""
    can_come = dataset["surfaceFields"]
    vectors = [each["name"] for each in dataset["fields"] if each["components"] != 1]
    own = [each["name"] for each in dataset["fields"] if each["components"] == 1 and each["name"] in can_come]
    if isinstance(value, str) and value.startswith("field:") and value[len("field:"):] in can_come and value[len("field:"):] not in vectors:
        return
    if value in own:
        raise wrong(f"`colour_by` is {value!r}", f"did you mean field:{value}?")
    check_choice(value, [*ALWAYS, *(each for each in DERIVED if each in can_come), *("field:" + each for each in own)], "colour_by")


def _numbers(value: Any, count: int) -> bool:
    try:
        found = np.asarray(value)
    except ValueError:
        return False
    return found.shape == (count,) and found.dtype.kind in "iuf" and bool(np.isfinite(found).all())
