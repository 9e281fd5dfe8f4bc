"""Values along a line or over time, as `Client.profile` and `Client.history` return them.

    along = client.profile("case", [(0, 0, 1), (4, 0, 1)], ["speed", "p"], time=2.5)
    plt.plot(along["distance"], along["p"])
    along.save("wake.csv")
"""
from __future__ import annotations

import csv
import io
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Sequence, Tuple, Union

import numpy as np

from .files import write_whole
from .mesh import Array

_COMPONENTS = ("velocity_x", "velocity_y", "velocity_z")


@dataclass(frozen=True)
class Series:
    """A column for each number, by its name, NaN where it has no value: outside of the fluid, in a body, or at a time at
    which it is not stored. First what the values are along, then where and when they are, then they themselves."""

    columns: Dict[str, Array]
    units: Dict[str, str]  # of the columns of which it is known

    def __getitem__(self, name: str) -> Array:
        return self.columns[name]

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    def to_csv(self) -> str:
        """Returns what the page saves of such a plot: names with units, and a row for each place.

        >>> Series({"time": np.array([0.5, 1.0]), "p": np.array([np.nan, 1e-7])}, {"time": "s"}).to_csv()
        'time [s],p\\n0.5,\\n1,1e-7\\n'
        """
        text = io.StringIO()
        rows = csv.writer(text, lineterminator="\n")
        rows.writerow([f"{name} [{self.units[name]}]" if self.units.get(name) else name for name in self.columns])
        rows.writerows([[_number(value) for value in row] for row in zip(*self.columns.values())])
        return text.getvalue()

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes `to_csv` to a file."""
        write_whole(os.fsdecode(path), [self.to_csv().encode()])

    def to_dataframe(self) -> Any:
        """Converts to a pandas DataFrame, a column for each number."""
        import pandas
        return pandas.DataFrame(self.columns)


def _number(value: float) -> str:
    """Writes a number as the page does."""
    if not np.isfinite(value):
        return ""
    if value == 0 or 1e-6 <= abs(value) < 1e21:
        return np.format_float_positional(value, trim="-")
    mantissa, _, exponent = repr(float(value)).partition("e")
    short = mantissa[:-2] if mantissa.endswith(".0") else mantissa
    return f"{short}e{int(exponent):+d}"


def points_along(line: Sequence[Sequence[float]], count: int) -> Tuple[Array, Array]:
    """Returns points evenly along a line of straight pieces, and how far along it each is. Error: ValueError.

    >>> points_along([(0, 0, 0), (3, 0, 0), (3, 4, 0)], 8)[0][4].tolist()
    [3.0, 1.0, 0.0]
    """
    corners = np.asarray(line, dtype=float)
    if corners.ndim != 2 or corners.shape[1:] != (3,) or len(corners) < 2 or count < 2:
        raise ValueError("a line has at least two points of three numbers, and at least two places on it")
    ends = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(corners, axis=0), axis=1))])
    if not ends[-1] > 0:
        raise ValueError("the line has no length")
    distances = np.linspace(0.0, ends[-1], count)
    return np.column_stack([np.interp(distances, ends, corners[:, axis]) for axis in range(3)]), distances


def fields_of(dataset: Mapping[str, Any], quantities: Sequence[str]) -> List[str]:
    """Returns the names of fields that a server is asked for."""
    velocity = str(dataset["velocity"])
    stored = {field["name"] for field in dataset["fields"]}
    named = [velocity if name not in stored and name in ("speed", *_COMPONENTS) else name for name in quantities]
    return list(dict.fromkeys(named))


def columns_of(dataset: Mapping[str, Any], quantities: Sequence[str],
               found: Mapping[str, Array]) -> Tuple[Dict[str, Array], Dict[str, str]]:
    """Returns the values of the quantities, and their units. The velocity by its own name becomes its components."""
    velocity = str(dataset["velocity"])
    units = {field["name"]: field.get("unit", "") for field in dataset["fields"]}
    columns: Dict[str, Array] = {}
    column_units: Dict[str, str] = {}
    for name in quantities:
        if name != velocity and name in found:
            parts = {name: found[name]}
        else:
            vectors = found[velocity]
            parts = {each: vectors[:, i] for i, each in enumerate(_COMPONENTS) if name in (each, velocity)}
            if name == "speed":
                parts = {name: np.linalg.norm(vectors, axis=1)}
        columns.update(parts)
        column_units.update({each: units.get(name if name in found else velocity, "") for each in parts})
    return columns, column_units
