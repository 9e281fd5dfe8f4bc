// Flat parts of a source as walls: by their name, or by a velocity that is zero on them.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wakesurf::server {

/// Whether the last part of a patch's path ("boundary/lowerWall") holds "wall", in any case.
bool is_named_wall(const std::string& patch);

/// Whether there is a 3-component one among `fields`, the data set has it, and each of these is exactly zero everywhere.
bool is_still(vtkDataSet& patch, const std::vector<core::FieldInfo>& fields);

/// The patch as polygons with its points as they are; data arrays are left out. Error: Corrupt (nodes that are not
/// there), naming `file`.
core::Result<vtkSmartPointer<vtkPolyData>> surface_of(vtkDataSet& patch, const std::string& file);

} // namespace wakesurf::server
