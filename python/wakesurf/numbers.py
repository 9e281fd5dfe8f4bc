"""Numbers of surfaces, each with its errors: area, flux, ages on a plane or in a box, times of stay; and the shares that several surfaces have.

    numbers = surface.numbers(times=(0, 5, 0.5), through=box((2, -2, 0), (4, 2, 5)))
    print(numbers["area"], numbers["area_error"], numbers.units["area"])
"""
from __future__ import annotations

import csv
import io
import re
from dataclasses import dataclass
from typing import Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from .mesh import Array

_NAME = re.compile(r"(.*?)(?: \[(.*)\])?", re.DOTALL)
Times = Union[str, Tuple[float, float, float]]


def plane(point: Sequence[float], normal: Sequence[float]) -> str:
    """Returns a plane as `through` takes it."""
    return f"plane:{_words(point)}:{_words(normal)}"


def box(corner: Sequence[float], opposite: Sequence[float]) -> str:
    """Returns a box as `through` takes it.

    >>> box((0, 0, 0), (1, 2, 3))
    'box:0.0,0.0,0.0:1.0,2.0,3.0'
    """
    return f"box:{_words(corner)}:{_words(opposite)}"


def _words(numbers: Sequence[float]) -> str:
    return ",".join(repr(float(each)) for each in numbers)


@dataclass(frozen=True)
class Numbers:
    """A column for each number, by its name: an array of one value a time, NaN where it is not known."""

    columns: Dict[str, Array]
    units: Dict[str, str]  # of the columns that have one
    notes: List[str]  # of each time: why numbers are not known; empty where there is nothing to say

    def __getitem__(self, name: str) -> Array:
        return self.columns[name]

    def __len__(self) -> int:
        return len(self.notes)

    def row(self, i: int = -1) -> Dict[str, float]:
        """Returns the numbers of one time."""
        return {name: float(values[i]) for name, values in self.columns.items()}

    @classmethod
    def from_csv(cls, text: str) -> Numbers:
        """Reads what `wakesurf surface -o NAME.csv` and `Surface.numbers` give.

        >>> numbers = Numbers.from_csv("time [s],area,notes\\n0.5,,torn\\n")
        >>> numbers.units, numbers["time"][0], numbers.notes
        ({'time': 's'}, 0.5, ['torn'])
        """
        head, *rows = csv.reader(io.StringIO(text))
        columns: Dict[str, Array] = {}
        units: Dict[str, str] = {}
        for i, word in enumerate(head[:-1]):
            found = _NAME.fullmatch(word)
            name = str(found[1]) if found else word
            unit: Optional[str] = found[2] if found else None
            columns[name] = np.array([float(row[i]) if row[i] else np.nan for row in rows])
            if unit:
                units[name] = unit
        return cls(columns, units, [row[-1] for row in rows])


@dataclass(frozen=True)
class Share:
    """A part of 1. The errors are the most that those of all surfaces together change it, to first order; NaN where one is not known."""

    value: float
    error: float
    interval_error: float


def shares(of: Mapping[str, Numbers], by: str, i: int = -1) -> Dict[str, Share]:
    """Returns the share that each has of the sum of a number, at the time `i`. Error: ValueError where a number is not
    known, or the sum is not above 0.

    >>> one, three = (Numbers.from_csv(f"a,a_error,a_interval_error,notes\\n{n},0.1,,\\n") for n in (1, 3))
    >>> found = shares({"one": one, "three": three}, "a")
    >>> found["one"].value, round(found["one"].error, 4)
    (0.25, 0.025)
    """
    values = {name: abs(float(each[by][i])) for name, each in of.items()}
    whole = sum(values.values())
    unknown = [name for name, value in values.items() if not np.isfinite(value)]
    if unknown or not whole > 0:
        why = "; ".join(f"{name}: {of[name].notes[i] or 'nothing is known'}" for name in unknown)
        raise ValueError(f"no shares by {by!r}: {why or 'all of them are 0'}")

    def error(name: str, which: str) -> float:
        part = values[name] / whole
        off = {each: float(numbers[by + which][i]) for each, numbers in of.items()}
        return sum((1 - part if each == name else part) * one for each, one in off.items()) / whole

    return {name: Share(value / whole, error(name, "_error"), error(name, "_interval_error")) for name, value in values.items()}


def query_of(times: Optional[Times], through: Optional[str], time: Union[float, str, None],
             fields: Sequence[str]) -> Dict[str, str]:
    """Returns the parameters of a request."""
    query = {} if time is None else {"time": time if isinstance(time, str) else repr(float(time))}
    if times is not None:
        query["times"] = times if isinstance(times, str) else ":".join(repr(float(each)) for each in times)
    if through is not None:
        query["through"] = through
    if fields:
        query["fields"] = "\n".join(fields)
    return query
