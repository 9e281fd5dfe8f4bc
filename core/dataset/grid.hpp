// The grid of a dataset as its source has it: nothing is resampled. What kind it is decides how it is sampled
// (core/field).
#pragma once

#include "core/dataset/cell_mesh.hpp"
#include "core/dataset/rectilinear_grid.hpp"
#include "core/dataset/uniform_grid.hpp"

#include <cstddef>
#include <variant>

namespace wakesurf::core {

using Grid = std::variant<UniformGrid, RectilinearGrid, CellMesh>;

std::size_t node_count(const Grid& grid);
std::size_t cell_count(const Grid& grid);

/// Returns the position of a node of the values in memory. REQUIRES: node < node_count(grid).
Vec3 node_position(const Grid& grid, std::size_t node);

/// Returns the bytes of its arrays.
std::size_t memory_of(const Grid& grid);

/// Returns the box round all nodes.
Box bounds(const Grid& grid);

/// Finest detail a surface should resolve: the closest nodes on an axis; of a cell mesh the size of its
/// smaller cells (a tenth are smaller: boundary layers have cells much flatter than what surfaces are drawn
/// with).
double finest_spacing(const Grid& grid);

} // namespace wakesurf::core
