// Structured parts of EnSight Gold geometry: curvilinear, rectilinear and uniform blocks.
#pragma once

#include "importer/sources/ensight/ensight_stream.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

namespace wakesurf::importer {

/// What follows the line `shape` ("block", "block rectilinear iblanked" ...). Points blanked out carry vtkGhostType.
/// Error: Corrupt, Unsupported (parts of blocks, ghosts).
core::Result<vtkSmartPointer<vtkDataSet>> read_ensight_block(EnsightStream& in,
                                                             const std::string& shape);

} // namespace wakesurf::importer
