"""Streamlines of a flow at a time, as arrays.

    lines = client.streamlines("sqcyl", line=((-2, 0, 3), (-2, 2, 3)), seeds=20, time=12)
    for points, values in lines:
        plot3d(*points.T, values)
"""
from __future__ import annotations

import os
import struct
from dataclasses import dataclass
from typing import Iterator, Tuple, Union

import numpy as np

from .errors import ServerFault
from .files import write_whole
from .mesh import Array

_HEADER = struct.Struct("<4s9I6d")


@dataclass(frozen=True)
class Streamlines:
    """Line i has the points from offsets[i] to offsets[i + 1], downstream, in the units of the data."""

    points: Array  # (points, 3)
    offsets: Array  # (lines + 1,)
    values: Array  # of the field at each point, NaN where it has none
    seed: Array  # which seed each line began at
    seeds: int
    outside: int  # seeds in bodies or outside of the domain: they have no line
    cut: int  # ends of lines at the limit of points for a line
    field: str
    time: float

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def __iter__(self) -> Iterator[Tuple[Array, Array]]:
        """Yields the points and the values of each line."""
        for begin, end in zip(self.offsets[:-1], self.offsets[1:]):
            yield self.points[begin:end], self.values[begin:end]

    def to_csv(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the line's number, x, y, z and the value of each point, a row each; a value that is not there is empty."""
        name = f'"{self.field.replace(chr(34), chr(34) * 2)}"'
        rows = [f"line,x,y,z,{name}"]
        for number, (points, values) in enumerate(self):
            for (x, y, z), value in zip(points.tolist(), values.tolist()):
                rows.append(f"{number},{x!r},{y!r},{z!r},{'' if value != value else repr(value)}")
        write_whole(os.fsdecode(path), ["\n".join([*rows, ""]).encode()])

    @classmethod
    def from_bytes(cls, body: bytes, field: str) -> Streamlines:
        """Reads what the server sends as lines.bin (protocol/wire/FORMAT.md, Lines file). Error: ServerFault."""
        fault = ServerFault("the server sent lines that this version cannot read", hint="are both of the same version?")
        if len(body) < _HEADER.size or body[:4] != b"WST\x01":
            raise fault
        _, lines, points, seeds, outside, _, _, _, _, cut, time, _, _, *origin = _HEADER.unpack_from(body)
        if len(body) != _HEADER.size + 4 * (2 * lines + 1) + 16 * points:
            raise fault
        whole = np.frombuffer(body, "<u4", 2 * lines + 1, _HEADER.size).astype(int)
        numbers = np.frombuffer(body, "<f4", 4 * points, _HEADER.size + 4 * (2 * lines + 1)).astype(float)
        return cls(numbers[:3 * points].reshape(-1, 3) + origin, whole[:lines + 1], numbers[3 * points:], whole[lines + 1:],
                   seeds, outside, cut, field, time)
