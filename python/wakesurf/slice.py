"""A field on a plane through the data, as `Client.slice` returns it.

    found = client.slice("case", point=(0, 0, 0.5), normal=(0, 0, 1), field="p", time=2.5)
    plt.pcolormesh(found.points[..., 0], found.points[..., 1], found.values)
"""
from __future__ import annotations

import os
import struct
from dataclasses import dataclass
from typing import Union

import numpy as np

from .errors import ServerFault
from .files import write_whole
from .mesh import Array

_HEADER = struct.Struct("<4sIII12d")
_NO_VALUE, _CODES = 65535, 65534


@dataclass(frozen=True)
class Slice:
    """Samples at the centres of equal rectangles; the corner of all of them and its two sides are in the units of the data."""

    values: Array  # (rows, columns), NaN in bodies, outside of the domain and where the field has no value
    corner: Array
    across: Array  # along the columns
    up: Array  # along the rows
    field: str
    time: float

    @property
    def points(self) -> Array:
        """Returns where the samples are, (rows, columns, 3)."""
        rows, columns = self.values.shape
        s = (np.arange(columns) + 0.5) / columns
        t = (np.arange(rows) + 0.5) / rows
        return np.asarray(self.corner + s[None, :, None] * self.across + t[:, None, None] * self.up)

    @property
    def area(self) -> float:
        """Returns the area of the part that has values, to one sample along its border."""
        cell = np.linalg.norm(self.across) * np.linalg.norm(self.up) / self.values.size
        return float(cell * np.count_nonzero(np.isfinite(self.values)))

    @property
    def mean(self) -> float:
        """Returns the mean over that part, NaN where there is none. Times `area` it is the integral: of the velocity's component
        across the plane, what flows through it."""
        known = self.values[np.isfinite(self.values)]
        return float(known.mean()) if known.size else float("nan")

    def to_csv(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes x, y, z and the value of each sample that has one, a row each."""
        known = np.isfinite(self.values)
        rows = [",".join(map(repr, row)) for row in np.column_stack([self.points[known], self.values[known]]).tolist()]
        name = f'"{self.field.replace(chr(34), chr(34) * 2)}"'
        write_whole(os.fsdecode(path), ["\n".join([f"x,y,z,{name}", *rows, ""]).encode()])

    @classmethod
    def from_bytes(cls, body: bytes, field: str) -> Slice:
        """Reads what the server sends as slice.bin (protocol/wire/FORMAT.md, Slice file). Error: ServerFault."""
        if len(body) < _HEADER.size or body[:4] != b"WSL\x01":
            raise ServerFault("the server sent a slice that this version cannot read", hint="are both of the same version?")
        _, columns, rows, _, *numbers = _HEADER.unpack_from(body)
        if columns * rows == 0 or len(body) != _HEADER.size + 2 * columns * rows:
            raise ServerFault("the server sent a slice that this version cannot read", hint="are both of the same version?")
        time, low, high = numbers[9:]
        codes = np.frombuffer(body, "<u2", offset=_HEADER.size).reshape(rows, columns)
        values = np.where(codes == _NO_VALUE, np.nan, low + (high - low) * codes / _CODES)
        corner, across, up = (np.array(numbers[i:i + 3]) for i in (0, 3, 6))
        return cls(values, corner, across, up, field, time)
