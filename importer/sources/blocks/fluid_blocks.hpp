// What all readers make of the grids VTK hands them: the three-dimensional part, checked, and its fields.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wakesurf::importer {

using Blocks = std::vector<vtkSmartPointer<vtkDataSet>>;

/// Whether cells of the data set are three-dimensional; of a structured one, whether it has at least two nodes along
/// every axis.
bool has_solid_cells(vtkDataSet& data);

/// Its three-dimensional cells, `data` itself where there are no others. Error (naming `file`): Corrupt (cells of
/// nodes that are not there, coordinates that are not finite or do not rise), Unsupported (no three-dimensional cells,
/// a rotated image).
core::Result<vtkSmartPointer<vtkDataSet>> fluid_part(vtkDataSet& data, const std::string& file);

/// One cell along an axis, of a source that is a single structured block, is a plane, not a flow in space.
/// Error: Unsupported, naming the axis.
core::Result<void> check_thickness(const Blocks& blocks, const std::string& file);

/// The arrays that all blocks have, with the same components, ranges over all; units where VTK has them.
std::vector<core::FieldInfo> common_fields(const Blocks& blocks);

} // namespace wakesurf::importer
