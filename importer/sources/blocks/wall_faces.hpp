// Faces of walls, and the fluid's velocity on them.
#pragma once

#include "core/dataset/dataset_info.hpp"

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace wakesurf::importer {

/// Is the velocity, the first of `fields` with three components, exactly zero everywhere on `faces`? False where they
/// do not carry it.
bool stands_still(vtkDataSet& faces, const std::vector<core::FieldInfo>& fields);

/// The two-dimensional cells of a grid that has no others, with the points and point data it has.
vtkSmartPointer<vtkPolyData> faces_of(vtkDataSet& grid);

} // namespace wakesurf::importer
