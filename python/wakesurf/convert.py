"""A mesh as the objects of other packages. Each package is imported only when it is needed."""
from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .mesh import Mesh

_WHERE = {"vtkmodules": "Debian: python3-vtk9; pip: vtk", "pyvista": "pip: pyvista", "meshio": "Debian: python3-meshio; pip: meshio",
          "pandas": "Debian: python3-pandas; pip: pandas"}


def needed(name: str) -> Any:
    """Imports an optional package. Error: ImportError, which says where it comes from."""
    try:
        return importlib.import_module(name)
    except ImportError as problem:
        package = name.split(".")[0]
        raise ImportError(f"this needs the package {package} ({_WHERE.get(package, package)}): {problem}") from None


def to_vtk(mesh: Mesh) -> Any:
    needed("vtkmodules")
    core, data = needed("vtkmodules.vtkCommonCore"), needed("vtkmodules.vtkCommonDataModel")
    arrays = needed("vtkmodules.util.numpy_support")

    def array(values: Any) -> Any:
        return arrays.numpy_to_vtk(np.ascontiguousarray(values), deep=True)

    points = core.vtkPoints()
    points.SetData(array(mesh.points))
    cells = data.vtkCellArray()
    cells.SetData(arrays.numpy_to_vtkIdTypeArray(np.ascontiguousarray(mesh.offsets, np.int64), deep=True),
                  arrays.numpy_to_vtkIdTypeArray(np.ascontiguousarray(mesh.connectivity, np.int64), deep=True))
    poly = data.vtkPolyData()
    poly.SetPoints(points)
    poly.SetPolys(cells)
    for name, values in mesh.arrays.items():
        column = array(values)
        column.SetName(name)
        poly.GetPointData().AddArray(column)
    if "speed" in mesh.arrays:
        poly.GetPointData().SetActiveScalars("speed")
    return poly


def to_pyvista(mesh: Mesh) -> Any:
    """Converts by pyvista.wrap, which takes any vtkPolyData."""
    return needed("pyvista").wrap(to_vtk(mesh))


def to_meshio(mesh: Mesh) -> Any:
    quads, triangles = mesh.quads_and_triangles()
    cells = [(kind, part) for kind, part in (("quad", quads), ("triangle", triangles)) if len(part)]
    return needed("meshio").Mesh(mesh.points, cells, point_data={name: np.array(values) for name, values in mesh.arrays.items()})


def to_dataframe(mesh: Mesh) -> Any:
    columns = dict(zip("xyz", mesh.points.T))
    for name, values in mesh.arrays.items():
        if values.ndim == 1:
            columns[name] = values
        else:
            columns.update({f"{name}_{axis}": part for axis, part in zip("xyz", values.T)})
    return needed("pandas").DataFrame(columns)
