"""Values of Python as JSON has them."""
from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any, Dict, Iterator, Mapping, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from .errors import InvalidParameters
from .generated.limits import MESSAGE_BYTES, PROBE_POINTS

if TYPE_CHECKING:
    Json = Dict[str, Any]
    Point = Union[Sequence[float], NDArray[Any]]
    Points = Union[Sequence[Point], NDArray[Any]]
else:
    Json = Point = Points = Any

NULL: Any = object()  # a parameter that is null, not left out
_PROBE_BYTES = MESSAGE_BYTES * 3 // 4  # of one call's points


class HasId:
    """An object of the server that has an id; calls that want the id accept the object."""

    id: str


def plain(value: Any, where: str = "") -> Any:
    """Converts arrays, records and tuples to what JSON has. Error: InvalidParameters for numbers that JSON does not
    have, saying `where`."""
    if value is NULL:
        return None
    if isinstance(value, HasId):
        return value.id
    if isinstance(value, np.ndarray):
        if value.dtype.kind != "f" or np.isfinite(value).all():
            return value.tolist()
        value = value.tolist()
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        raise InvalidParameters(f"`{where}` is {value}, which is not a finite number", -32602, "invalidParameters",
                                "give a finite number")
    if isinstance(value, Mapping):
        return {name: plain(each, f"{where}.{name}") for name, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each, f"{where}[{i}]") for i, each in enumerate(value)]
    return value


def given(parameters: Mapping[str, Any]) -> Json:
    """Returns the parameters that are not left out, as JSON has them."""
    return {name: plain(value, name) for name, value in parameters.items() if value is not None}


def slices(points: Sequence[Sequence[float]]) -> Iterator[Sequence[Sequence[float]]]:
    """Splits points into parts that fit into one message each; none gives one empty part."""
    first = size = 0
    for i, point in enumerate(points):
        more = len(json.dumps(point)) + 2
        if size + more > _PROBE_BYTES or i - first >= PROBE_POINTS:
            yield points[first:i]
            first, size = i, 0
        size += more
    yield points[first:]


def point_text(point: Point, name: str) -> str:
    """Writes a point or a direction as addresses have it: x,y,z."""
    return ",".join(repr(float(each)) for each in plain(list(point), name))
