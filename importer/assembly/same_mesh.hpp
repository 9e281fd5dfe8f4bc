// Whether two time-steps have one mesh: compared number by number, since a store has one grid.
#pragma once

#include "importer/assembly/grid_assembly.hpp"

#include <vector>

namespace wakesurf::importer {

/// Blocks without their values, which may be freed then: what same_mesh needs of them.
std::vector<vtkSmartPointer<vtkDataSet>> without_values(BlockList blocks);

/// Points, cells, faces of polyhedra and what is blanked; quick where a reader returns the same arrays again.
bool same_mesh(BlockList a, BlockList b);
bool same_block(vtkDataSet& a, vtkDataSet& b);

/// Lets `to` share the arrays of `from`, which has the same mesh: its own are freed, and comparing again costs nothing.
void share_mesh(vtkDataSet& from, vtkDataSet& to);

} // namespace wakesurf::importer
