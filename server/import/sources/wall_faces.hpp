// Faces of walls, and the fluid's velocity on them.
#pragma once

#include "core/dataset/dataset_info.hpp"

#include <vtkDataSet.h>

#include <vector>

namespace wakesurf::server {

/// Is the velocity, the first of `fields` with three components, exactly zero everywhere on `faces`? False where they
/// do not carry it.
bool stands_still(vtkDataSet& faces, const std::vector<core::FieldInfo>& fields);

} // namespace wakesurf::server
