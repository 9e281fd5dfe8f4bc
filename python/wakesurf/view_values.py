"""The valid values of a view. A page uses the default for an invalid one; a script gets an error, before a browser
starts."""
from __future__ import annotations

import re
import typing
from typing import Any, Dict, Literal, Mapping, Sequence, Tuple

import numpy as np

from .errors import InvalidParameters
from .names import meant

ALWAYS = ("speed", "age", "s", "constant")
DERIVED = ("vorticity", "vorticity_x", "vorticity_y", "vorticity_z", "q_criterion", "deformation", "approximated", "error")
_PARTS: Dict[str, Tuple[float, float]] = {"opacity": (0, 1), "smoke": (0, 1), "density": (0.125, 8)}


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
