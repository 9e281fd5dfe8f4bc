// That a grid is one: what VTK's readers take over from a damaged file, and its algorithms then trip over.
#pragma once

#include "core/base/result.hpp"

#include <vtkDataSet.h>
#include <vtkUnstructuredGrid.h>

#include <string>

namespace wakesurf::importer {

/// 3 for VTK's solid cells of any order, 2 for flat ones and so on; -1 for types VTK does not have.
int cell_dimension(int vtk_cell_type);

/// An unstructured grid: coordinates finite, cells of known types with as many nodes as their type has, all there,
/// and so of the faces of polyhedra. Error: Corrupt, naming `file` and the first cell at fault.
core::Result<void> check_mesh(vtkUnstructuredGrid& grid, const std::string& file);

/// A structured grid with at least two nodes along every axis: coordinates finite; spacings and the axes of
/// rectilinear grids positive. Error: Corrupt; Unsupported (a rotated image).
core::Result<void> check_grid(vtkDataSet& grid, const std::string& file);

} // namespace wakesurf::importer
