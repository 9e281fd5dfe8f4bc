// Comparison of the meshes of two time-steps: a store has one grid. Meshes are the same number by number, or as the same cells in
// another order: solvers that balance their load, or renumber, write other pieces and other nodes first at every time-step.
#pragma once

#include "importer/assembly/grid_assembly.hpp"

#include <optional>
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

/// Returns the blocks of `mesh` with the values of `step`, if every cell of the one is a cell of the other:
/// between nodes at the same places, to the bit. A node's value is that of its own cells, so that two nodes at
/// one place keep each its own. Empty if the meshes differ. Cost: that of reading the mesh.
std::optional<std::vector<vtkSmartPointer<vtkDataSet>>> values_on(BlockList mesh, BlockList step);

} // namespace wakesurf::importer
