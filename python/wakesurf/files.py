"""Files, written whole or not at all; and a flow of one's own from numpy arrays, as files that the server reads like those of a solver.

    wakesurf.write_series("mine.pvd", times, velocity, origin=(0, 0, 0), spacing=(0.1, 0.1, 0.1))
    with wakesurf.serve("mine.pvd") as session: ...
"""
from __future__ import annotations

import base64
import os
import secrets
import struct
import zlib
from typing import Any, Callable, Iterable, List, Mapping, Optional, Sequence, Union
from xml.sax.saxutils import quoteattr

import numpy as np

from .mesh import Array

_BLOCK = 1 << 20
Values = Union[Sequence[Any], Array, Callable[[int], Any]]


def write_whole(path: str, parts: Iterable[bytes]) -> None:
    """Writes a new file beside the old one and renames it: a reader, or a server that watches, sees no half of it.
    Error: OSError, which names `path`; nothing is left behind then."""
    part = f"{path}.{secrets.token_hex(6)}.part"
    try:
        with open(part, "xb") as file:
            file.writelines(parts)
        os.replace(part, path)
    except OSError as problem:
        _remove(part)
        raise type(problem)(problem.errno, problem.strerror, path) from None
    except BaseException:
        _remove(part)
        raise


def _remove(part: str) -> None:
    if os.path.exists(part):
        os.remove(part)


def write_series(path: Union[str, os.PathLike[str]], times: Sequence[float], velocity: Values, *,
                 origin: Sequence[float] = (0, 0, 0), spacing: Sequence[float] = (1, 1, 1),
                 fields: Optional[Mapping[str, Values]] = None) -> List[str]:
    """Writes a uniform grid at several times: a .vti file each, and `path`, a .pvd that names them. Returns all files.

    `velocity`: for each time an array (nx, ny, nz, 3), or a function from the number of the time to one, so that they need not be in
    memory together. `fields`: names and arrays (nx, ny, nz), or (nx, ny, nz, 3), alike. NaN in the velocity: outside of the flow.

    >>> x, y, z = np.meshgrid(*[np.linspace(-1, 1, 9)] * 3, indexing="ij")
    >>> spin = np.stack([-y, x, 0 * z + 0.2], axis=-1)
    >>> files = wakesurf.write_series("spin.pvd", [0, 1], [spin, 2 * spin], origin=(-1, -1, -1), spacing=(0.25,) * 3)
    >>> [os.path.basename(file) for file in files]
    ['spin.pvd', 'spin_0000.vti', 'spin_0001.vti']
    """
    path = os.fspath(path)
    if os.path.splitext(path)[1] != ".pvd":
        raise ValueError(f"{path!r} must end in .pvd")
    if len(times) == 0 or any(not b > a for a, b in zip(times, times[1:])):
        raise ValueError("the times must rise")
    if np.shape(origin) != (3,) or np.shape(spacing) != (3,) or not all(each > 0 for each in spacing):
        raise ValueError("`origin` and `spacing` are three numbers each, and spacings are greater than 0")
    if not callable(velocity) and len(velocity) != len(times):
        raise ValueError(f"`velocity` has {len(velocity)} arrays for {len(times)} times")
    stem = os.path.splitext(path)[0]
    files: List[str] = []
    shape: Optional[Sequence[int]] = None
    for i in range(len(times)):
        arrays = {"velocity": _at(velocity, i), **{name: _at(values, i) for name, values in (fields or {}).items()}}
        shape = shape or arrays["velocity"].shape[:3]
        for name, values in arrays.items():
            wanted = [(*shape, 3)] if name == "velocity" else [tuple(shape), (*shape, 3)]
            if len(shape) != 3 or min(shape) < 2 or values.shape not in wanted:
                raise ValueError(f"`{name}` at time {i} has the shape {values.shape}, not " + " or ".join(map(str, wanted)))
        file = f"{stem}_{i:04}.vti"
        write_whole(file, _vti(arrays, shape, origin, spacing))
        files.append(file)
    rows = "".join(f"<DataSet timestep={quoteattr(repr(float(time)))} file={quoteattr(os.path.basename(file))}/>\n"
                   for time, file in zip(times, files))
    write_whole(path, [f'<?xml version="1.0"?>\n<VTKFile type="Collection" version="1.0">\n<Collection>\n{rows}</Collection>\n</VTKFile>\n'.encode()])
    return [path, *files]


def _at(values: Values, i: int) -> Array:
    return np.asarray(values(i) if callable(values) else values[i])


def _vti(arrays: Mapping[str, Array], shape: Sequence[int], origin: Sequence[float], spacing: Sequence[float]) -> List[bytes]:
    extent = " ".join(f"0 {n - 1}" for n in shape)

    def words(numbers: Sequence[float]) -> str:
        return " ".join(repr(float(each)) for each in numbers)

    parts = [f'<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64" '
             f'compressor="vtkZLibDataCompressor">\n<ImageData WholeExtent="{extent}" Origin="{words(origin)}" '
             f'Spacing="{words(spacing)}">\n<Piece Extent="{extent}">\n<PointData Vectors="velocity">\n'.encode()]
    for name, values in arrays.items():
        width = values.shape[3] if values.ndim == 4 else 1
        kind = "<f8" if values.dtype == np.float64 else "<f4"
        flat = np.ascontiguousarray(values.swapaxes(0, 2), kind)  # x fastest
        parts += [f'<DataArray type="Float{8 * flat.itemsize}" Name={quoteattr(name)} NumberOfComponents="{width}" format="binary">'.encode(),
                  _packed(flat.tobytes()), b"</DataArray>\n"]
    return [*parts, b"</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n"]


def _packed(data: bytes) -> bytes:
    """Returns compressed arrays as VTK has them inline: the number and the lengths of the blocks, then the blocks."""
    blocks = [zlib.compress(data[at:at + _BLOCK], 1) for at in range(0, len(data), _BLOCK)]
    last = len(data) % _BLOCK
    header = struct.pack(f"<{3 + len(blocks)}Q", len(blocks), _BLOCK, last, *map(len, blocks))
    return base64.b64encode(header) + base64.b64encode(b"".join(blocks))
