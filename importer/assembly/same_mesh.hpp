// Comparison of the meshes of two time-steps, number by number: a store has one grid.
#pragma once

#include "importer/assembly/grid_assembly.hpp"

#include <vector>

namespace wakesurf::importer {

/// Returns copies of the blocks without their values, which same_mesh does not need, so that those can be
/// freed.
std::vector<vtkSmartPointer<vtkDataSet>> without_values(BlockList blocks);

/// Compares points, cells, faces of polyhedra and blanking. Quick if a reader returns the same arrays again.
bool same_mesh(BlockList a, BlockList b);
bool same_block(vtkDataSet& a, vtkDataSet& b);

/// Replaces the arrays of `to` by those of `from`, which has the same mesh: memory is freed, and comparing
/// again costs nothing.
void share_mesh(vtkDataSet& from, vtkDataSet& to);

} // namespace wakesurf::importer
