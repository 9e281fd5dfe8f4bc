// BlockList of cells -> one core::CellMesh: the part of grid_assembly.hpp that grids of their own need not go through.
#pragma once

#include "importer/assembly/grid_assembly.hpp"

namespace wakesurf::importer {

/// Error: as assemble_grid.
core::Result<GridAssembly> assemble_mesh(BlockList blocks, const AssemblyRequest& request);

} // namespace wakesurf::importer
