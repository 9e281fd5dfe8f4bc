// One mesh in two orders: solvers that balance their load, or that renumber, write the same cells in other pieces
// and other nodes first at every time-step.
#pragma once

#include "importer/assembly/grid_assembly.hpp"

#include <optional>
#include <vector>

namespace wakesurf::importer {

/// Returns the blocks of `mesh` with the values of `step`, if every cell of the one is a cell of the other:
/// between nodes at the same places, to the bit. A node's value is that of its own cells, so that two nodes at
/// one place keep each its own. Empty if the meshes differ. Cost: that of reading the mesh.
std::optional<std::vector<vtkSmartPointer<vtkDataSet>>> values_on(BlockList mesh, BlockList step);

} // namespace wakesurf::importer
