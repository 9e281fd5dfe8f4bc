"""Decodes the binary messages of wakesurf: the live meshes of a surface, as numpy arrays, for `Surface.live`. It needs numpy, and for
Draco the library libwakesurf_draco that wakesurf's build makes.

    decoder = MeshDecoder()
    for message in binary_messages:
        state = decoder.fold(message)          # a State when the message made an update whole
        if state is not None:
            print(len(state.nodes), "vertices", len(state.cells), "quads")

The format is described in protocol/wire/FORMAT.md; names here are those of its sections. Not thread safe.
"""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import struct
import zlib
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

__all__ = ["Draco", "FrameError", "Header", "MeshDecoder", "State", "read_header", "word_sum"]

VERSION = 5
PHASES = ("coarse", "refined", "final", "live")
_HEADER = struct.Struct("<2s2B3I2H4B2Id2I")
_BLOCK_VERTICES, _MOST = 1 << 16, 1 << 24  # of a block; vertices or cells of a mesh
_LARGEST_CHANGE = 1 << 20
_OUTLINE = [0, 4, 1, 5, 2, 6, 3, 7]  # slots of a cell in order round it
_NEAR = [0, 1, 1, 0, 0, 1, 2, 3]  # by slot: the slot whose vertex a new vertex is near
_MEAN = 4  # the predictor of changes
_NO_BLOCKS = np.empty(0, np.int64)


class FrameError(ValueError):
    """The bytes are damaged or do not continue what is there. The cure: subscribe to the surface again."""


@dataclass(frozen=True)
class Header:
    """Holds what a frame says of its update."""

    key: bool
    lossless: bool
    subscription: int
    epoch: int
    seq: int
    index: int
    count: int
    phase: str
    lattice_bits: int
    attributes: int
    gaps: int
    vertices: int
    cells: int
    time: float
    state_sum: int


def read_header(frame: bytes) -> Header:
    """Reads a header. Error: FrameError for anything but a whole, undamaged frame of this version."""
    if len(frame) < _HEADER.size or frame[:2] != b"WS":
        raise FrameError("a binary message is not a mesh frame")
    if frame[2] != VERSION:
        raise FrameError(f"a mesh frame has version {frame[2]}, this client reads version {VERSION}: "
                         "use the files that came with the server")
    _, _, flags, surface, epoch, seq, index, count, phase, bits, attributes, gaps, vertices, cells, when, total, crc = \
        _HEADER.unpack_from(frame)
    if zlib.crc32(frame[_HEADER.size:], zlib.crc32(frame[:44])) != crc:
        raise FrameError("a mesh frame does not match its checksum")
    if flags > 3 or phase > 3 or gaps >> attributes or index >= count or not 1 <= bits <= 20 or attributes > 8 or \
            not np.isfinite(when) or max(vertices, cells) > _MOST or (not flags & 1 and seq == 0):
        raise FrameError("a mesh frame's header contradicts itself")
    return Header(bool(flags & 1), bool(flags & 2), surface, epoch, seq, index, count, PHASES[phase], bits, attributes,
                  gaps, vertices, cells, when, total)


class Draco:
    """Loads the shared library that decodes Draco blocks. `path`: the file; left out, $WAKESURF_DRACO, beside this
    file, or where the system has its libraries. Error: OSError if it is missing."""

    def __init__(self, path: Optional[str] = None):
        name = "libwakesurf_draco.so"
        beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
        path = path or os.environ.get("WAKESURF_DRACO") or (beside if os.path.exists(beside) else None)
        try:
            self._decode = ctypes.CDLL(path or ctypes.util.find_library("wakesurf_draco") or name).wakesurf_draco_decode
        except OSError as problem:
            raise OSError(f"live meshes need {name}, which wakesurf's build makes: set $WAKESURF_DRACO to it ({problem})") from None
        self._decode.restype = ctypes.c_int
        self._decode.argtypes = [ctypes.c_char_p, ctypes.c_size_t, ctypes.c_uint32, ctypes.c_uint32,
                                 ctypes.POINTER(ctypes.c_uint8), ctypes.POINTER(ctypes.c_int32)]

    def decode(self, block: bytes, points: int, components: Sequence[int]) -> List[Array]:
        """Returns an array (points, components) for each channel. Error: FrameError."""
        values = np.empty(points * sum(components), np.int32)
        status = self._decode(block, len(block), points, len(components), (ctypes.c_uint8 * len(components))(*components),
                              values.ctypes.data_as(ctypes.POINTER(ctypes.c_int32)))
        if status != 0:
            raise FrameError("the Draco block of a mesh update is damaged")
        ends = np.cumsum([points * n for n in components])
        return [part.reshape(points, -1).astype(np.int64) for part in np.split(values, ends[:-1])]


class _Numbers:
    """Holds the numbers at the beginning of an update, to be taken in order, and `rest`, the Draco blocks."""

    def __init__(self, update: bytes):
        packed, at = self._varint(update, 0)
        size, at = self._varint(update, at)
        inflate = zlib.decompressobj(-15)
        try:
            octets = np.frombuffer(inflate.decompress(update[at:at + packed], size + 1), np.uint8)
        except zlib.error as problem:
            raise FrameError(f"the numbers of a mesh update are damaged: {problem}") from None
        if len(octets) != size or not inflate.eof or (size and octets[-1] >= 0x80):
            raise FrameError("a mesh update holds other numbers than it announces")
        ends = np.flatnonzero(octets < 0x80)
        starts = np.concatenate([[0], ends + 1])[:-1]
        widths = ends - starts + 1
        if size and widths.max() > 5:
            raise FrameError("a mesh update holds a number of more than 32 bits")
        self._all = np.zeros(len(ends), np.int64)
        for k in range(widths.max() if size else 0):
            longer = widths > k
            self._all[longer] |= (octets[starts[longer] + k].astype(np.int64) & 0x7f) << (7 * k)
        if (self._all >> 32).any():
            raise FrameError("a mesh update holds a number of more than 32 bits")
        self._at = 0
        self.rest = update[at + packed:]

    @staticmethod
    def _varint(data: bytes, at: int) -> Tuple[int, int]:
        value = 0
        for k in range(5):
            if at + k >= len(data):
                break
            value |= (data[at + k] & 0x7f) << (7 * k)
            if data[at + k] < 0x80 and value < 1 << 32:
                return value, at + k + 1
        raise FrameError("a mesh update ends within its numbers")

    @property
    def left(self) -> int:
        return len(self._all) - self._at

    def take(self, count: int) -> Array:
        if count > self.left:
            raise FrameError("a mesh update holds too few numbers")
        self._at += count
        return self._all[self._at - count:self._at]

    def next(self, most: int = 0xffffffff) -> int:
        value = int(self.take(1)[0])
        if value > most:
            raise FrameError(f"a mesh update holds {value} where at most {most} may stand")
        return value

    def signed(self, count: int) -> Array:
        codes = self.take(count)
        return (codes >> 1) ^ -(codes & 1)

    def runs(self, over: int) -> Array:
        """Returns the indices below `over` that are taken, ascending."""
        pairs = self.take(2 * self.next(over)).reshape(-1, 2)
        ends = np.cumsum(pairs.sum(axis=1))
        if len(pairs) and (pairs[:, 1].min() == 0 or ends[-1] > over):
            raise FrameError("a mesh update names vertices or cells that are not there")
        taken = np.zeros(over + 1, np.int64)
        np.add.at(taken, ends - pairs[:, 1], 1)
        np.add.at(taken, ends, -1)
        return np.flatnonzero(np.cumsum(taken)[:-1])


def word_sum(words: Array) -> int:
    """Returns the state checksum: the sum of a list of 32 bit words."""
    words = np.ascontiguousarray(words).ravel().astype(np.int64).astype(np.uint32)

    def stir(total: int, word: int) -> int:
        mixed = (total ^ word) & 0xffffffff
        return ((mixed << 13 | mixed >> 19) & 0xffffffff) * 0x9e3779b1 & 0xffffffff

    total = len(words) & 0xffffffff
    for lane in (words[first::4].astype(np.uint64) for first in range(4)):
        again = lane * np.arange(len(lane), 0, -1, dtype=np.uint64)
        total = stir(stir(total, int(lane.sum()) & 0xffffffff), int(again.sum()) & 0xffffffff)
    return total ^ total >> 15


@dataclass
class State:
    """Holds a whole state. `nodes` (n, 3): places on the lattice; `codes`, `ranges`: (n,) and (lo, hi) an attribute;
    `cells` (m, 8): corners 0 to 3, then mids 0 to 3, -1 for none."""

    header: Header
    ranges: List[Tuple[float, float]] = field(default_factory=list)
    nodes: Array = field(default_factory=lambda: np.empty((0, 3), np.int64))
    change: Array = field(default_factory=lambda: np.empty((0, 3), np.int64))
    codes: List[Array] = field(default_factory=list)
    cells: Array = field(default_factory=lambda: np.empty((0, 8), np.int64))

    def points(self, lattice: Mapping[str, Any]) -> Array:
        """Returns (n, 3) positions; the lattice as `surface.subscribe` or `dataset.describe` report it."""
        points: Array = np.asarray(lattice["origin"]) + lattice["step"] * self.nodes
        return points

    def attribute(self, index: int) -> Array:
        """Returns (n,) values; NaN for a missing one."""
        lo, hi = self.ranges[index]
        codes = self.codes[index]
        if not self.header.gaps >> index & 1:
            values: Array = lo + (hi - lo) * codes / 65535
            return values
        known: Array = np.where(codes < 0xF800, lo + (hi - lo) * codes / 0xEFFF, np.nan)
        return known

    def polygons(self) -> Tuple[Array, Array]:
        """Returns the cells' vertices one cell after the other, and where each cell begins and the last one ends."""
        outlines = self.cells[:, _OUTLINE]
        ends = np.cumsum((outlines >= 0).sum(axis=1))
        return outlines[outlines >= 0], np.concatenate([[0], ends]).astype(np.int64)

    def sum(self) -> int:
        """Returns the value that the header's `state_sum` must have."""
        parts = [len(self.nodes), word_sum(self.nodes), len(self.cells), word_sum(self.cells)]
        return word_sum(np.array(parts + [word_sum(codes) for codes in self.codes]))


class MeshDecoder:
    """Folds the frames of one surface, in order, into its states."""

    def __init__(self, draco: Optional[Draco] = None):
        self._draco = draco
        self._pieces: List[bytes] = []
        self._header: Optional[Header] = None  # of the newest frame of an unfinished update
        self._intact = False
        self.state: Optional[State] = None  # the newest whole one

    def fold(self, frame: bytes) -> Optional[State]:
        """Returns the state that the frame completed; None before. Error: FrameError; after it only a frame that
        starts a KEY is accepted."""
        try:
            header = read_header(frame)
            self._check_order(header)
            if header.index == 0:
                self._pieces = []
            self._pieces.append(frame[_HEADER.size:])
            self._header = header
            if header.index + 1 < header.count:
                return None
            self._header = None
            self.state = self._applied(header, b"".join(self._pieces))
            self._intact = True
            return self.state
        except FrameError:
            self._header, self._intact = None, False
            raise

    def _check_order(self, h: Header) -> None:
        newest = self.state.header if self.state else None
        if newest and h.subscription != newest.subscription:
            raise FrameError(f"a frame of subscription {h.subscription} came to {newest.subscription}")
        if h.index > 0:
            same = self._header and {**vars(self._header), "index": h.index} == vars(h)
            fits = same and self._header is not None and h.index == self._header.index + 1
        elif h.key:
            fits = not newest or (h.epoch, h.seq) >= (newest.epoch, newest.seq)
        else:
            fits = self._intact and not self._header and newest and h.epoch == newest.epoch and \
                h.seq == newest.seq + 1 and h.attributes == newest.attributes and h.gaps == newest.gaps and h.lattice_bits == newest.lattice_bits
        if not fits:
            raise FrameError(f"frame {h.index} of update {h.seq} of epoch {h.epoch} does not continue what is there")

    def _applied(self, h: Header, update: bytes) -> State:
        numbers = _Numbers(update)
        if h.key:
            bounds = numbers.take(4 * h.attributes).astype("<u4").view("<f8").reshape(-1, 2)
            if not np.isfinite(bounds).all() or (bounds[:, 0] > bounds[:, 1]).any():
                raise FrameError("a mesh update has an attribute without a range")
            before = State(h, [(float(lo), float(hi)) for lo, hi in bounds], codes=[_NO_BLOCKS] * h.attributes)
        else:
            assert self.state is not None  # _check_order has seen it
            before = self.state
        after, moved, old = _edited(before, h, numbers)
        _Points(self._draco_library, after, old, moved).read(numbers)
        if after.sum() != h.state_sum:
            raise FrameError("the mesh does not match the server's checksum")
        return after

    def _draco_library(self) -> Draco:
        self._draco = self._draco or Draco()
        return self._draco


def _edited(before: State, h: Header, numbers: _Numbers) -> Tuple[State, Array, State]:
    """Reads the topology. Returns the new state, its points as before and 0 for new ones; the moved vertices; what
    stays of the old state."""
    gone = numbers.runs(len(before.nodes))
    added = numbers.next(_MOST)
    stay = len(before.nodes) - len(gone)
    moved = numbers.runs(stay)
    removed = numbers.runs(len(before.cells))
    cells = np.delete(before.cells, removed, axis=0)
    replaced = numbers.runs(len(cells))
    more = numbers.next(_MOST)
    if (stay + added, len(cells) + more) != (h.vertices, h.cells):
        raise FrameError("a mesh update leads to other numbers of vertices and cells than it announces")
    if len(moved) + added > _BLOCK_VERTICES * h.count:
        raise FrameError("a mesh update announces more vertices than its frames may hold")
    now = np.full(len(before.nodes) + 1, -1)  # the last one is that of none
    now[np.delete(np.arange(len(before.nodes)), gone)] = np.arange(stay)
    cells = now[cells]
    new = _new_cells(numbers, cells[replaced], more, stay, h.vertices)
    cells[replaced] = new[:len(replaced)]
    if (cells[:, :4] < 0).any():
        raise FrameError("a cell that stays in a mesh update has lost a corner")
    old = State(before.header, before.ranges, np.delete(before.nodes, gone, axis=0), np.delete(before.change, gone, axis=0),
                [np.delete(codes, gone) for codes in before.codes])
    room = np.zeros((added, 3), np.int64)
    after = State(h, before.ranges, np.concatenate([old.nodes, room]), np.zeros((stay + added, 3), np.int64),
                  [np.concatenate([codes, room[:, 0]]) for codes in old.codes], np.concatenate([cells, new[len(replaced):]]))
    return after, moved, old


def _new_cells(numbers: _Numbers, old: Array, added: int, stay: int, vertices: int) -> Array:
    """Reads the replaced cells, which were `old`, then the added ones."""
    mids = numbers.take(len(old) + added)
    was = np.concatenate([old, np.full((added, 8), -1)])
    cells = np.full(was.shape, -1)
    for slot in range(8):
        rows = np.arange(len(cells)) if slot < 4 else np.flatnonzero(mids >> (slot - 4) & 1)
        difference = numbers.signed(len(rows))
        new = was[rows, slot] < 0
        base = was[rows, slot]
        if slot < 2:
            base[new] = stay + np.cumsum(difference[new]) - difference[new]
        else:
            base[new] = cells[rows[new], _NEAR[slot]]
        cells[rows, slot] = base + difference
        if len(rows) and not 0 <= cells[rows, slot].min() <= cells[rows, slot].max() < vertices:
            raise FrameError("a cell of a mesh update has a vertex that is not there")
    return cells


class _Neighbours:
    """Holds the neighbours of each vertex, -1 for none: a, b, p, n, o."""

    def __init__(self, cells: Array, vertices: int):
        self.a, self.b, self.p, self.n, self.o = (np.full(vertices, -1) for _ in range(5))
        corners, mids = cells[:, :4], cells[:, 4:]
        after = np.roll(corners, -1, axis=1)
        there = mids >= 0
        ends = np.concatenate([np.stack([corners, np.where(there, mids, after)], axis=-1).reshape(-1, 2),
                               np.stack([mids[there], after[there]], axis=-1)])
        ends = np.sort(ends[ends[:, 0] != ends[:, 1]], axis=1)
        ends = ends[np.argsort(ends[:, 0], kind="stable")]
        self.a[ends[:, 1]] = ends[:, 0]  # of several the last one stays
        self.b[ends[::-1, 1]] = ends[::-1, 0]
        top = np.argmax(corners, axis=1)
        rows = np.arange(len(cells))
        others = [corners[rows, (top + k) % 4] for k in (3, 1, 2)]
        highest = corners[rows, top]
        whole = np.all([other < highest for other in others], axis=0)[::-1]
        for into, other in zip((self.p, self.n, self.o), others):
            into[highest[::-1][whole]] = other[::-1][whole]
        hangs = (there & (corners < mids) & (after < mids)).ravel()[::-1]
        hanging = mids.ravel()[::-1][hangs]
        for into, end in ((self.p, corners), (self.n, after)):
            into[hanging] = end.ravel()[::-1][hangs]
        self.o[hanging] = -1

    def lists(self) -> Tuple[List[int], ...]:
        return tuple(each.tolist() for each in (self.a, self.b, self.p, self.n, self.o))


class _Points:
    """Fills in the points of a new state from those that stayed of the old one."""

    def __init__(self, draco: Any, after: State, old: State, moved: Array):
        self._draco, self._after, self._old, self._moved = draco, after, old, moved
        self._near = _Neighbours(after.cells, len(after.nodes)).lists()

    def read(self, numbers: _Numbers) -> None:
        stay, after = len(self._old.nodes), self._after
        last = 2 ** after.header.lattice_bits - 1
        rest = numbers.rest
        channels: List[Any] = [("nodes", None, 0, last)] + [("codes", i, 0, 65535) for i in range(len(after.codes))]
        for kind, coded in enumerate((self._moved, np.arange(stay, len(after.nodes)))):
            if kind == 1:
                channels.append(("change", None, -_LARGEST_CHANGE, _LARGEST_CHANGE))
            while len(coded):
                components = [1 if name == "codes" else 3 for name, *_ in channels]
                count, codings, residuals, rest = self._block(numbers, rest, len(coded), components, kind)
                for channel, coding, some in zip(channels, codings, residuals):
                    self._fill(kind, channel, coding, coded[:count].tolist(), some)
                coded = coded[count:]
        if numbers.left or rest:
            raise FrameError("a mesh update goes on after its last vertex")

    def _block(self, numbers: _Numbers, rest: bytes, most: int, components: List[int], kind: int) -> Tuple[Any, ...]:
        count = numbers.next(min(most, _BLOCK_VERTICES))
        if count == 0:
            raise FrameError("a mesh update holds a block without vertices")
        bits = numbers.next(2 ** len(components) - 1)
        codings = [(numbers.next((3, 5)[kind]), 2 * numbers.next(32767) + 1) for _ in components[:len(components) - kind]]
        codings += [(_MEAN, 1)] * kind
        escapes = numbers.next(count)
        each = numbers.take(escapes * (1 + sum(components))).reshape(escapes, 1 + sum(components))
        escaped = np.cumsum(each[:, 0] + 1) - 1
        if escapes and escaped[-1] >= count:
            raise FrameError("a mesh update holds a residual of a vertex that is not in its block")
        size = numbers.next(len(rest)) if bits else 0
        used = [c for c in range(len(components)) if bits >> c & 1]
        residuals = [np.zeros((count, n), np.int64) for n in components]
        if used:
            for c, values in zip(used, self._draco().decode(rest[:size], count, [components[c] for c in used])):
                residuals[c] = values
        large = (each[:, 1:] >> 1) ^ -(each[:, 1:] & 1)
        for values, some in zip(residuals, np.split(large, np.cumsum(components)[:-1], axis=1)):
            values[escaped] = some
        return count, codings, residuals, rest[size:]

    def _fill(self, kind: int, channel: Tuple[Any, ...], coding: Tuple[int, int], coded: List[int],
              residuals: Array) -> None:
        """Fills one channel of a block, in plain Python: each vertex needs those before it."""
        name, index, first, last = channel
        predictor, step = coding
        values = getattr(self._after, name) if index is None else self._after.codes[index][:, None]
        if kind == 0 and name == "codes" and predictor == 0 and not residuals.any():
            return
        stay = len(self._old.nodes)
        for k in range(values.shape[1]):
            x, r = values[:, k].tolist(), (residuals[:, k] * step).tolist()
            before = x[:stay]
            if name == "nodes":
                before, h = self._old.nodes[:, k].tolist(), self._old.change[:, k].tolist()
            elif name == "codes":
                before, h = self._old.codes[index].tolist(), [0] * stay
            predict = _moves(self._near, predictor, x, before, h) if kind == 0 else \
                _additions(self._near, predictor, x, before)
            for v, residual in zip(coded, r):
                x[v] = min(max(predict(v) + residual, first), last)
            values[:, k] = x
            if kind == 0 and name == "nodes":
                self._after.change[coded, k] = values[coded, k] - self._old.nodes[coded, k]


def _moves(near: Tuple[List[int], ...], predictor: int, x: List[int], before: List[int], h: List[int]) -> Any:
    """Returns the prediction for a vertex that was there before."""
    a, b, p, n, o = near

    def d(v: int) -> int:
        return x[v] - before[v]

    changes: Sequence[Callable[[int], int]] = (
        lambda v: h[v],
        lambda v: (d(a[v]) + d(b[v])) >> 1,
        lambda v: h[v] + ((d(a[v]) - h[a[v]] + d(b[v]) - h[b[v]]) >> 1),
        lambda v: d(p[v]) + d(n[v]) - d(o[v]) if o[v] >= 0 else (d(a[v]) + d(b[v])) >> 1)
    change = changes[predictor]
    return lambda v: before[v] + (change(v) if a[v] >= 0 else h[v])


def _additions(near: Tuple[List[int], ...], predictor: int, x: List[int], before: List[int]) -> Any:
    """Returns the prediction for an appended vertex."""
    a, b, p, n, o = near
    stay = len(before)

    def corner(p: int, q: int, o: int) -> int:
        return x[p] + x[q] - x[o] if o >= 0 else (x[p] + x[q]) >> 1

    formulas: Sequence[Callable[[int], int]] = (
        lambda v: x[a[v]],
        lambda v: x[b[v]],
        lambda v: corner(a[v], a[v], a[a[v]]),
        lambda v: corner(p[v], n[v], o[v]) if p[v] >= 0 else x[a[v]],
        lambda v: corner(a[v], b[v], -1),
        lambda v: before[b[v]] if b[v] < stay else x[a[v]])
    formula = formulas[predictor]
    return lambda v: formula(v) if a[v] >= 0 else x[v - 1] if v > 0 else 0
