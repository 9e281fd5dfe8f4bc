"""Mesh frames, the binary messages of the server: their headers, and for `Surface.live` their meshes as numpy arrays.

    decoder = MeshDecoder()
    for message in binary_messages:
        state = decoder.fold(message)          # a State when the message completed an update
        if state is not None:
            print(len(state.nodes), "vertices", len(state.cells), "quads")

Meshes are decoded by the library libwakesurf_frames, which the build makes of the server's own decoder. protocol/wire/FORMAT.md describes
the format. Not thread safe.
"""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import struct
import weakref
from dataclasses import dataclass
from typing import Any, List, Mapping, Optional, Tuple

import numpy as np

from .errors import WakesurfError
from .mesh import Array
from .plain import Json

VERSION = 5
LIBRARY = "libwakesurf_frames.so"
_OUTLINE = [0, 4, 1, 5, 2, 6, 3, 7]  # slots of a cell in order round it


class FrameError(ValueError):
    """The bytes are damaged or do not continue what is there. The cure: subscribe to the surface again."""


def header_of(frame: bytes) -> Optional[Json]:
    """Returns the header of a mesh frame, see Frame in protocol/wire/FORMAT.md; None for any other bytes."""
    if len(frame) < 48 or frame[:2] != b"WS":
        return None
    if frame[2] != VERSION:
        raise WakesurfError(f"the server sends mesh frames of version {frame[2]}, this client reads version {VERSION}",
                            hint="use the client that came with the server")
    number, epoch, seq, index, count, phase = struct.unpack_from("<3I2HB", frame, 4)
    vertices, cells, when, state_sum = struct.unpack_from("<2IdI", frame, 24)
    return {"subscription": number, "epoch": epoch, "seq": seq,
            "phase": dict(enumerate(("coarse", "refined", "final", "live"))).get(phase, "live"), "vertices": vertices,
            "cells": cells, "state_sum": state_sum, "time": when, "last": index + 1 == count}


class _Info(ctypes.Structure):
    """StateInfo of python/wakesurf_frames.cpp."""

    _fields_ = [(name, ctypes.c_uint32) for name in ("epoch", "seq", "vertices", "cells", "attributes", "lossless", "state_sum")]


@dataclass
class State:
    """A whole state. `nodes` (n, 3): places on the lattice; `attributes`: (n,) values each, NaN for a missing one; `cells` (m, 8):
    corners 0 to 3, then mids 0 to 3, -1 for none. `state_sum`: the checksum, which is right."""

    epoch: int
    seq: int
    lossless: bool
    state_sum: int
    nodes: Array
    cells: Array
    attributes: List[Array]

    def points(self, lattice: Mapping[str, Any]) -> Array:
        """Returns (n, 3) positions; the lattice as `surface.subscribe` or `dataset.describe` report it."""
        points: Array = np.asarray(lattice["origin"]) + lattice["step"] * self.nodes
        return points

    def polygons(self) -> Tuple[Array, Array]:
        """Returns the cells' vertices one cell after the other, and where each cell begins and the last one ends."""
        outlines = self.cells[:, _OUTLINE]
        present = outlines >= 0
        return outlines[present].astype(np.int64), np.concatenate([[0], np.cumsum(present.sum(axis=1))]).astype(np.int64)


class MeshDecoder:
    """Folds the frames of one surface, in order, into its states. `library`: the file; left out, $WAKESURF_FRAMES_LIBRARY, beside this
    file, or where the system has its libraries. Error: OSError if it is missing."""

    def __init__(self, library: Optional[str] = None):
        self._library = _loaded(library)
        self._decoder = self._library.wakesurf_frames_new()
        if not self._decoder:
            raise MemoryError("no memory for a decoder of mesh frames")
        weakref.finalize(self, self._library.wakesurf_frames_free, self._decoder)

    def fold(self, frame: bytes) -> Optional[State]:
        """Returns the state that the frame completed; None before. Error: FrameError; after it only a frame that starts a KEY is
        accepted."""
        done = self._library.wakesurf_frames_fold(self._decoder, frame, len(frame))
        if done < 0:
            raise FrameError(self._library.wakesurf_frames_error(self._decoder).decode("utf-8", "replace"))
        return self._state() if done else None

    def _state(self) -> State:
        info = _Info()
        self._library.wakesurf_frames_info(self._decoder, info)
        nodes, cells = np.empty((info.vertices, 3), np.int32), np.empty((info.cells, 8), np.int32)
        attributes = [np.empty(info.vertices) for _ in range(info.attributes)]
        copied = [self._library.wakesurf_frames_nodes(self._decoder, nodes.ctypes.data, nodes.size),
                  self._library.wakesurf_frames_cells(self._decoder, cells.ctypes.data, cells.size)]
        copied += [self._library.wakesurf_frames_attribute(self._decoder, i, values.ctypes.data, values.size)
                   for i, values in enumerate(attributes)]
        if not all(copied):
            raise FrameError(f"{LIBRARY} is of another version than this client")
        return State(info.epoch, info.seq, bool(info.lossless), info.state_sum, nodes, cells, attributes)


def _loaded(path: Optional[str]) -> ctypes.CDLL:
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), LIBRARY)
    path = path or os.environ.get("WAKESURF_FRAMES_LIBRARY") or (beside if os.path.exists(beside) else None)
    handle, size, word = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_uint32
    signatures = {"new": (handle, []), "free": (None, [handle]), "fold": (ctypes.c_int, [handle, ctypes.c_char_p, size]),
                  "error": (ctypes.c_char_p, [handle]), "info": (ctypes.c_bool, [handle, ctypes.POINTER(_Info)]),
                  "nodes": (ctypes.c_bool, [handle, handle, size]), "cells": (ctypes.c_bool, [handle, handle, size]),
                  "attribute": (ctypes.c_bool, [handle, word, handle, size])}
    try:
        library = ctypes.CDLL(path or ctypes.util.find_library("wakesurf_frames") or LIBRARY)
        for name, (result, arguments) in signatures.items():
            function = getattr(library, "wakesurf_frames_" + name)
            function.restype, function.argtypes = result, arguments
    except (OSError, AttributeError) as problem:
        raise OSError(f"live meshes need {LIBRARY}, which wakesurf's build makes: set $WAKESURF_FRAMES_LIBRARY to it ({problem})") from None
    return library
