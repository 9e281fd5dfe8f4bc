"""The particles of the benchmark, and the files that say where they come to.

A rake has 33 of them across, s = 0 to 1, and 41 along, t = 0 to 1. In a streak surface t says when a particle is released, from the
first time to the last, at which all are compared; in a path surface all are released at the first time, and t says at which they are
compared. A file of places has a line `s,t,x,y,z` for each, s the slower; `nan` for one that has left the flow.
"""
from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
ACROSS, ALONG = 33, 41
S, T = np.linspace(0, 1, ACROSS), np.linspace(0, 1, ALONG)


def write_places(path: Path, places: Array) -> None:
    """Writes places of shape (ACROSS, ALONG, 3)."""
    s, t = np.meshgrid(S, T, indexing="ij")
    lines = np.column_stack([s.ravel(), t.ravel(), places.reshape(-1, 3)])
    np.savetxt(path, lines, fmt="%.9g", delimiter=",", header="s,t,x,y,z", comments="")


def read_places(path: Path) -> Array:
    return np.loadtxt(path, delimiter=",", skiprows=1)[:, 2:].reshape(ACROSS, ALONG, 3)
