// Surfaces for walls and solids: the flat parts of a source that are walls, and the outside of solid blocks.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wakesurf::importer {

/// Says whether the last part of a patch's path ("boundary/lowerWall") holds "wall", in any case.
bool is_named_wall(const std::string& patch);

/// Says whether there is a vector among `fields`, the data set has it, and each of these is exactly zero
/// everywhere.
bool is_still(vtkDataSet& patch, const std::vector<core::FieldInfo>& fields);

/// Says whether the first vector of `fields`, the velocity, is exactly zero everywhere.
bool stands_still(vtkDataSet& faces, const std::vector<core::FieldInfo>& fields);

/// Returns the two-dimensional cells of a grid that has no others, with the points and point data it has.
vtkSmartPointer<vtkPolyData> faces_of(vtkDataSet& grid);

/// Returns the patch as polygons with its points as they are; data arrays are left out. Error: Corrupt (nodes
/// that are not there), naming `file`.
core::Result<vtkSmartPointer<vtkPolyData>> surface_of(vtkDataSet& patch, const std::string& file);

/// Returns the outside of a checked block of cells.
vtkSmartPointer<vtkPolyData> boundary_of(vtkDataSet& block);

} // namespace wakesurf::importer
