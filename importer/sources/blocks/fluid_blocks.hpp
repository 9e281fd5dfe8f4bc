// The common treatment of grids that VTK hands to readers: their three-dimensional part, checked, and its
// fields.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wakesurf::importer {

using Blocks = std::vector<vtkSmartPointer<vtkDataSet>>;

/// Says whether cells of the data set are three-dimensional; a structured one needs at least two nodes along
/// every axis.
bool has_solid_cells(vtkDataSet& data);

/// Returns the three-dimensional cells, `data` itself if it has no others; of a plane its slab (plane_slab.hpp).
/// Error (naming `file`): Corrupt (nodes that do not exist, coordinates that are not finite or do not rise),
/// Unsupported (neither cells in space nor a plane, a rotated image).
core::Result<vtkSmartPointer<vtkDataSet>> fluid_part(vtkDataSet& data, const std::string& file);

/// Returns the arrays that all blocks have, with the same components, and ranges over all; units if VTK has
/// them.
std::vector<core::FieldInfo> common_fields(const Blocks& blocks);

} // namespace wakesurf::importer
