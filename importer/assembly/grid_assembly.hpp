// A source's blocks -> one core::Grid and the way from the blocks' points and cells to its nodes. Done once
// for all time-steps of a source: they share one mesh.
#pragma once

#include "importer/assembly/mesh_assembly.hpp"

namespace wakesurf::importer {

/// Says whether assemble_grid makes anything but a mesh of cells. One image is a uniform grid, one
/// rectilinear grid a rectilinear one, unless cells of it are blanked or solid or the image is rotated;
/// everything else is a mesh of cells.
bool is_grid(BlockList blocks);

/// Returns the grid of all blocks. Error, to be read after the file's name: Unsupported (no three-dimensional
/// cells, curved cells), Corrupt, OverLimit (2^32 points).
core::Result<GridAssembly> assemble_grid(BlockList blocks, const AssemblyRequest& request = {});

} // namespace wakesurf::importer
