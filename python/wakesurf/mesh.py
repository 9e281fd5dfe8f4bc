"""A surface as numpy arrays: from the .vtp files that it comes in, and to other packages."""
from __future__ import annotations

import base64
import difflib
import importlib
import itertools
import struct
import xml.etree.ElementTree
import zlib
from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Tuple

import numpy as np
from numpy.typing import NDArray

from .errors import NoSuchArray
from .plain import Json

Array = NDArray[Any]

_WHERE = {"vtkmodules": "Debian: python3-vtk9; pip: vtk", "pyvista": "pip: pyvista", "meshio": "Debian: python3-meshio; pip: meshio",
          "pandas": "Debian: python3-pandas; pip: pandas"}


@dataclass
class Mesh:
    """A surface as arrays: `points` (n, 3), and cell i's vertices `connectivity[offsets[i]:offsets[i + 1]]`. By name, as
    in `mesh["speed"]`, the arrays at the vertices: s, t, speed, velocity (n, 3), deformation, component, approximated
    and the scalar fields asked for. `about`: kind, dataset, rake, from, to, separation, version; `time` where it is not
    shown at its end.

    >>> mesh = surface.mesh()
    >>> mesh.points.shape == (len(mesh["speed"]), 3)
    True
    """

    points: Array
    connectivity: Array
    offsets: Array
    arrays: Dict[str, Array]
    about: Json

    def __getitem__(self, name: str) -> Array:
        """Returns an array. Error: NoSuchArray, which lists the arrays and says how to ask for others."""
        if name in self.arrays:
            return self.arrays[name]
        right = next(iter(difflib.get_close_matches(name, self.arrays, 1, 0.8)), None)
        hint = f"did you mean `{right}`?" if right else (
            f'ask for it where the surface is made, session.surface(..., fields=["{name}"]), or later: '
            f'surface.set(fields=["{name}"]), surface.wait(), surface.mesh()')
        raise NoSuchArray(f"this mesh has no `{name}`, but {', '.join(self.arrays)}", 0, "notFound", hint)

    def __repr__(self) -> str:
        return f"Mesh({len(self.points)} points, {len(self.offsets) - 1} cells, {', '.join(self.arrays)})"

    @property
    def polygons(self) -> List[Array]:
        """Returns the vertices of each cell: 4 corners and the hanging nodes of its sides, in order."""
        return np.split(self.connectivity, self.offsets[1:-1]) if len(self.offsets) > 1 else []

    @property
    def quads(self) -> Array:
        """Returns (m, 4): the cells without hanging nodes."""
        return self._of_size(4)

    def quads_and_triangles(self) -> Tuple[Array, Array]:
        """Returns (m, 4) and (k, 3): the cells without hanging nodes, and the others cut into triangles. No gaps open
        between them.

        >>> quads, triangles = mesh.quads_and_triangles()
        >>> np.isclose(mesh.areas(quads).sum() + mesh.areas(triangles).sum(), mesh.areas(mesh.triangles()).sum(), rtol=1e-3)
        True
        """
        return self.quads, self._fans([size for size in np.unique(np.diff(self.offsets)) if size != 4])

    def areas(self, cells: Array) -> Array:
        """Returns (m,) areas of quads or triangles, in the dataset's unit of length squared; a bent quad counts as
        its two triangles."""
        corners = [self.points[cells[:, i]] for i in range(cells.shape[1])]
        halves = [np.cross(corners[i] - corners[0], corners[i + 1] - corners[0]) for i in range(1, len(corners) - 1)]
        total: Array = np.sum([np.linalg.norm(each, axis=1) / 2 for each in halves], axis=0)
        return total

    def normals(self) -> Array:
        """Returns (n, 3) unit normals at the vertices, of the triangles around each by their area; zero without any."""
        triangles = self.triangles()
        a, b, c = (self.points[triangles[:, i]] for i in range(3))
        sums = np.zeros_like(self.points)
        np.add.at(sums, triangles, np.cross(b - a, c - a)[:, None, :])
        lengths = np.linalg.norm(sums, axis=1, keepdims=True)
        unit: Array = np.divide(sums, lengths, out=np.zeros_like(sums), where=lengths > 0)
        return unit

    def _of_size(self, size: int) -> Array:
        starts = self.offsets[:-1][np.diff(self.offsets) == size]
        cells: Array = self.connectivity[starts[:, None] + np.arange(size)]
        return cells

    def triangles(self) -> Array:
        """Returns (k, 3): each cell cut into a fan, round the vertex that makes the flattest triangle least flat.
        Neighbours share edges, so no gaps open at hanging nodes."""
        return self._fans(np.unique(np.diff(self.offsets)))

    def _fans(self, sizes: Iterable[int]) -> Array:
        parts: List[Array] = [np.empty((0, 3), dtype=np.int64)]
        for size in sizes:
            cells = self._of_size(int(size))
            fans = np.stack([np.stack([np.roll(cells, -first, axis=1)[:, [0, k, k + 1]]
                                       for k in range(1, size - 1)], axis=1) for first in range(size)], axis=1)
            best = self._fatness(fans).min(axis=2).argmax(axis=1)
            parts.append(fans[np.arange(len(cells)), best].reshape(-1, 3))
        return np.concatenate(parts)

    def _fatness(self, triangles: Array) -> Array:
        a, b, c = (self.points[triangles[..., i]] for i in range(3))
        area = np.linalg.norm(np.cross(b - a, c - a), axis=-1)
        sides = ((b - a) ** 2).sum(-1) + ((c - b) ** 2).sum(-1) + ((a - c) ** 2).sum(-1)
        fatness: Array = area / np.maximum(sides, np.finfo(float).tiny)
        return fatness

    # For other packages, each of which is imported only here.

    def to_vtk(self) -> Any:
        """Returns a vtkPolyData with all arrays. Needs VTK (Debian: python3-vtk9; pip: vtk), or ParaView's Python."""
        needed("vtkmodules")
        core, data = needed("vtkmodules.vtkCommonCore"), needed("vtkmodules.vtkCommonDataModel")
        arrays = needed("vtkmodules.util.numpy_support")

        def array(values: Any) -> Any:
            return arrays.numpy_to_vtk(np.ascontiguousarray(values), deep=True)

        points = core.vtkPoints()
        points.SetData(array(self.points))
        cells = data.vtkCellArray()
        cells.SetData(arrays.numpy_to_vtkIdTypeArray(np.ascontiguousarray(self.offsets, np.int64), deep=True),
                      arrays.numpy_to_vtkIdTypeArray(np.ascontiguousarray(self.connectivity, np.int64), deep=True))
        poly = data.vtkPolyData()
        poly.SetPoints(points)
        poly.SetPolys(cells)
        for name, values in self.arrays.items():
            column = array(values)
            column.SetName(name)
            poly.GetPointData().AddArray(column)
        if "speed" in self.arrays:
            poly.GetPointData().SetActiveScalars("speed")
        return poly

    def to_pyvista(self) -> Any:
        """Returns a pyvista.PolyData with all arrays. Needs pyvista."""
        return needed("pyvista").wrap(self.to_vtk())

    def to_meshio(self) -> Any:
        """Returns a meshio.Mesh of quads and triangles with all arrays, for the formats that meshio writes. Needs
        meshio."""
        quads, triangles = self.quads_and_triangles()
        cells = [(kind, part) for kind, part in (("quad", quads), ("triangle", triangles)) if len(part)]
        return needed("meshio").Mesh(self.points, cells, point_data={name: np.array(values) for name, values in self.arrays.items()})

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame with a row a vertex: x, y, z, and a column for each array, three for a vector.
        Needs pandas.

        >>> list(mesh.to_dataframe().columns)[:5]
        ['x', 'y', 'z', 's', 't']
        """
        columns = dict(zip("xyz", self.points.T))
        for name, values in self.arrays.items():
            if values.ndim == 1:
                columns[name] = values
            else:
                columns.update({f"{name}_{axis}": part for axis, part in zip("xyz", values.T)})
        return needed("pandas").DataFrame(columns)

    @staticmethod
    def from_vtp(data: bytes) -> "Mesh":
        """Reads the .vtp files wakesurf writes (inline, compressed), also those of the command line."""
        root = xml.etree.ElementTree.fromstring(data)
        if root.get("compressor") != "vtkZLibDataCompressor" or root.get("header_type") != "UInt64":
            raise ValueError("this .vtp was not written by this version of wakesurf: read it with VTK")
        types = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8", "UInt32": "<u4", "UInt8": "u1"}
        arrays: Dict[str, Array] = {}
        about: Json = {}
        for node in root.iter("DataArray"):
            name, width = node.get("Name", ""), int(node.get("NumberOfComponents", "1"))
            if node.get("format") == "ascii":
                words = (node.text or "").split()
                if node.get("type") == "String":
                    about[name] = bytes(int(word) for word in words[:-1]).decode()
                else:
                    numbers = np.array(words, dtype=float)
                    name = "time" if name == "TimeValue" else name
                    about[name] = numbers.reshape(-1, width) if width > 1 else float(numbers[0])
                continue
            values = np.frombuffer(_inline(node.text or ""), np.dtype(types[node.get("type", "")]))
            arrays[name] = values.reshape(-1, width) if width > 1 else values
        offsets = np.concatenate([[0], arrays.pop("offsets")]).astype(np.int64)
        return Mesh(arrays.pop("Points"), arrays.pop("connectivity"), offsets, arrays, about)


def needed(name: str) -> Any:
    """Imports an optional package. Error: ImportError, which says where it comes from."""
    try:
        return importlib.import_module(name)
    except ImportError as problem:
        package = name.split(".")[0]
        raise ImportError(f"this needs the package {package} ({_WHERE.get(package, package)}): {problem}") from None


def _inline(text: str) -> bytes:
    """Returns the bytes of an array in a .vtp: the number and the lengths of the blocks, then the blocks."""
    (blocks,) = struct.unpack("<Q", base64.b64decode(text[:12])[:8])
    header_text = (8 * (3 + blocks) + 2) // 3 * 4
    sizes = struct.unpack(f"<{3 + blocks}Q", base64.b64decode(text[:header_text]))[3:]
    packed = memoryview(base64.b64decode(text[header_text:]))
    ends = list(itertools.accumulate(sizes, initial=0))
    return b"".join(zlib.decompress(packed[first:last]) for first, last in zip(ends, ends[1:]))
