// A plane in several blocks, as pieces of a parallel run: each alone would be as thick as its own cells are wide.
#pragma once

#include "core/base/result.hpp"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace wakesurf::importer {

/// Makes the slabs of one plane that several blocks lie in equally thick, so that they meet. Error: Unsupported (slabs of
/// several planes, or beside cells in space), to be read after the name of what has the blocks.
core::Result<void> even_slabs(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks);

} // namespace wakesurf::importer
